"""Units and long names of every variable and coordinate: of datasets, of logs and of batches."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

#: The paper, as cited at the beginning of the attribute `source`.
PAPER = (
    "Lynch and Mason, Pulling by Pushing, Slip with Infinite Friction, and Perfectly Rough Surfaces"
)
#: Global attributes of every file, by the CF conventions.
GLOBAL = {
    "Conventions": "CF-1.11",
    "references": f"{PAPER}, IEEE International Conference on Robotics and Automation, 1993, "
    "https://doi.org/10.1109/ROBOT.1993.292067",
    "license": "MIT",
}

#: Name: (units, long name). "1" is the unit of a ratio, a count, a flag or a label. A variable with
#: components of several units has the name of the coordinate that holds them, from `COMPONENT_UNITS`.
Quantities = dict[str, tuple[str, str]]

#: Labels of the components of a twist.
TWIST = ("v_x", "v_y", "omega")
#: Units of these components, in the coordinate `twist_unit`: in results of the mechanics, and in a log.
TWIST_UNITS = ("motion", "motion", "radian motion/length")
LOG_TWIST_UNITS = ("length/time", "length/time", "radian/time")
#: Units of a variable with components: of a twist, or of a matrix that maps wrenches to twists.
COMPONENT_UNITS = ("twist_unit", "twist_unit/wrench_unit")

#: Variables of a dataset.
DATASET: Quantities = {
    "adhesive": ("1", "whether the fence pulls on the slider"),
    "case": ("1", "hard case"),
    "center": ("length", "motion center relative to the contact"),
    "bound_end": ("1", "end of the paper's bound: nearer to the ring center, or farther from it"),
    "bound_x": ("length", "end of the paper's bound on the motion center, from the contact, x"),
    "bound_y": ("length", "end of the paper's bound on the motion center, from the contact, y"),
    "center_x": ("length", "motion center relative to the contact, along the fence"),
    "center_y": ("length", "motion center relative to the contact, normal to the fence"),
    "condition": (
        "1",
        "condition number: relative change of the reference per relative change of the inputs",
    ),
    "cone_center": ("length", "motion center relative to the contact, under one effect"),
    "cone_force_angle": (
        "degree",
        "force angle, from the right to the left edge of the friction cone",
    ),
    "cone_motion_angle": ("degree", "angle of the contact motion under one effect, unwrapped"),
    "conservative_cone_left": ("degree", "left edge of the conservative acceleration cone"),
    "conservative_cone_right": ("degree", "right edge of the conservative acceleration cone"),
    "consistent": ("1", "whether there is a solution with this number"),
    "continuum": (
        "1",
        "whether the solution is one of a continuum of motions, such as an end of it",
    ),
    "contact": ("1", "contact law"),
    "contact_motion": ("motion", "motion of the slider at the contact"),
    "effect": ("1", "only effect that resists the motion"),
    "effects": ("1", "effects that resist the motion"),
    "error_bound": ("1", "relative error due to rounding of the inputs: condition times epsilon"),
    "error_ulp": ("1", "error of the result in units in the last place of the reference"),
    "exact_end": ("1", "only effect that resists the motion at this end of the exact set"),
    "exact_x": ("length", "end of the exact set of motion centers, from the contact, x"),
    "exact_y": ("length", "end of the exact set of motion centers, from the contact, y"),
    "exact_cone_left": ("degree", "left edge of the exact acceleration cone"),
    "exact_cone_right": ("degree", "right edge of the exact acceleration cone"),
    "force": ("force", "force of the pusher on the slider"),
    "force_angle": ("degree", "force angle"),
    "force_x": ("force", "force of the pusher along the fence"),
    "force_y": ("force", "force of the pusher normal to the fence"),
    "force_end": ("force", "other end of the range of forces at a pivot; otherwise the force"),
    "friction_angle": ("degree", "angle of friction at the contact; 90 for infinite friction"),
    "friction_coefficient": ("1", "coefficient of friction at the contact"),
    "friction_cone_left": ("degree", "left edge of the friction cone"),
    "friction_cone_right": ("degree", "right edge of the friction cone"),
    "furthest_pull": (
        "degree",
        "pusher angle at which the sticking force is on the right edge of the friction cone",
    ),
    "gyration_radius": ("length", "radius of gyration"),
    "ill_conditioned": ("1", "whether double precision loses six digits with every algorithm"),
    "inertia_share": ("1", "s / (1 + s) with s = m a / W: 0 is friction alone, 1 inertia alone"),
    "law": ("1", "type of the contact law"),
    "line": ("1", "hard place, 1 to 13, in the order of the table of hard places"),
    "limit_force": ("force", "force on the limit curve"),
    "limit_force_left": ("force", "force on the limit curve at the left edge of the friction cone"),
    "limit_force_right": (
        "force",
        "force on the limit curve at the right edge of the friction cone",
    ),
    "mass": ("mass", "mass"),
    "mode": ("1", "contact mode"),
    "modes": ("1", "set of consistent contact modes"),
    "motion_angle": (
        "degree",
        "angle of the contact motion, unwrapped",
    ),
    "motion_cone_left": ("degree", "left edge of the motion cone"),
    "motion_cone_right": ("degree", "right edge of the motion cone"),
    "outcome": ("1", "whether no, one or several solutions are consistent"),
    "pivot": (
        "1",
        "number of the support point about which the slider pivots, -1 without one",
    ),
    "place_force": ("force", "friction of the fraction of the support that the place represents"),
    "place_motion": ("motion", "motion of the slider at the place"),
    "place_position": (
        "length",
        "place that represents a fraction of the support, from the contact",
    ),
    "place_share": ("1", "fraction of the weight that the place represents"),
    "pulls": ("1", "whether the contact can stick while the pusher moves away"),
    "pusher_angle": ("degree", "angle of the pusher motion"),
    "pusher_magnitude": ("motion", "magnitude of the pusher motion"),
    "pusher_motion": ("motion", "motion of the pusher"),
    "quantity": ("1", "computed quantity"),
    "quantity_unit": ("1", "unit of the number"),
    "radius": ("length", "radius of the ring"),
    "reference": (
        "1",
        "certified value, or the known digits of a motion, in the case's unit",
    ),
    "reference_digits": ("1", "number of digits of the reference"),
    "reference_high": ("1", "certified value, first double, in the case's unit"),
    "reference_low": ("1", "certified value, second double, in the case's unit"),
    "reference_route": ("1", "route to the reference: oracle, quadrature or integrator"),
    "result": ("1", "value in double precision, in the case's unit"),
    "ring_center": ("length", "slider's center relative to the contact"),
    "rod_angle": ("degree", "rod angle"),
    "rod_length": ("length", "rod length, from the contact to the slider's center"),
    "scene": ("1", "name of the scene"),
    "slip": ("motion", "motion of the slider over the fence"),
    "slips_while_pushing": ("1", "whether some push makes the contact slip"),
    "solution": ("1", "number of the solution"),
    "solutions": ("1", "number of consistent solutions"),
    "spin_ratio": ("1", "spin ratio R omega / v"),
    "sticking_force_angle": ("degree", "force angle of perfectly rough contact, sticking"),
    "support_angle": ("degree", "angle of a point of the ring, from the ring center"),
    "support_force": ("force/radian", "friction of the support on the ring, per angle of the ring"),
    "support_motion": ("motion", "motion of a point of the ring"),
    "status": ("1", "status of the solutions"),
    "twist": ("twist_unit", "twist of the slider at its center"),
    "twist_component": ("1", "component of the twist"),
    "twist_unit": ("1", "unit of the component of the twist"),
    "weight": ("force", "weight times the coefficient of support friction, W = mu_s m g"),
    "xy": ("1", "along the fence, normal to the fence"),
}
#: Variables of the log of a simulation; a name can have another meaning than in a dataset.
LOG: Quantities = {
    **DATASET,
    "contact_dissipated": ("force length", "energy dissipated at the contact, accumulated"),
    "contact_position": (
        "length",
        "where the contact force acts along the fence, from the fence's point at the contact at time 0",
    ),
    "contact_normal": (
        "degree",
        "direction of the inward normal at the contact in the world, unwrapped",
    ),
    "contact_piece": ("1", "number of the outline's piece at the contact, -1 where there is none"),
    "dissipated": ("force length", "energy dissipated by each effect, accumulated"),
    "effect": ("1", "effect that resists the motion"),
    "evaluations": ("1", "number of evaluations of the motion under each effect, accumulated"),
    "event": ("1", "why the contact mode was chosen again"),
    "flush": ("1", "whether a side of the slider lies on the fence"),
    "pusher": ("length", "displacement of the fence"),
    "force": ("force", "force of the fence on the slider"),
    "gap": ("length", "height of the contact point above the fence"),
    "impulse": (
        "force time",
        "impulse of the fence on the slider in impacts since the instant before",
    ),
    "kinetic_energy": ("force length", "kinetic energy of the slider"),
    "load_work": ("force length", "work of the loads on the slider, accumulated"),
    "object_angle": ("degree", "angle of the object's frame in the world, unwrapped"),
    "object_position": (
        "length",
        "origin of the object's frame in the world, along the world's axes",
    ),
    "pivot": ("1", "number of the support point about which the slider pivots, -1 without one"),
    "position": ("length", "slider's center, from the contact at time 0"),
    "pusher_position": ("length", "position of the pusher in the world, along the world's axes"),
    "rod_angle": ("degree", "rod angle, unwrapped"),
    "slip": ("length", "slip of the contact along the fence, accumulated"),
    "time": ("time", "time"),
    "work": ("force length", "work of the fence on the slider, accumulated"),
}
#: Variables of the log of a simulation with a finger.
FINGER: Quantities = {
    **LOG,
    "adhesive": ("1", "whether the finger pulls on the slider"),
    "contact_position": (
        "length",
        "arc length of the outline, or of a straight side, at the finger, from the contact at time 0",
    ),
    "pusher": ("length", "displacement of the finger"),
    "force": ("force", "force of the finger on the slider"),
    "gap": ("length", "height of the side above the finger, normal to the side"),
    "impulse": (
        "force time",
        "impulse of the finger on the slider in impacts since the instant before",
    ),
    "parted": (
        "1",
        "whether the finger has left the side at its end, which ends the contact permanently",
    ),
    "slip": ("length", "slip of the slider over the finger along the side, accumulated"),
    "work": ("force length", "work of the finger on the slider, accumulated"),
    "xy": ("1", "along the side and normal to it, at time 0"),
}
#: Variables of the log of a simulation with several contacts.
SEVERAL: Quantities = {
    **LOG,
    "contact": ("1", "contact: a pusher or a wall"),
    "contact_normal": ("degree", "direction of the inward normal in the world"),
    "dissipated": ("force length", "energy dissipated by friction with the ground, accumulated"),
    "force": ("force", "force of the pusher or wall on the object, along the world's axes"),
    "gap": ("length", "distance of the object from the pusher or wall"),
    "mode": ("1", "contact mode"),
    "object_twist": (
        "twist_unit",
        "velocity of the origin of the object's frame along the world's axes, and angular velocity",
    ),
    "slip": ("length", "slip of the object over the pusher or along the wall, accumulated"),
    "work": ("force length", "work of the pusher on the object, accumulated"),
}
#: Variables that the log of a simulation with walls holds, too.
WALLS: Quantities = {
    "wall": ("1", "wall"),
    "wall_force": ("force", "force of the wall on the slider"),
    "wall_gap": ("length", "distance of the slider from the wall"),
    "wall_mode": ("1", "contact mode at the wall"),
    "wall_normal": (
        "1",
        "unit normal of the wall toward its free side, along the axes of the force",
    ),
    "wall_point": ("length", "a point of the wall, along the axes of the position"),
    "wall_slip": ("length", "slip of the slider along the wall, accumulated"),
}
#: Variables of a batch of simulations; a name can have another meaning than in a log.
BATCH: Quantities = {
    **LOG,
    "duration": ("time", "time to simulate"),
    "evaluations": ("1", "number of evaluations of the motion"),
    "initial_rod_angle": ("degree", "rod angle at time 0"),
    "mode_changes": ("1", "number of changes of mode"),
    "part": ("1", "fraction of the duration"),
    "piece": ("time", "start time of a piece of the pusher's velocity"),
    "pusher_radius": ("length", "radius of the finger"),
    "parted": FINGER["parted"],
    "rod_angle": DATASET["rod_angle"],
    "solutions": ("1", "number of modes that were consistent when the mode was chosen"),
    "stopped": ("1", "why the motion could not continue; empty if it could"),
    "time": ("time", "time reached; less than the duration if the motion could not continue"),
    "velocity": ("length/time", "velocity of the fence"),
}
#: Variables of a batch of simulations with a finger.
FINGER_BATCH: Quantities = {**BATCH, "contact_position": FINGER["contact_position"]}

#: Variables of the datasets of a study of sliders; a name can have another meaning than for the paper's
#: ring.
SLIDERS: Quantities = {
    **DATASET,
    "center_of_pressure_x": ("length", "center of pressure in the body frame, along the rod"),
    "center_of_pressure_y": ("length", "center of pressure in the body frame, across the rod"),
    "center_x": ("length", "center of rotation in the body frame, along the rod"),
    "center_y": ("length", "center of rotation in the body frame, across the rod"),
    "description": ("1", "the support in the form of scene files, as JSON"),
    "edge": ("1", "edge of the cone"),
    "ellipsoid": (
        "twist_unit/wrench_unit",
        "matrix M of the ellipsoid that replaces the support: wrenches w about the center of pressure with "
        "w . M w = 1 cause motions along M w, per unit weight",
    ),
    "extent": ("length", "largest distance of the support from its center of pressure"),
    "force_x": ("force", "force that sustains the rotation, along the rod"),
    "force_y": ("force", "force that sustains the rotation, across the rod"),
    "inertia_pulling_friction_angle": (
        "degree",
        "smallest angle of friction with which the contact can pull the ring, with inertia alone",
    ),
    "integration_constant": (
        "1",
        "mean distance from the center of pressure divided by the extent: the torque of spinning about it",
    ),
    "mean_distance": ("length", "mean distance of the pressure from the center of rotation"),
    "mean_force_error": ("degree", "mean angle between the ellipsoid's wrench and the support's"),
    "mean_motion_error": ("degree", "mean angle between the ellipsoid's motion and the support's"),
    "motion_angle": ("degree", "angle of the contact motion"),
    "pulling_friction_angle": (
        "degree",
        "smallest angle of friction with which the contact can pull; 90 if it cannot pull",
    ),
    "ring_force": ("force", "force on the limit curve of the ring"),
    "ring_motion_angle": ("degree", "angle of the contact motion of the ring"),
    "ring_pulling_friction_angle": (
        "degree",
        "smallest angle of friction with which the contact can pull the ring",
    ),
    "rod": ("1", "number of the rod"),
    "support": ("1", "support of the slider"),
    "sweep": ("1", "quantity that differs between the rods of a sweep"),
    "torque": ("force length", "torque about the slider's center that sustains the rotation"),
    "width": ("degree", "angle between the edges of the motion cone"),
    "worst_force_error": (
        "degree",
        "largest angle between the ellipsoid's wrench and the support's",
    ),
    "worst_motion_error": (
        "degree",
        "largest angle between the ellipsoid's motion and the support's",
    ),
    "wrench_component": ("1", "component of a wrench"),
    "wrench_unit": ("1", "unit of the component of a wrench per unit weight"),
}

#: Variables in the results of the mechanics for labeled arrays; angles are in radians.
MECHANICS: Quantities = {
    **DATASET,
    **{
        name: ("radian", DATASET[name][1])
        for name in (
            *("motion_angle", "force_angle", "motion_cone_right", "motion_cone_left"),
            *("conservative_cone_right", "conservative_cone_left"),
        )
    },
    "closed": ("1", "whether the edges belong to the cone"),
    "left": ("radian", "left edge of the cone"),
    "right": ("radian", "right edge of the cone"),
    "magnitude": ("force", "magnitude of the force on the limit curve"),
    "flush": ("1", "whether the side of the slider lies on the fence"),
    "force_position": ("length", "where the force crosses the fence, from the origin of the side"),
    "end_forces": ("force", "forces at the ends of the side, by the bounds of their components"),
    "modes": ("1", "mode of each of several contacts"),
    "reason": ("1", "why several contacts have no solution"),
    "forces": ("force", "force of each pusher on the object"),
    "forces_end": ("force", "forces at the other end of the range of the inner force"),
    "inner_force": ("force", "force with which the first and the last contact press on each other"),
    "directions": ("1", "forces of a unit inner force, toward an end without a bound"),
    "contact_motions": ("motion", "motion of the object at each contact"),
    "gap_rates": ("motion", "motion of the object away from each pusher"),
    "condition": ("1", "sum of the magnitudes of the forces relative to the load"),
}

#: Meaning of the units of a dataset.
NOTES = {
    "length": "the unit of the study's radius",
    "force": "the unit of the study's weight; without friction, mass times a unit motion",
    "mass": "the unit of the study's mass",
    "motion": "speed in a quasi-static scene, initial acceleration from rest otherwise",
}
#: Meaning of the units of a dataset of a study of sliders.
SLIDERS_NOTES = {
    "length": "the unit of the study's lengths",
    "force": "the friction of the whole support in a translation",
    "mass": NOTES["mass"],
    "motion": NOTES["motion"],
}
#: Meaning of the units of a log.
LOG_NOTES = {
    "length": "the unit of the scene's lengths",
    "time": "the unit of the simulated duration",
    "force": "the unit of the scene's weight; without friction, mass length / time^2",
    "mass": "the unit of the scene's mass",
}


#: Units that UDUNITS lacks, in readable form; the notes define their scale.
READABLE = {
    "force/radian": "radian-1",
    **dict.fromkeys(("length", "force", "mass", "motion", "time"), "1"),
    **dict.fromkeys(("force length", "force time", "length/time"), "1"),
}


def describe(unit: str, long_name: str) -> dict[str, str]:
    """Attributes of a variable: a UDUNITS unit, the scaled quantity if any, and the long name.

    A variable with components of several units names the coordinate that holds them.
    """
    if unit in COMPONENT_UNITS:
        return {"component_units": unit, "long_name": long_name}
    if unit not in READABLE:
        return {"units": unit, "long_name": long_name}
    return {"units": READABLE[unit], "quantity": unit, "long_name": long_name}


def attributes(quantities: Quantities, name: str) -> dict[str, str]:
    """Attributes of a variable of a table, as in `describe`."""
    return describe(*quantities[name])


def unit_of(attrs: Mapping[str, Any]) -> str:
    """Unit of a variable in readable form: the quantity if its numbers are scaled."""
    names = ("quantity", "units", "component_units")
    return next((str(attrs[name]) for name in names if name in attrs), "1")


def stop_text(log: Any) -> str:
    """Sentence on the time and reason of an early stop; empty for a run that ended as planned."""
    if not (reason := log.attrs.get("stopped")):
        return ""
    unit = unit_of(log["time"].attrs)
    time = f"{float(log.attrs['stopped_time']):.6g}"
    return f"stopped at t = {time if unit in ('1', 'time') else f'{time} {unit}'}: {reason}"
