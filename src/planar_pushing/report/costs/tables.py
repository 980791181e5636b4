"""CSV tables on accuracy, hard cases and effects."""

from __future__ import annotations

import re

import numpy as np
import xarray as xr

from planar_pushing.evidence.writing import csv_text
from planar_pushing.report.costs.numbers import FEW_ULP, ill, method, part, well
from planar_pushing.report.quantities import significant
from planar_pushing.report.results import EFFECTS, FRICTION, INERTIA, Results

#: A spin ratio this close to one is written as one plus or minus a difference.
CLOSE = 0.01
#: Names of the kinds of hard cases, by number.
PLACES = {
    1: "center on the ring",
    2: "translation and rotation",
    3: "lengths and proportions",
    4: "friction none to infinite",
    5: "slow and fast",
    6: "at rest",
    7: "slips that merge (Painlev\u00e9)",
}
#: Names of the motions whose evaluations are counted, by integrator.
COUNTED = {"event-driven": "motion by events", "time-stepping": "motion by steps"}
#: Names of the timed computations, by scene and operation.
COMPUTED = {
    ("one slider", "motion_cone"): "motion cone",
    ("one slider", "limit_curve"): "limit curve",
    ("one slider", "solve"): "one push",
    ("grid", "limit_curves"): "grid, curves",
    ("grid", "motion_cones"): "grid, cones",
    ("grid", "contact_modes"): "grid, pushes",
}


def spin_ratio_text(value: float) -> str:
    """Shortest text of a spin ratio: a power of ten, or its difference from one if that is small."""
    if abs(np.log10(value)) > 4:
        return f"{value:.0e}"
    apart = value - 1
    if 0 < abs(apart) < CLOSE:
        return f"1 {'+' if apart > 0 else '-'} {abs(apart):.0e}"
    return f"{value:.10g}"


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


def wrench_text(results: Results) -> str:
    """Table of the methods for the wrench, at the setting with the smallest worst-case error."""
    wrench = results.dataset("accuracy_errors/wrench")
    rows = []
    for name in _methods(wrench):
        one = method(wrench, name)
        best = one.isel(point=int(one.error.max("spin_ratio").values.argmin()))
        place = int(best.error.values.argmax())
        evaluations = int(best.evaluations.values.max())
        rows.append(
            {
                "method": name,
                "setting": _setting(float(best.setting)),
                "calls": str(evaluations) if evaluations else "\u2013",
                "worst error": _error(float(best.error[place])),
                "at k": spin_ratio_text(float(best.spin_ratio[place])),
            }
        )
    return csv_text(rows)


def cone_text(results: Results) -> str:
    """Table of the methods for motion cones, at their most accurate setting."""
    cone = results.dataset("accuracy_errors/cone")
    rows = []
    for name in _methods(cone):
        best = method(cone, name).isel(point=-1)
        evaluations = float(best.evaluations)
        rows.append(
            {
                "method": name,
                "setting": _setting(float(best.setting)),
                "calls": f"{evaluations:.0f}" if evaluations else "\u2013",
                "error, degrees": _error(float(best.cone_error)),
            }
        )
    return csv_text(rows)


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
    found = re.sub(r"\d+(?:\.\d+)?(?:e[+-]\d+)?", lambda each: _short(float(each[0])), name)
    return found.replace(" . ", " \u00b7 ")


def _short(value: float) -> str:
    whole = value == int(value)
    return f"{value:,.0f}".replace(",", "\u2009") if whole else f"{value:.4g}"


def ill_text(results: Results) -> str:
    """Table of the ill-conditioned cases, with the digits that survive rounding of the inputs."""
    cases = ill(results.dataset("hard_cases"))
    found = zip(
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
            for name, condition, bound, error in found
        ]
    )


def evaluations_text(results: Results) -> str:
    """Table of evaluations in simulations, by listed effects."""
    counts = results.dataset("evaluations").evaluations
    rows = []
    for integrator, name in COUNTED.items():
        row = {"evaluations": name}
        for effects in EFFECTS:
            for effect in (FRICTION, INERTIA):
                at = {"integrator": integrator, "effects": effects, "effect": effect}
                row[f"{effects}: {effect}"] = str(int(counts.sel(at)))
        rows.append(row)
    return csv_text(rows)


#: The tables by file name.
COST_TABLES = {
    "accuracy_wrench": wrench_text,
    "accuracy_cone": cone_text,
    "hard_places": places_text,
    "hard_ill": ill_text,
    "evaluations": evaluations_text,
}
