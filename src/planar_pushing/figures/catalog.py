"""The figures: what each is drawn from, and its caption; read without importing matplotlib."""

from __future__ import annotations

#: Name of the figure's module: datasets as `open_dataset` names them.
FIGURES: dict[str, tuple[str, ...]] = {
    "figure_01": ("motion_cones",),
    "figure_02": ("scenes/figure_02",),
    "figure_03": ("scenes/figure_03",),
    "figure_04": ("scenes/figure_02",),
    "figure_05": ("limit_curves",),
    "figure_06": ("limit_curves", "motion_cones"),
    "figure_07": ("motion_cones",),
    "figure_08": ("scenes/figure_08",),
    "figure_09": ("scenes/figure_09a", "scenes/figure_09b"),
    "figure_10": ("limit_curves", "motion_cones"),
    "figure_11": ("scenes/figure_11",),
    "figure_12": ("acceleration_centers", "scenes/figure_12"),
    "figure_13": ("contact_modes", "motion_cones"),
    "figure_14": ("simulations/figure_14a", "simulations/figure_14b"),
    "figure_15": ("simulations/figure_15",),
}

#: Our captions.
CAPTIONS: dict[str, str] = {
    "figure_01": (
        "The pushing problem: a fence pushes a ring of unit radius at the free end of its "
        "rod. Filled arrowheads are forces, open ones are velocities and accelerations; angles "
        "are measured from the fence."
    ),
    "figure_02": (
        "Quasi-static pushing. The support friction of a slider that turns about the "
        "velocity centre, drawn along the ring, balances the force f of the pusher; the "
        "pusher moves into the slider."
    ),
    "figure_03": (
        "Quasi-static pulling. The force f passes close by the ring centre on its other "
        "side: the contact sticks although the pusher moves away from the slider."
    ),
    "figure_04": (
        "Coordinates: x-y on the pusher, x'-y' on the ring centre with y' along the force "
        "f. The velocity centre lies on the x' axis."
    ),
    "figure_05": (
        "Limit curves for several rod lengths l, in units of the ring's radius: the forces "
        "through the contact under which the slider moves quasi-statically. Without a rod "
        "the curve is a circle, for an infinite rod a segment along it. Open arrows are the"
        " contact's velocities, normal to the curve; at the four force angles drawn they "
        "are parallel to the force."
    ),
    "figure_06": (
        "From the friction cone through the limit curve to the velocity cone. Each force "
        "inside the friction cone is a point of the limit curve, and the normal there is "
        "the contact's velocity; the cone's edges map to the edges of the velocity cone, "
        "whose right edge points away from the slider: pulling."
    ),
    "figure_07": (
        "Velocity cones for infinite friction and several rod lengths. Each spans half "
        "a turn and leans away from the friction cone (the half plane above the fence): "
        "below the fence on its right side the fence pulls, above the fence on its left "
        "side the contact slips."
    ),
    "figure_08": (
        "Slip with infinite friction. The pusher velocity lies to the left of the shaded "
        "velocity cone, so the slider slips to the right: f and the slider velocity lie on "
        "the left edges of their cones."
    ),
    "figure_09": (
        "Acceleration cones. The edges of the friction cone have the acceleration centres "
        "c_r and c_l as their force duals; between them the friction cone allows the solid "
        "part of the line of centres, with rotation to the left (+) or to the right (-)."
    ),
    "figure_10": (
        "Without support friction ellipses take the limit curves' place; their major axis "
        "lies along the rod. On the ellipse of one of the rod lengths the forces of a "
        "friction cone are drawn with the accelerations that they cause, normal to the "
        "ellipse; these sweep the acceleration cone."
    ),
    "figure_11": (
        "Pulling from rest, with support friction and inertia. About an acceleration centre"
        " on the ring both resist along one line, tangent to the ring opposite to the "
        "centre, whatever their magnitudes."
    ),
    "figure_12": (
        "Slip with infinite friction, support friction and inertia. Possible acceleration "
        "centres and accelerations of the contact: the paper's bound from the geometry of "
        "the line of force (light), and the exact set (dark), which narrows to a point "
        "where the line of force touches the ring. A fence that accelerates in a "
        "direction between the cone and the fence's left end makes the contact slip, whatever its "
        "magnitude."
    ),
    "figure_13": (
        "Consistent contact modes over the coefficient of friction (linear in its angle) "
        "and the angle of the fence's motion. The strips on the right are infinite friction"
        " without tangential force at zero normal force (the second definition) and perfectly rough "
        "contact. Dots are edges of the motion cones; with both effects the cone covers all"
        " magnitudes of the motion, the map is drawn for one."
    ),
    "figure_14": (
        "Pulling over time. The fence first pushes, then its direction turns away from the slider: "
        "where the contact is kept the slider is pulled along and turns on, where it is lost the slider "
        "stays behind. Slider and fence at some instants, the paths of the contact and of the motion "
        "centre, and over time the rod angle, the gap at the contact and the contact mode, hatched where "
        "several are consistent. A tick marks the point of the fence that the contact touched first."
    ),
    "figure_15": (
        "Slip with infinite friction over time. The force stays along the fence, so that the ring's "
        "centre keeps its height; the rod leans more and more and the contact slips to the right. "
        "Slider and fence at some instants, the paths of the contact and of the motion centre, and over "
        "time the rod angle, the accumulated slip and the contact mode."
    ),
}

