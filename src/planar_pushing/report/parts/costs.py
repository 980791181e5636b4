"""The numbers of the parts on accuracy, hard cases and effects; those of `TIMES` vary from run to run."""

from __future__ import annotations

import numpy as np

from planar_pushing.report.costs import numbers as costs
from planar_pushing.report.costs import times
from planar_pushing.report.quantities import Numbers, Quantity, computed, magnitude, picked

WRENCH, CONE = "accuracy_errors/wrench", "accuracy_errors/cone"
TIME, HARD, COUNTS = "accuracy_time", "hard_cases", "evaluations"
#: Spin ratios in the prose: near a translation, near the ring, on the ring, and near a pure rotation.
NEAR, SPIN = 1 - 1e-9, 1e8


def _percent(name: str, digits: int = 0) -> Quantity:
    return computed(WRENCH, costs.worst_error_in, 0.01, name, digits=digits, unit="percent")


def _ulp(name: str) -> Quantity:
    return computed(WRENCH, costs.worst_error_in, costs.EPS, name, digits=1, unit="epsilon")


ACCURACY: Numbers = {
    "spin-ratios": computed(WRENCH, costs.spin_ratios),
    "closed-form-error": _ulp("closed form"),
    "hypergeometric-error": _ulp("hyp2f1"),
    "carlson-error": _ulp("Carlson"),
    "trapezoid-evaluations": computed(WRENCH, costs.last_evaluations, "trapezoid", 1.0),
    "trapezoid-error": magnitude(WRENCH, costs.last_error, "trapezoid", 1.0),
    "quad-evaluations-near": computed(WRENCH, costs.last_evaluations, "quad", NEAR),
    "quad-evaluations-on": computed(WRENCH, costs.last_evaluations, "quad", 1.0),
    "quad-error-spin": magnitude(WRENCH, costs.last_error, "quad", SPIN),
    "ellipsoid-error": _percent("ellipsoid"),
    "quartic-error": _percent("convex quartic", 1),
    "cone-error": magnitude(CONE, costs.cone_error, "closed form", unit="degree"),
    "brentq-evaluations": computed(CONE, costs.cone_evaluations, "brentq on quad"),
    "root-evaluations": computed(CONE, costs.cone_evaluations, "find_root"),
    "ellipsoid-cone-error": computed(CONE, costs.cone_error, "ellipsoid", digits=1, unit="degree"),
    "quartic-cone-error": computed(
        CONE, costs.cone_error, "convex quartic", digits=2, unit="degree"
    ),
    "rim-ellipsoid": picked(CONE, "rim_error", {"model": "ellipsoid"}),
    "rim-quartic": picked(CONE, "rim_error", {"model": "quartic"}),
}

TIMES: Numbers = {
    "time-processor": Quantity(
        read=lambda results: times.processor(results.dataset(TIME)),
        digits=0,
        unit="name",
        source=f"{TIME}: processor in the attribute machine",
    ),
    **times.time_range(TIME, "closed-form-time", "closed form"),
    **times.time_range(TIME, "quad-time", "quad", times.MICRO, "us"),
    "quad-time-ratio": computed(TIME, times.wrench_ratio, "quad"),
    "trapezoid-time": computed(
        TIME, times.wrench_time_at, "trapezoid", 1.0, times.MILLI, digits=1, unit="ms"
    ),
}

HARD_CASES: Numbers = {
    "hard-cases": computed(HARD, costs.hard_cases),
    "hard-well": computed(HARD, costs.well_cases),
    "hard-ill": computed(HARD, costs.ill_cases),
    "hard-accurate": computed(HARD, costs.accurate_cases),
    "hard-largest": computed(HARD, costs.largest_error),
    "hard-largest-condition": computed(HARD, costs.condition_there),
    "hard-largest-elsewhere": computed(HARD, costs.largest_error_elsewhere, digits=1),
    "hard-share": computed(HARD, costs.largest_share, digits=1),
    "hard-limit": magnitude(HARD, costs.ill_from, digits=0),
    "hard-least-condition": magnitude(HARD, costs.condition_of_ill, np.min),
    "hard-most-condition": magnitude(HARD, costs.condition_of_ill, np.max),
}

EFFECTS: Numbers = {
    "effects-single": computed(COUNTS, costs.single_runs),
    "effects-listed": computed(COUNTS, costs.listed),
    "effects-absent": computed(COUNTS, costs.absent),
}
