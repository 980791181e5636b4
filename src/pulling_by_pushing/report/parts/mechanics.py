"""The numbers of the parts on mechanics, by section of the paper."""

from __future__ import annotations

import math

from planar_pushing.mechanics.contact import Outcome
from pulling_by_pushing.report.derived import (
    ROD_ANGLE,
    bound_reach,
    conservative_excess,
    ellipse_deviation,
    motion_direction,
    outcomes,
    pull_end,
    pushes,
    slip_share,
    solutions,
    sticking_pulls,
)
from pulling_by_pushing.report.quantities import Numbers, Quantity, compute_number, pick
from pulling_by_pushing.report.results import BOTH, FRICTION, INERTIA

#: A contact law for which slow pulling is possible but fast pulling is not.
SLOW = "coulomb_1.4"


def _location(effects: str, rod_length: float) -> dict[str, float | str]:
    return {"effects": effects, "rod_length": rod_length, "rod_angle": ROD_ANGLE}


def _cone(prefix: str, effects: str, rod_length: float, mu: float) -> Numbers:
    """Both edges of a motion cone."""
    location = _location(effects, rod_length) | {"friction_coefficient": mu}
    return {
        f"{prefix}-{side}": pick("motion_cones", f"motion_cone_{side}", location)
        for side in ("right", "left")
    }


def _force(effects: str, rod_length: float, force_angle: float, digits: int = 4) -> Quantity:
    """Magnitude of a force on a limit curve."""
    location = _location(effects, rod_length) | {"force_angle": force_angle}
    return pick("limit_curves", "force", location, digits=digits, unit="force")


def _scene(number: str, prefix: str, digits: int = 0) -> Numbers:
    """Rod length and pusher angle of a figure's scene, with the given number of digits of the angle."""
    name = f"scenes/figure_{number}"
    return {
        f"{prefix}-rod-length": pick(name, "rod_length", digits=0, unit="length"),
        f"{prefix}-pusher-angle": pick(name, "pusher_angle", digits=digits),
    }


def _spin_ratio(number: str) -> Quantity:
    """Spin ratio of the sticking solution, the second one, of a pulling scene."""
    name = f"scenes/figure_{number}"
    return pick(name, "spin_ratio", {"solution": 1}, digits=3, unit="1")


def _map(prefix: str, rod_length: float, friction: float) -> Numbers:
    """Rod length and friction coefficient of a mapped cone."""
    return {
        f"{prefix}-rod-length": _axis("motion_cones", "rod_length", rod_length, unit="length"),
        f"{prefix}-friction": _axis("motion_cones", "friction_coefficient", friction),
    }


def _furthest_pull(magnitude: float) -> Quantity:
    """Smallest pusher angle at which the contact can stick, with both effects."""
    location: dict[str, float | str] = {"effects": BOTH, "contact": SLOW, "rod_length": 2.0}
    return pick("mode_maps", "furthest_pull", location | {"pusher_magnitude": magnitude}, digits=1)


def _axis(dataset: str, axis: str, value: float, digits: int = 0, unit: str = "1") -> Quantity:
    """A value on an axis."""
    return pick(dataset, axis, {axis: value}, digits=digits, unit=unit)


def _bounds() -> Numbers:
    """Edges of the exact and the conservative acceleration cones, and their differences."""
    location = {"rod_length": 5.0}
    edges = {
        f"{kind}-cone-{side}": pick("acceleration_centers", f"{kind}_cone_{side}", location)
        for kind in ("exact", "conservative")
        for side in ("right", "left")
    }
    excess = {
        f"excess-{side}": compute_number(
            "acceleration_centers", conservative_excess, side, digits=2, unit="degree"
        )
        for side in ("right", "left")
    }
    return edges | excess


SETTING: Numbers = {
    "rod-angle": pick("scenes/figure_03", "rod_angle", digits=0),
}

QUASI_STATIC: Numbers = {
    **_scene("02", "pushing", digits=1),
    **_scene("03", "pulling", digits=1),
    "pulling-solutions": compute_number("scenes/figure_03", solutions),
    "pulling-spin-ratio": _spin_ratio("03"),
    "limit-rod-length": _axis("limit_curves", "rod_length", 2.0),
    "long-rod-length": _axis("limit_curves", "rod_length", 10.0),
    "force-across-rod": _force(FRICTION, 2.0, ROD_ANGLE + 90),
    "force-across-long-rod": _force(FRICTION, 10.0, ROD_ANGLE + 90),
    "ellipse-deviation": compute_number("curves", ellipse_deviation, 2.0, digits=1, unit="percent"),
    "ellipse-deviation-long-rod": compute_number(
        "curves", ellipse_deviation, 10.0, digits=1, unit="percent"
    ),
    **_map("cone", 2.0, 2.0),
    **_cone("velocity-cone", FRICTION, 2.0, 2.0),
}

INFINITE_FRICTION: Numbers = {
    **_cone("infinite-cone", FRICTION, 5.0, math.inf),
    **_scene("08", "slip"),
    "slip-motion-angle": compute_number(
        "scenes/figure_08", motion_direction, digits=1, unit="degree"
    ),
    "slip-share": compute_number("scenes/figure_08", slip_share, unit="percent"),
}

DYNAMIC: Numbers = {
    **_cone("acceleration-cone", INERTIA, 2.0, 2.0),
    **_cone("infinite-acceleration-cone", INERTIA, 2.0, math.inf),
    **_scene("09a", "dynamic-pulling"),
    **_scene("09b", "dynamic-slip"),
    **_map("ellipse", 1.0, 5.0),
    **_cone("ellipse-cone", INERTIA, 1.0, 5.0),
    "ellipse-minor-axis": _force(INERTIA, 1.0, ROD_ANGLE + 90),
}

BOTH_EFFECTS: Numbers = {
    **_scene("11", "both-pulling", digits=1),
    "both-pulling-spin-ratio": _spin_ratio("11"),
    **_scene("12", "both-slip"),
    **_bounds(),
    "bound-reach": compute_number("acceleration_centers", bound_reach, digits=2, unit="length"),
}

OVER_TIME: Numbers = {
    "pull-end-time": compute_number("simulations/pulling", pull_end, "time", digits=3, unit="time"),
    "pull-end-rod-angle": compute_number(
        "simulations/pulling", pull_end, "rod_angle", digits=2, unit="degree"
    ),
}

MODES: Numbers = {
    "pushes": compute_number("contact_modes", pushes),
    "unique-pushes": compute_number("contact_modes", outcomes, Outcome.UNIQUE),
    "ambiguous-pushes": compute_number("contact_modes", outcomes, Outcome.AMBIGUOUS),
    "inconsistent-pushes": compute_number("contact_modes", outcomes, Outcome.INCONSISTENT),
    "sticking-pulls": compute_number("contact_modes", sticking_pulls),
    "mode-rod-length": _axis("contact_modes", "rod_length", 2.0),
    "first-without-solution": pick(
        "motion_cones",
        "motion_cone_left",
        _location(FRICTION, 2.0) | {"friction_coefficient": math.inf},
        digits=1,
    ),
    "slow-friction": pick(
        "contact_modes", "friction_coefficient", {"contact": SLOW}, digits=1, unit="1"
    ),
    "slow-magnitude": _axis("contact_modes", "pusher_magnitude", 0.1, digits=1),
    "slow-pull": _furthest_pull(0.1),
    "fast-magnitude": _axis("contact_modes", "pusher_magnitude", 10.0),
    "fast-pull": _furthest_pull(10.0),
}
