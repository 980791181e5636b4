"""The tables of the report, as files in results/tables."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.evidence.writing import csv_text, json_text
from pulling_by_pushing.figures.figure import entry, full_caption, select
from pulling_by_pushing.figures.studies import OURS, PUSHES
from pulling_by_pushing.report.costs.numbers import machine, processor
from pulling_by_pushing.report.derived import ROD_ANGLE
from pulling_by_pushing.report.numbers import numbers
from pulling_by_pushing.report.quantities import rounded
from pulling_by_pushing.report.results import FRICTION, INERTIA, SLIDERS, Results
from pulling_by_pushing.report.verdict import failure_rows, verdict_rows
from pulling_by_pushing.study.datasets.base import words
from pulling_by_pushing.study.store import read_dataset
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE
from pulling_by_pushing.study.study_file import load_study


def numbers_text(results: Results) -> str:
    """Table of the numbers of the prose."""
    return json_text(numbers(results))


def figures_text(results: Results) -> str:
    """Table of the figures: captions, contents according to the paper's captions, files and sections.

    Figures about our own computation are numbered after those on the paper's subjects and on any slider.
    The caption of a figure that shows times ends with the machine.
    """
    studies = {"figures": PAPER_FILE, f"studies/{SLIDERS}/figures": SLIDERS_FILE}
    found: dict[str, dict[str, object]] = {}
    for folder, file in studies.items():
        for name in load_study(file).figures:
            data = read_dataset(results.folder / folder / "data" / f"{name}.nc")
            found[name] = _figure(name, data, folder)
    for number, name in enumerate(OURS, len(found) + 1):
        found[name] = _ours(name, results) | {"number": str(number)}
    return json_text(found)


def _ours(name: str, results: Results) -> dict[str, object]:
    """Entry of a figure about the computation itself or about measured pushes."""
    if name in PUSHES:
        return _figure(name, results.pushes, "figures")
    data = select(name, results.folder, None)
    found = _figure(name, data, "figures")
    return found | {"caption": f"{found['caption']}{_machine(data)}"}


def _figure(name: str, data: Any, folder: str) -> dict[str, object]:
    figure = entry(name)
    return {
        "caption": full_caption(name, data),
        "promise": figure.promise,
        "section": figure.section,
        "file": f"{folder}/{name}",
    }


def _machine(data: xr.Dataset) -> str:
    """Sentence that describes the machine on which a figure's dataset was measured, if any."""
    if "machine" not in data.attrs:
        return ""
    found = machine(data)
    versions = f"Python {found['python']}, NumPy {found['numpy']}"
    return f" Machine: {processor(data)}, number of cores: {found['cores']}, {versions}."


def ellipsoids_text(results: Results) -> str:
    """Table of the ellipsoids that approximate supports: integration constants, and errors in degrees."""
    found = results.dataset(f"{SLIDERS}/supports")
    rows = []
    for name in found.support.values:
        one = found.sel(support=name)
        constant = rounded(float(one.integration_constant), 4)
        row = {"support": words(str(name)), "constant": constant}
        for what in ("force", "motion"):
            for size in ("mean", "worst"):
                row[f"{what}, {size}"] = rounded(float(one[f"{size}_{what}_error"]), 1)
        rows.append(row)
    return csv_text(rows)


def cones_text(results: Results) -> str:
    """Table of the motion cones of infinite friction by rod length, degrees."""
    cones = results.dataset("motion_cones").sel(friction_coefficient=np.inf, rod_angle=ROD_ANGLE)
    centers = results.dataset("acceleration_centers")
    rows = []
    for length in centers.rod_length.values:
        one, bound = cones.sel(rod_length=length), centers.sel(rod_length=length)
        found = {
            "friction": [one.sel(effects=FRICTION)[_edge("motion", s)] for s in SIDES],
            "inertia": [one.sel(effects=INERTIA)[_edge("motion", s)] for s in SIDES],
            "both, exact": [bound[_edge("exact", s)] for s in SIDES],
            "both, bound of the paper": [bound[_edge("conservative", s)] for s in SIDES],
        }
        edges = {
            f"{name}, {side}": rounded(float(value), 2)
            for name, pair in found.items()
            for side, value in zip(SIDES, pair, strict=True)
        }
        rows.append({"rod length": f"{length:g}", **edges})
    return csv_text(rows)


SIDES = ("right", "left")
#: Columns of the table of failed comparisons.
FAILURES = ("compared", "differ", "worst difference", "allowed there")


def _edge(kind: str, side: str) -> str:
    return f"{kind}_cone_{side}"


def verdict_text(results: Results) -> str:
    """Table of the golden check by dataset.

    Raises
    ------
    InvalidFile
        If there is no verdict, or it compares no variable.
    """
    rows = verdict_rows(results)
    if not rows:
        raise InvalidFile(
            f"{results.folder}/tables/golden_verdict.json: compares nothing; build it"
        )
    return csv_text(rows)


def failures_text(results: Results) -> str:
    """Table of the failed comparisons; only its header if the golden check passed."""
    return csv_text(failure_rows(results), FAILURES)
