"""The tables of the report, as files in results/tables."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.evidence.writing import csv_text, json_text, write_text
from pulling_by_pushing.figures.captions import words
from pulling_by_pushing.figures.figure import entry, full_caption, view
from pulling_by_pushing.figures.studies import NUMBERS as FIGURE_NUMBERS
from pulling_by_pushing.figures.studies import OURS, PUSHES, cuts
from pulling_by_pushing.report.costs.numbers import machine, processor
from pulling_by_pushing.report.costs.tables import COST_TABLES
from pulling_by_pushing.report.derived import ROD_ANGLE
from pulling_by_pushing.report.parts import costs, evidence, mechanics, pushes
from pulling_by_pushing.report.quantities import Numbers, decimal_text
from pulling_by_pushing.report.results import FRICTION, INERTIA, SLIDERS, Results, open_once
from pulling_by_pushing.report.verdict import failure_rows, verdict_rows
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE
from pulling_by_pushing.study.study_file import load_study

#: All numbers of the prose; the numbers of a new part must be added here.
NUMBERS: Numbers = {
    **mechanics.SETTING,
    **mechanics.QUASI_STATIC,
    **mechanics.INFINITE_FRICTION,
    **mechanics.DYNAMIC,
    **mechanics.BOTH_EFFECTS,
    **mechanics.MODES,
    **mechanics.OVER_TIME,
    **evidence.ANY_SLIDER,
    **pushes.MEASURED,
    **costs.ACCURACY,
    **costs.TIMES,
    **costs.HARD_CASES,
    **costs.EFFECTS,
    **costs.MODELS,
    **evidence.GOLDEN,
    **evidence.CLAIMS,
}


def numbers(results: Results) -> dict[str, dict[str, str]]:
    """Text, unit and source of every number.

    Raises
    ------
    InvalidFile
        If a file of the results is missing.
    """
    return {key: quantity.entry(results) for key, quantity in NUMBERS.items()}


def numbers_text(results: Results) -> str:
    """Table of the numbers of the prose."""
    return json_text(numbers(results))


def figures_text(results: Results) -> str:
    """Table of the figures: captions, contents according to the paper's captions, files and sections.

    They are in the order of the report. The caption of a figure that shows times ends with the machine.
    """
    entries: dict[str, dict[str, object]] = {}
    for part, file in {"": PAPER_FILE, f"studies/{SLIDERS}/": SLIDERS_FILE}.items():
        study = load_study(file)
        for name in study.figures:
            data = view(name, results.folder / part, cuts(study, name), open_once)
            entries[name] = _figure(name, data, f"{part}figures")
    for name in OURS:
        data = results.pushes if name in PUSHES else view(name, results.folder, read=open_once)
        ours = _figure(name, data, "figures")
        entries[name] = ours | {"caption": f"{ours['caption']}{_machine(data)}"}
    order = [name for name in FIGURE_NUMBERS if name in entries]
    return json_text({name: entries[name] for name in order})


def _figure(name: str, data: Any, folder: str) -> dict[str, object]:
    figure = entry(name)
    return {
        "number": FIGURE_NUMBERS[name],
        "caption": full_caption(name, data),
        "promise": figure.promise,
        "section": figure.section,
        "file": f"{folder}/{name}",
    }


def _machine(data: Mapping[str, Any]) -> str:
    """Sentence that describes the machine on which a dataset of a figure was measured, if any."""
    measured = (dataset for dataset in data.values() if "machine" in getattr(dataset, "attrs", ()))
    dataset = next(measured, None)
    if dataset is None:
        return ""
    known = machine(dataset)
    versions = f"Python {known['python']}, NumPy {known['numpy']}"
    return f" Machine: {processor(dataset)}, number of cores: {known['cores']}, {versions}."


def ellipsoids_text(results: Results) -> str:
    """Table of the ellipsoids that approximate supports: integration constants, and errors in degrees."""
    supports = results.dataset(f"{SLIDERS}/supports")
    rows = []
    for name in supports.support.values:
        one = supports.sel(support=name)
        constant = decimal_text(float(one.integration_constant), 4)
        row = {"support": words(str(name)), "constant": constant}
        for what in ("force", "motion"):
            for size in ("mean", "worst"):
                row[f"{what}, {size}"] = decimal_text(float(one[f"{size}_{what}_error"]), 1)
        rows.append(row)
    return csv_text(rows)


def cones_text(results: Results) -> str:
    """Table of the motion cones of infinite friction by rod length, degrees."""
    cones = results.dataset("motion_cones").sel(friction_coefficient=np.inf, rod_angle=ROD_ANGLE)
    centers = results.dataset("acceleration_centers")
    rows = []
    for length in centers.rod_length.values:
        one, bound = cones.sel(rod_length=length), centers.sel(rod_length=length)
        pairs = {
            "friction": [one.sel(effects=FRICTION)[_edge("motion", s)] for s in SIDES],
            "inertia": [one.sel(effects=INERTIA)[_edge("motion", s)] for s in SIDES],
            "both, exact": [bound[_edge("exact", s)] for s in SIDES],
            "both, bound of the paper": [bound[_edge("conservative", s)] for s in SIDES],
        }
        edges = {
            f"{name}, {side}": decimal_text(float(value), 2)
            for name, pair in pairs.items()
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


#: Texts of the tables by their names.
TABLES = {
    "numbers": numbers_text,
    "figures": figures_text,
    "infinite_friction_cones": cones_text,
    "ellipsoids": ellipsoids_text,
    "golden_summary": verdict_text,
    "golden_failures": failures_text,
    **COST_TABLES,
}


def write_tables(*, results: str, golden: str, **paths: str) -> None:
    """Write the tables of the report, each to the path given under its name."""
    sources = Results(Path(results), Path(golden))
    texts = {name: text(sources) for name, text in TABLES.items()}
    for name, path in paths.items():
        write_text(texts[name], path)
