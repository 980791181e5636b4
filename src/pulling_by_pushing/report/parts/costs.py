"""The numbers of the part on what accuracy costs; those that are times vary from run to run."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pulling_by_pushing.report.costs import models
from pulling_by_pushing.report.costs import numbers as costs
from pulling_by_pushing.report.quantities import (
    Numbers,
    Quantity,
    check_number,
    compute_number,
    magnitude,
)

WRENCH, CONE, MOTION = (f"accuracy/{name}" for name in ("wrench", "cone", "motion"))
WRENCH_TIME, CONE_TIME, MOTION_TIME = (
    f"accuracy_time/{name}" for name in ("wrench", "cone", "motion")
)
HARD, COUNTS = "hard_cases", "effects"
ERRORS, ESTIMATES = "model_errors", "model_estimates"
NANO, MICRO, MILLI = 1e9, 1e6, 1e3
#: Settings of the motions in the prose: a tolerance, and a number of steps.
RUNS = {"event-driven": 1e-10, "time-stepping": 1000.0}
#: Their kinds of times: event-driven runs are timed in batches, of which time stepping has none.
TIMED = {"event-driven": costs.ARRAY, "time-stepping": costs.CALL}


def _ulp(name: str) -> Quantity:
    return compute_number(WRENCH, costs.worst_error_in, costs.EPS, name, digits=1, unit="epsilon")


def _times(prefix: str, compute: Callable[..., float], name: str, per: float, unit: str) -> Numbers:
    """Smallest and largest time of a method for the wrench over the spin ratios."""
    ends = {"least": np.min, "most": np.max}
    return {
        f"{prefix}-time-{end}": compute_number(WRENCH_TIME, compute, name, which, per, unit=unit)
        for end, which in ends.items()
    }


ACCURACY: Numbers = {
    "spin-ratios": compute_number(WRENCH, costs.spin_ratios),
    "closed-form-error": _ulp("closed form"),
    "hypergeometric-error": _ulp("hyp2f1"),
    "carlson-error": _ulp("Carlson"),
    "trapezoid-error": magnitude(WRENCH, costs.error_at, "trapezoid", 1.0),
    "cone-error": magnitude(CONE, costs.error, "closed form", unit="degree"),
    "ellipsoid-limit": check_number(
        "motion-of-the-ellipsoid", "ellipsoid-turns-motion", digits=1, unit="degree"
    ),
    **{
        f"{name}-error": magnitude(MOTION, costs.slip, "motion_error", name, setting, unit="degree")
        for name, setting in RUNS.items()
    },
}

TIMES: Numbers = {
    "time-processor": Quantity(
        read=lambda results: costs.processor(results.dataset(WRENCH_TIME)),
        digits=0,
        unit="name",
        source=f"{WRENCH_TIME}: processor in the attribute machine",
    ),
    **_times("closed-form", costs.time, "closed form", NANO, "ns"),
    **_times("quad", costs.call_time, "quad", MICRO, "us"),
    "closed-form-call-time": compute_number(
        WRENCH_TIME, costs.call_time, "closed form", np.max, MICRO, unit="us"
    ),
    "trapezoid-time": compute_number(
        WRENCH_TIME, costs.time_at, "trapezoid", 1.0, MILLI, digits=1, unit="ms"
    ),
    "cone-time": compute_number(
        CONE_TIME, costs.time, "closed form", np.min, MICRO, digits=1, unit="us"
    ),
    "cone-call-time": compute_number(
        CONE_TIME, costs.call_time, "closed form", np.min, MICRO, unit="us"
    ),
    "brentq-time-ratio": compute_number(CONE_TIME, costs.time_ratio, "brentq on quad"),
    **{
        f"{name}-time": compute_number(
            MOTION_TIME, costs.slip, f"motion{kind}", name, RUNS[name], MILLI, digits=1, unit="ms"
        )
        for name, kind in TIMED.items()
    },
    "tolerance-time-ratio": compute_number(MOTION_TIME, costs.tolerance_ratio, digits=1),
    "log-time": compute_number(MOTION_TIME, costs.log_time, MILLI, digits=1, unit="ms"),
}

HARD_CASES: Numbers = {
    "hard-cases": compute_number(HARD, costs.hard_cases),
    "hard-well": compute_number(HARD, costs.well_cases),
    "hard-ill": compute_number(HARD, costs.ill_cases),
    "hard-accurate": compute_number(HARD, costs.accurate_cases),
    "hard-largest": compute_number(HARD, costs.largest_error),
    "hard-largest-condition": compute_number(HARD, costs.condition_there),
    "hard-largest-elsewhere": compute_number(HARD, costs.largest_error_elsewhere, digits=1),
    "hard-motions": compute_number(HARD, costs.motions),
    "hard-motion": magnitude(HARD, costs.largest_error_of_motions),
    "hard-digits": compute_number(HARD, costs.fewest_digits),
    "hard-tolerance": magnitude(HARD, costs.tolerance, digits=0),
    "hard-thin": magnitude(HARD, costs.largest_error_of_thin),
    "hard-share": compute_number(HARD, costs.largest_share, digits=1),
    "hard-limit": magnitude(HARD, costs.ill_from, digits=0),
}

EFFECTS: Numbers = {
    "effects-single": compute_number(COUNTS, costs.single_runs),
    "effects-listed": compute_number(COUNTS, costs.count_listed),
    "effects-absent": compute_number(COUNTS, costs.count_absent),
}

#: What leaving out an effect changes in a push.
MODELS: Numbers = {
    "slow-speed": compute_number(ERRORS, models.speed_in_centimeters, 0.05, unit="cm/s"),
    "fast-speed": compute_number(ERRORS, models.speed_in_centimeters, 0.2, unit="cm/s"),
    "small-error": compute_number(ERRORS, models.small_error, unit="mm"),
    "slow-error": magnitude(ERRORS, models.first_error, "base", 0.05, unit="mm"),
    "fast-error": magnitude(ERRORS, models.first_error, "base", 0.2, unit="mm"),
    "disc-speed": magnitude(ERRORS, models.crossing, "disc", "inertia", unit="m/s", digits=0),
    "feet-speed": magnitude(ERRORS, models.crossing, "feet", "inertia", unit="m/s"),
    "frictionless-speed": magnitude(
        ERRORS, models.crossing, "base", "friction", unit="m/s", digits=0
    ),
    "slowest-speed": compute_number(ERRORS, models.slowest, unit="mm/s"),
    "slowest-evaluations": magnitude(ERRORS, models.evaluations_ratio, digits=0),
    "estimates": compute_number(ESTIMATES, models.random_pushes),
    "estimates-largest": compute_number(ESTIMATES, models.largest_ratio, digits=1),
    "estimates-settled": compute_number(ESTIMATES, models.percentage_settled, unit="percent"),
    "estimates-missed": compute_number(ESTIMATES, models.count_missed),
}
