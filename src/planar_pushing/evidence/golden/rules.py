"""The one table of rules: how every variable of every dataset is verified."""

from __future__ import annotations

from enum import StrEnum

from planar_pushing.evidence.golden.residual import (
    acceleration_centers,
    center_regions,
    contact_modes,
    limit_curves,
    motion_cones,
    scenes,
    simulations,
    sliders,
)
from planar_pushing.evidence.golden.residual.finding import Residuals


class Rule(StrEnum):
    """How values are verified."""

    #: By an interval that is proved to hold the true value: the golden sample.
    ENCLOSURE = "enclosure"
    #: By the equation that every value solves, in numbers of 32 digits, or in balls.
    RESIDUAL = "residual"
    #: By equality with what the study says: labels, coordinates, parameters, flags, attributes.
    EXACT = "exact"
    #: By computing the whole dataset anew from others that are verified, or from certified numbers.
    DERIVED = "derived"


#: What puts the values of a dataset into their equations.
RESIDUALS: dict[str, Residuals] = {
    "limit_curves": limit_curves.residuals,
    "motion_cones": motion_cones.residuals,
    "contact_modes": contact_modes.residuals,
    "acceleration_centers": acceleration_centers.residuals,
    "center_regions": center_regions.residuals,
    "scenes": scenes.residuals,
    "simulations": simulations.residuals,
    "supports": sliders.supports.residuals,
    "support_cones": sliders.cones.residuals,
    "support_modes": sliders.modes.residuals,
}


def _by(rule: Rule, names: str) -> dict[str, Rule]:
    return dict.fromkeys(names.split(), rule)


#: The rule of each variable; coordinates and attributes are compared exactly.
RULES: dict[str, dict[str, Rule]] = {
    "limit_curves": _by(Rule.RESIDUAL, "force force_x force_y spin_ratio motion_angle"),
    "motion_cones": _by(
        Rule.RESIDUAL,
        "friction_cone_right friction_cone_left motion_cone_right motion_cone_left "
        "limit_force_right limit_force_left pulls slips_while_pushing",
    ),
    "contact_modes": _by(
        Rule.RESIDUAL,
        "consistent outcome spin_ratio force_angle spin_ratio_fast force_angle_fast",
    ),
    "acceleration_centers": _by(
        Rule.RESIDUAL,
        "center_x center_y motion_angle exact_cone_right exact_cone_left "
        "conservative_cone_right conservative_cone_left",
    ),
    "center_regions": _by(Rule.RESIDUAL, "bound_x bound_y exact_x exact_y"),
    "scenes": _by(Rule.EXACT, "rod_length rod_angle radius pusher_magnitude mode outcome adhesive")
    | _by(
        Rule.RESIDUAL,
        "ring_center pusher_angle pusher_motion friction_cone_right friction_cone_left "
        "motion_cone_right motion_cone_left cone_force_angle cone_motion_angle cone_center force "
        "contact_motion slip twist spin_ratio center support_motion support_force",
    ),
    "simulations": _by(Rule.EXACT, "mode outcome solutions adhesive pivot event evaluations")
    | _by(
        Rule.RESIDUAL,
        "position rod_angle twist fence slip gap force spin_ratio dissipated contact_dissipated work "
        "kinetic_energy",
    ),
    "supports": _by(
        Rule.RESIDUAL,
        "mean_distance force_x force_y torque center_of_pressure_x center_of_pressure_y extent "
        "integration_constant ellipsoid worst_force_error mean_force_error worst_motion_error "
        "mean_motion_error",
    ),
    "support_cones": _by(Rule.RESIDUAL, "motion_angle pivot width pulls slips_while_pushing"),
    "support_modes": _by(
        Rule.RESIDUAL, "consistent force_angle force_angle_end motion_angle spin pivot outcome"
    ),
}
