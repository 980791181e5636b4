"""Units and long names of the variables of datasets on costs, and on what leaving out an effect changes."""

from __future__ import annotations

from planar_pushing.terms.quantities import DATASET, Quantities

#: Variables of the datasets on the cost of accuracy and of effects; a name can have another meaning than in
#: the others.
COSTS: Quantities = {
    "cone_error": ("degree", "largest error of an edge of a motion cone"),
    "cone_call_seconds": ("s", "time of a call for both edges of one motion cone, each repeat"),
    "cone_seconds": (
        "s",
        "time for both edges of a motion cone in an array, each repeat; NaN for a method without arrays",
    ),
    "counted": ("1", "evaluated function: integrand, wrench in closed form, motion, or nothing"),
    "effect": ("1", "effect that is counted"),
    "effects": DATASET["effects"],
    "evaluations": ("1", "number of evaluations for one result, on average over the cones' edges"),
    "integrator": ("1", "method of integration over time"),
    "method": ("1", "method"),
    "motion_error": ("degree", "error of the rod angle at the end of a run"),
    "log_seconds": ("s", "time of a call for a run without duration, each repeat"),
    "motion_call_seconds": ("s", "time of a call for one run, each repeat"),
    "motion_seconds": (
        "s",
        "time for a run in a batch of equal runs, each repeat; NaN for a method without batches",
    ),
    "repeat": ("1", "number of the repeat"),
    "scene": ("1", "scene of a motion over time"),
    "setting": ("1", "number of points or steps, or tolerance; 0 for none"),
    "spin_ratio": DATASET["spin_ratio"],
    "wrench_error": (
        "1",
        "larger relative error of force and torque; inf where a component is NaN",
    ),
    "wrench_call_seconds": ("s", "time of a call for one wrench, each repeat"),
    "wrench_seconds": (
        "s",
        "time for one wrench in an array, each repeat; NaN for a method without arrays",
    ),
}
#: The same for the dataset `effects`, which counts in a run.
EFFECT_COSTS: Quantities = {
    **COSTS,
    "evaluations": ("1", "number of evaluations of the motion under the effect in a run"),
}

#: Variables of the datasets on what leaving out an effect changes, in SI units.
MODELS: Quantities = {
    "coasting_error": (
        "m",
        "largest displacement of the box from a run without inertia, in a push through the center by a "
        "finger that stops after the distance",
    ),
    "distance": ("m", "distance over which the finger moves"),
    "effect": ("1", "effect that is left out, beside friction"),
    "estimate": ("m", "estimate of the error from the run without the effect, S + D"),
    "evaluations": (
        "1",
        "number of evaluations of the motion in the run with friction and inertia",
    ),
    "evaluations_alone": ("1", "number of evaluations of the motion in the run without the effect"),
    "force_share": (
        "1",
        "force of the effect divided by that of friction, at most this in 95 percent of the run",
    ),
    "friction_coefficient": DATASET["friction_coefficient"],
    "gravity": ("m s-2", "gravity"),
    "is_at_corner": ("1", "whether a fence pushes a corner, and not a finger a side"),
    "left_out": ("1", "effect that is left out, of friction and inertia"),
    "length": ("m", "length of the pushed side of the box"),
    "mass": ("kg", "mass of the box"),
    "place": ("m", "contact on the pushed side, from its middle"),
    "pose_error": (
        "m",
        "largest displacement of a corner of the box, over all times, from the run with the effect",
    ),
    "push": ("1", "number of the push"),
    "pusher_angle": DATASET["pusher_angle"],
    "speed": ("m s-1", "speed of the pusher"),
    "stopping_length": ("m", "stopping length S, the part of the estimate that inertia alone has"),
    "support": ("1", "support of the box"),
    "support_friction_coefficient": ("1", "coefficient of friction between the box and the table"),
    "torque_share": (
        "1",
        "torque of the effect divided by that of friction, at most this in 95 percent of the run",
    ),
    "width": ("m", "length of the other side of the box"),
}
