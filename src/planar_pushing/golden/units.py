"""Units and long names of the golden variables, coordinates included."""

from __future__ import annotations

#: Name: (units, long name); "1" is the unit of ratios, counts, flags and labels.
UNITS: dict[str, tuple[str, str]] = {
    "center_x": ("length", "motion centre relative to the ring centre, along the fence"),
    "center_y": ("length", "motion centre relative to the ring centre, normal to the fence"),
    "conservative_cone_left": ("degree", "left edge of the conservative acceleration cone"),
    "conservative_cone_right": ("degree", "right edge of the conservative acceleration cone"),
    "consistent": ("1", "number of consistent solutions in the mode"),
    "contact": ("1", "contact law"),
    "effects": ("1", "effects that resist the motion"),
    "exact_cone_left": ("degree", "left edge of the exact acceleration cone"),
    "exact_cone_right": ("degree", "right edge of the exact acceleration cone"),
    "force": ("force", "force of the pusher on the slider"),
    "force_angle": ("degree", "force angle"),
    "force_angle_fast": ("degree", "force angle of the mode's fastest motion"),
    "force_x": ("force", "force of the pusher along the fence"),
    "force_y": ("force", "force of the pusher normal to the fence"),
    "friction_coefficient": ("1", "coefficient of friction at the contact"),
    "friction_cone_left": ("degree", "left edge of the friction cone"),
    "friction_cone_right": ("degree", "right edge of the friction cone"),
    "inertia_share": ("1", "s / (1 + s) with s = m a / W: 0 is friction alone, 1 inertia alone"),
    "law": ("1", "type of the contact law"),
    "limit_force_left": ("force", "force on the limit curve at the left edge of the friction cone"),
    "limit_force_right": (
        "force",
        "force on the limit curve at the right edge of the friction cone",
    ),
    "mode": ("1", "contact mode"),
    "motion_angle": ("degree", "angle of the contact motion"),
    "motion_cone_left": ("degree", "left edge of the motion cone"),
    "motion_cone_right": ("degree", "right edge of the motion cone"),
    "outcome": ("1", "number of consistent solutions: none, one, several"),
    "pulls": ("1", "whether the contact can stick while the pusher moves away"),
    "pusher_angle": ("degree", "angle of the pusher motion"),
    "pusher_magnitude": ("motion", "magnitude of the pusher motion"),
    "rod_angle": ("degree", "rod angle"),
    "rod_length": ("length", "rod length, from the contact to the ring centre"),
    "slips_while_pushing": ("1", "whether some push makes the contact slip"),
    "spin_ratio": ("1", "spin ratio R omega / v"),
    "spin_ratio_fast": ("1", "spin ratio of the mode's fastest motion"),
}
