"""Numbers and tables of the supplement on time; they depend on the machine."""

from __future__ import annotations

import numpy as np
import xarray as xr

from planar_pushing.evidence.writing import csv_text, json_text
from planar_pushing.report.costs import times
from planar_pushing.report.costs.tables import COMPUTED
from planar_pushing.report.quantities import Numbers, computed, magnitude
from planar_pushing.report.results import EFFECTS, Results
from planar_pushing.terms.errors import InvalidFile

WRENCH, CONE, MOTION = (f"accuracy/{each}" for each in ("wrench", "cone", "motion"))
MILLI = times.MILLI
#: Settings in the prose: a tolerance, and a number of steps.
RUNS = {"event-driven": 1e-10, "time-stepping": 1000.0}
#: Computations for the scene of a figure, the same as those for one slider.
ASKED = {name: asked for (scene, name), asked in COMPUTED.items() if scene == "one slider"}


NUMBERS: Numbers = {
    **times.time_range(WRENCH, "closed-form", "closed form"),
    **times.time_range(WRENCH, "hypergeometric", "hyp2f1"),
    **times.time_range(WRENCH, "carlson", "Carlson"),
    **times.time_range(WRENCH, "quad", "quad", times.MICRO, "us"),
    "cone-time": computed(CONE, times.cone_time, "closed form", digits=2, unit="us"),
    "brentq-ratio": computed(CONE, times.cone_ratio, "brentq on quad"),
    "root-ratio": computed(CONE, times.cone_ratio, "find_root"),
    "table-ratio": computed(CONE, times.cone_ratio, "linear table", digits=2),
    "quartic-ratio": computed(CONE, times.cone_ratio, "convex quartic", digits=2),
    **{
        f"{method}-time": computed(MOTION, times.run_time, method, setting, digits=1, unit="ms")
        for method, setting in RUNS.items()
    },
    **{
        f"{method}-error": magnitude(MOTION, times.run_error, method, setting, unit="degree")
        for method, setting in RUNS.items()
    },
    "both-solve-ratio": computed("effects", times.both_ratio, "solve", digits=1),
    "both-cone-ratio": computed("effects", times.both_ratio, "motion_cone", digits=1),
    "supports": computed("effects", times.most_supports),
    "supports-ratio": computed("effects", times.divided_ratio, digits=1),
}


def numbers_text(results: Results) -> str:
    """Table of the numbers of the supplement's prose."""
    return json_text({key: quantity.entry(results) for key, quantity in NUMBERS.items()})


def _time(data: xr.Dataset, **where: str) -> str:
    """Minimum time of the case with these labels, milliseconds."""
    holds = [data[label].values == value for label, value in where.items()]
    (case,) = np.flatnonzero(np.all(holds, axis=0))
    least = MILLI * float(data.time[case].min())
    return f"{least:.{max(0, 2 - int(np.floor(np.log10(least))))}f}"


def effects_text(results: Results) -> str:
    """Table of times for one slider and for the grid by effects, milliseconds."""
    data = results.dataset("effects")
    return csv_text(
        [
            {"computed": name}
            | {
                effects: _time(data, scene=scene, operation=operation, effects=effects)
                for effects in EFFECTS
            }
            for (scene, operation), name in COMPUTED.items()
        ]
    )


def scenes_text(results: Results) -> str:
    """Table of times for the scenes of the figures, milliseconds."""
    data = results.dataset("effects")
    found = dict(zip(data.scene.values.tolist(), data.effects.values.tolist(), strict=True))
    return csv_text(
        [
            {"scene": scene.replace("_", " "), "effects": effects.replace("_", " ")}
            | {asked: _time(data, scene=scene, operation=name) for name, asked in ASKED.items()}
            for scene, effects in found.items()
            if scene.startswith("figure_")
        ]
    )


def machine_text(results: Results) -> str:
    """Table of the machine.

    Raises
    ------
    InvalidFile
        If the two measurements were made on different machines or versions.
    """
    first, second = (times.machine(results.dataset(name)) for name in (WRENCH, "effects"))
    if first != second:
        raise InvalidFile(
            f"{results.folder}/data: accuracy.nc and effects.nc come from different machines or versions; "
            "repeat the measurement with snakemake accuracy --forcerun accuracy_data effects_data"
        )
    return csv_text([{"what": what, "value": value} for what, value in first.items()])


#: The supplement's files in results/tables, by name.
TABLES = {
    "accuracy_numbers.json": numbers_text,
    "times_effects.csv": effects_text,
    "times_scenes.csv": scenes_text,
    "times_machine.csv": machine_text,
}