#: What the paper's caption promises, in our words; empty for a figure of ours.
PROMISES: dict[str, str] = {
    "figure_01": "an example of the pushing problem.",
    "figure_02": "quasi-static pushing.",
    "figure_03": "quasi-static pulling.",
    "figure_04": "the conventions for the coordinates.",
    "figure_05": "limit curves for rods of different lengths.",
    "figure_06": (
        "how the friction cone of μ = 2 maps to a velocity cone through the limit curve of l = 2."
    ),
    "figure_07": "velocity cones of infinite friction.",
    "figure_08": "slip with infinite friction for l = 5.",
    "figure_09": "acceleration cones for l = 2 with (a) μ = 2 and (b) μ = ∞.",
    "figure_10": (
        "the ellipses that govern the map from force to acceleration in the pure dynamic case, for"
        " four rod lengths, and how a friction cone maps to an acceleration cone for l = 1."
    ),
    "figure_11": "an example of pulling with support friction and inertia, l = 5.",
    "figure_12": "slip with infinite friction under support friction and inertia, l = 5.",
    "figure_13": "",
    "figure_14": "",
    "figure_15": "",
}

#: Figures about how this work computes, in the order of the report, and their captions.
OURS: dict[str, str] = {
    "accuracy_evaluations": (
        "Error of the friction wrench against evaluations of the integrand, at four spin ratios k, a "
        "marker for each setting of a method. Formulas evaluate no integrand and stand in the grey "
        "strip. Dotted: rounding of a double."
    ),
    "hard_cases": (
        "Error of each hard case in units in the last place, from best to worst condition within a "
        "group, beside the error that half a unit in the inputs causes."
    ),
}

_STATICS = "Sec. 3: quasi-static pushing and pulling"
_DYNAMICS = "Sec. 4: dynamic pushing and pulling"

#: Section of the paper in which a figure stands.
SECTIONS: dict[str, str] = {
    **dict.fromkeys(("figure_01", "figure_02", "figure_03", "figure_04", "figure_05"), _STATICS),
    "figure_06": "Sec. 3.1: friction cones and velocity cones",
    **dict.fromkeys(("figure_07", "figure_08"), "Sec. 3.2: slip with infinite friction"),
    **dict.fromkeys(("figure_09", "figure_10", "figure_11", "figure_12"), _DYNAMICS),
    "figure_13": "Ours, contact modes",
    **dict.fromkeys(("figure_14", "figure_15"), "Ours, motion over time"),
}
