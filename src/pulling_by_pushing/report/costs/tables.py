"""CSV tables on accuracy, hard cases and effects."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np
import xarray as xr

from pulling_by_pushing.evidence.writing import csv_text
from pulling_by_pushing.report.costs.numbers import ARRAY, CALL, FEW_ULP, ill, part, well
from pulling_by_pushing.report.quantities import significant
from pulling_by_pushing.report.results import EFFECTS, FRICTION, INERTIA, Results

#: Names of the kinds of hard cases, by number.
PLACES = {
    1: "center on the ring",
    2: "translation and rotation",
    3: "lengths and proportions",
    4: "friction none to infinite",
    5: "slow and fast",
    6: "at rest",
    7: "slips that merge (Painlev\u00e9)",
    8: "feet",
    9: "edges of plates",
    10: "rims",
    11: "segments",
    12: "thin plates and annuli",
    13: "motions over time",
}
#: What the methods compute: the groups of the dataset.
QUANTITIES = ("wrench", "cone", "motion")
#: Names of the motions whose evaluations are counted, by integrator.
COUNTED = {"event-driven": "motion by events", "time-stepping": "motion by steps"}
#: Names of the sets of effects that a scene lists.
LISTED = dict(zip(EFFECTS, ("friction", "inertia", "both"), strict=True))
#: Units of times, from large to small.
TIMES = {"s": 1.0, "ms": 1e-3, "\u00b5s": 1e-6, "ns": 1e-9}


def _methods(data: xr.Dataset) -> list[str]:
    return list(dict.fromkeys(map(str, data.method.values)))


def _setting(value: float) -> str:
    """Text of a method's setting: empty, a count, or a tolerance."""
    if value == 0:
        return "\u2013"
    return f"{value:.0f}" if value >= 1 else f"{value:.0e}"


def _error(value: float) -> str:
    return significant(value) if np.isfinite(value) else "NaN"


def _ulp(value: float) -> str:
    return f"{value:.1f}" if value < 100 else f"{value:.0f}"


def time_text(value: float) -> str:
    """Time in seconds as text, with two significant digits and a unit; a dash for none."""
    if np.isnan(value):
        return "\u2013"
    unit = next((name for name, size in TIMES.items() if value >= size), "ns")
    return f"{significant(value / TIMES[unit])} {unit}"


def accuracy_text(results: Results) -> str:
    """Table of the methods, each at the setting with the smallest worst-case error."""
    return csv_text([row for name in QUANTITIES for row in _accuracy_rows(results, name)])


def _accuracy_rows(results: Results, name: str) -> Iterator[dict[str, str]]:
    """Rows of the methods for a quantity; errors, evaluations and times are the largest over the cases."""
    data = results.dataset(f"accuracy/{name}")
    times = results.dataset(f"accuracy_time/{name}").min("repeat")
    error, evaluations, in_array, in_call = (
        column.values.reshape(data.sizes["point"], -1).max(axis=1)
        for column in (
            *(data[f"{name}_error"], data.evaluations),
            *(times[f"{name}{kind}"] for kind in (ARRAY, CALL)),
        )
    )
    for chosen in _methods(data):
        rows = np.flatnonzero(data.method.values == chosen)
        row = int(rows[np.argmin(error[rows])])
        yield {
            "computed": name,
            "method": chosen,
            "setting": _setting(float(data.setting[row])),
            "calls": f"{evaluations[row]:.0f}" if evaluations[row] else "\u2013",
            "error": _error(float(error[row])),
            "time in an array": time_text(float(in_array[row])),
            "time of a call": time_text(float(in_call[row])),
        }


def places_text(results: Results) -> str:
    """Table of the hard cases by kind; errors are those of the well-conditioned cases only."""
    cases = results.dataset("hard_cases")
    rows = []
    for line, name in PLACES.items():
        some = part(cases, "case", cases.line.values == line)
        fine = well(some)
        rows.append(
            {
                "place": name,
                "cases": str(some.sizes["case"]),
                "ill": str(some.sizes["case"] - fine.sizes["case"]),
                f"over {FEW_ULP} ulp": str(int((fine.error_ulp > FEW_ULP).sum())),
                "largest": _ulp(float(fine.error_ulp.max())),
            }
        )
    return csv_text(rows)


def case_text(name: str) -> str:
    """Name of a case for prose: four significant digits, with thousands separators."""
    text = re.sub(r"\d+(?:\.\d+)?(?:e[+-]\d+)?", lambda number: _short_text(float(number[0])), name)
    return text.replace(" . ", " \u00b7 ")


def _short_text(value: float) -> str:
    integral = value == int(value)
    return f"{value:,.0f}".replace(",", "\u2009") if integral else f"{value:.4g}"


def ill_text(results: Results) -> str:
    """Table of the ill-conditioned cases, with the digits that survive rounding of the inputs."""
    cases = ill(results.dataset("hard_cases"))
    columns = zip(
        cases.case.values.tolist(),
        cases.condition.values.tolist(),
        cases.error_bound.values.tolist(),
        cases.error_ulp.values.tolist(),
        strict=True,
    )
    return csv_text(
        [
            {
                "case": case_text(name),
                "condition": significant(condition),
                "digits": f"{max(0.0, -np.log10(bound)):.0f}",
                "error, ulp": significant(error),
            }
            for name, condition, bound, error in columns
        ]
    )


def effects_text(results: Results) -> str:
    """Table of evaluations in simulations, by listed effects."""
    data = results.dataset("effects")
    counts = {
        f"{name}, evaluations of {LISTED[effect]}": [
            str(int(data.evaluations.sel(integrator=method, effect=effect, effects=effects)))
            for effects in EFFECTS
        ]
        for method, name in COUNTED.items()
        for effect in (FRICTION, INERTIA)
    }
    return csv_text(
        [
            {"computed": name} | dict(zip(LISTED.values(), row, strict=True))
            for name, row in counts.items()
        ]
    )


#: The tables by file name.
COST_TABLES = {
    "accuracy": accuracy_text,
    "hard_places": places_text,
    "hard_ill": ill_text,
    "effects": effects_text,
}
