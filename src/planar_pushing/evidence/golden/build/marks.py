"""Units, flags and provenance of golden data, stated apart from those of the results."""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

from flint import __FLINT_VERSION__ as FLINT_VERSION

from planar_pushing.certified.balls import PRECISION

MODES = "SEPARATE STICK SLIP_RIGHT SLIP_LEFT"
#: What flags mean, in the order of their values.
FLAGS = {
    "outcome": "INCONSISTENT UNIQUE AMBIGUOUS",
    "mode": MODES,
    "modes": MODES,
    "path_mode": f"NONE {MODES}",
}
#: A name that ends in one of these words is an angle, unless a list below has it.
DEGREES = ("angle", "right", "left", "start", "stop")
RATIOS = {
    *("edge", "ellipsoid", "integration_constant", "pivot", "spin", "support", "wrench_component"),
    *(
        "adhesive",
        "bound_end",
        "consistent",
        "exact_end",
        "contact",
        "effect",
        "effects",
        "friction_coefficient",
    ),
    *("inertia_share", "law", "mode", "modes", "outcome", "panel", "pulls", "sector_outside"),
    *("slips_while_pushing", "spin_ratio", "spin_ratio_fast", "twist_component", "xy"),
    *("path_mode", "path_spin_ratio", "policy"),
}
LENGTHS = {
    *("center_of_pressure_x", "center_of_pressure_y", "extent", "mean_distance"),
    *("center", "center_left", "center_right", "center_x", "center_y", "cone_center"),
    *("bound_x", "bound_y", "exact_x", "exact_y"),
    *("exact_center_x", "exact_center_y", "mapped_rod_length", "radius", "ring_center"),
    *("path_center", "path_fence", "path_gap", "path_position", "path_slip", "rod_length"),
}
FORCES = {
    *("force", "force_x", "force_y", "infinite_rod_x", "infinite_rod_y", "mapped_force_x"),
    *("limit_force_left", "limit_force_right", "mapped_force_y", "parallel_force", "path_force"),
}
#: Angles that no word above ends, and composed units.
COMPOSED = {
    "force_angle_end": "degree",
    "support_force": "force/radian",
    "torque": "force length",
    "width": "degree",
}
#: Units that UDUNITS does not read, and what stands for them.
SCALED = {"force/radian": "radian-1"} | dict.fromkeys(
    ("length", "force", "force length", "motion", "time"), "1"
)
MOTIONS = {"contact_motion", "pusher_magnitude", "pusher_motion", "slip", "support_motion", "twist"}


def unit_of(name: str) -> str:
    """Unit of a golden variable or coordinate."""
    if name == "time":
        return name
    for unit, names in (("1", RATIOS), ("length", LENGTHS), ("force", FORCES), ("motion", MOTIONS)):
        if name in names:
            return unit
    if name in COMPOSED:
        return COMPOSED[name]
    if name.removesuffix("_fast").rpartition("_")[2] in DEGREES:
        return "degree"
    raise KeyError(name)


def marks(name: str) -> dict[str, str]:
    """Attributes of a variable, or of the low part or the radius of one."""
    base = name.removesuffix("_low").removesuffix("_radius")
    flags = {"flag_meanings": FLAGS[name]} if name in FLAGS else {}
    unit = unit_of(base)
    scaled = {"quantity": unit} if unit in SCALED else {}
    return {"units": SCALED.get(unit, unit), **scaled, **flags}


def provenance(title: str) -> dict[str, Any]:
    """Attributes of a golden file."""
    return {
        "title": f"{title}, certified",
        "method": "Arb elliptic integrals; roots enclosed by a change of sign between balls",
        "precision_bits": PRECISION,
        "python_flint": version("python-flint"),
        "flint": FLINT_VERSION,
    }
