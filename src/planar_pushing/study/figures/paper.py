"""Figures 1 to 12: those of the paper."""

from __future__ import annotations

from planar_pushing.study.figures.base import COLUMN_WIDTH, PAGE_WIDTH, Figure, by_name

FRICTION, INERTIA, BOTH = "support_friction", "inertia", "support_friction+inertia"
STATICS = "Sec. 3: quasi-static pushing and pulling"
DYNAMICS = "Sec. 4: dynamic pushing and pulling"

PAPER = by_name(
    Figure(
        name="figure_01",
        drawing="figures.paper.figure_01",
        datasets=("motion_cones",),
        size=(COLUMN_WIDTH, 2.45),
        takes=("rod_length", "friction_coefficient"),
        needs=FRICTION,
        section=STATICS,
        caption=(
            "The pushing problem: a fence pushes a ring of unit radius at the free end of its "
            "rod. Filled arrowheads are forces, open ones are velocities and accelerations; "
            "angles are measured from the fence."
        ),
        promise="an example of the pushing problem.",
    ),
    Figure(
        name="figure_02",
        drawing="figures.paper.scenes:quasi_static",
        datasets=("scenes/figure_02",),
        size=(COLUMN_WIDTH, 2.8),
        needs=FRICTION,
        section=STATICS,
        caption=(
            "Quasi-static pushing. The support friction of a slider that turns about the "
            "velocity centre, drawn along the ring, balances the force f of the pusher; the "
            "pusher moves into the slider."
        ),
        promise="quasi-static pushing.",
    ),
    Figure(
        name="figure_03",
        drawing="figures.paper.scenes:quasi_static",
        datasets=("scenes/figure_03",),
        size=(COLUMN_WIDTH, 3.1),
        needs=FRICTION,
        section=STATICS,
        caption=(
            "Quasi-static pulling. The force f passes the ring centre on its other "
            "side: the contact sticks although the pusher moves away from the slider."
        ),
        promise="quasi-static pulling.",
    ),
    Figure(
        name="figure_04",
        drawing="figures.paper.figure_04",
        datasets=("scenes/figure_02",),
        size=(COLUMN_WIDTH, 3.0),
        needs=FRICTION,
        section=STATICS,
        caption=(
            "Coordinates: x-y on the pusher, x'-y' on the ring centre with y' along the force "
            "f. The velocity centre lies on the x' axis."
        ),
        promise="the conventions for the coordinates.",
    ),
    Figure(
        name="figure_05",
        drawing="figures.paper.figure_05",
        datasets=("limit_curves",),
        size=(COLUMN_WIDTH, 3.4),
        takes=("rod_length",),
        needs=FRICTION,
        section=STATICS,
        caption=(
            "Limit curves for several rod lengths l, in units of the ring's radius: the forces "
            "through the contact under which the slider moves quasi-statically. Without a rod "
            "the curve is a circle, for an infinite rod a segment along it. Open arrows are "
            "the contact's velocities, normal to the curve; at the four force angles drawn "
            "they are parallel to the force."
        ),
        promise="limit curves for rods of different lengths.",
    ),
    Figure(
        name="figure_06",
        drawing="figures.paper.figure_06",
        datasets=("motion_cones",),
        size=(PAGE_WIDTH, 2.5),
        takes=("rod_length", "friction_coefficient"),
        needs=FRICTION,
        section="Sec. 3.1: friction cones and velocity cones",
        caption=(
            "From the friction cone through the limit curve to the velocity cone. Each force "
            "inside the friction cone is a point of the limit curve, and the normal there is "
            "the contact's velocity; the cone's edges map to the edges of the velocity cone, "
            "whose right edge points away from the slider: pulling."
        ),
        promise=(
            "how the friction cone of μ = 2 maps to a velocity cone through the limit curve of "
            "l = 2."
        ),
    ),
    Figure(
        name="figure_07",
        drawing="figures.paper.figure_07",
        datasets=("motion_cones",),
        size=(PAGE_WIDTH, 2.0),
        takes=("rod_length",),
        needs=FRICTION,
        section="Sec. 3.2: slip with infinite friction",
        caption=(
            "Velocity cones for infinite friction and several rod lengths. Each spans half a "
            "turn and leans away from the friction cone (the half plane above the fence): "
            "below the fence on its right side the fence pulls, above the fence on its left "
            "side the contact slips. Each picture has a scale of its own; the bars are as long "
            "as the ring's radius."
        ),
        promise="velocity cones of infinite friction.",
    ),
    Figure(
        name="figure_08",
        drawing="figures.paper.scenes:slipping",
        datasets=("scenes/figure_08",),
        size=(COLUMN_WIDTH, 2.8),
        needs=FRICTION,
        section="Sec. 3.2: slip with infinite friction",
        caption=(
            "Slip with infinite friction. The pusher velocity lies to the left of the shaded "
            "velocity cone, so the slider slips to the right: f and the slider velocity lie on "
            "the left edges of their cones."
        ),
        promise="slip with infinite friction for l = 5.",
    ),
    Figure(
        name="figure_09",
        drawing="figures.paper.figure_09",
        datasets=("scenes/figure_09a", "scenes/figure_09b"),
        size=(PAGE_WIDTH, 3.2),
        needs=INERTIA,
        section=DYNAMICS,
        caption=(
            "Acceleration cones. The edges of the friction cone have the acceleration centres "
            "c_r and c_l as their force duals; between them the friction cone allows the solid "
            "part of the line of centres, with rotation to the left (+) or to the right (-)."
        ),
        promise="acceleration cones for l = 2 with (a) μ = 2 and (b) μ = ∞.",
    ),
    Figure(
        name="figure_10",
        drawing="figures.paper.figure_10",
        datasets=("motion_cones",),
        size=(PAGE_WIDTH, 2.5),
        takes=("rod_length", "mapped_rod_length", "friction_coefficient"),
        needs=INERTIA,
        section=DYNAMICS,
        caption=(
            "Without support friction ellipses take the limit curves' place; their major axis "
            "lies along the rod. On the ellipse of one of the rod lengths the forces of a "
            "friction cone are drawn with the accelerations that they cause, normal to the "
            "ellipse; these sweep the acceleration cone."
        ),
        promise=(
            "the ellipses that govern the map from force to acceleration in the pure dynamic "
            "case, for four rod lengths, and how a friction cone maps to an acceleration cone "
            "for l = 1."
        ),
    ),
    Figure(
        name="figure_11",
        drawing="figures.paper.scenes:dynamic",
        datasets=("scenes/figure_11",),
        size=(COLUMN_WIDTH, 3.3),
        needs=BOTH,
        section=DYNAMICS,
        caption=(
            "Pulling from rest, with support friction and inertia. About an acceleration "
            "centre on the ring both resist along one line, tangent to the ring opposite to "
            "the centre, whatever their magnitudes."
        ),
        promise="an example of pulling with support friction and inertia, l = 5.",
    ),
    Figure(
        name="figure_12",
        drawing="figures.paper.figure_12",
        datasets=("acceleration_centers", "scenes/figure_12"),
        size=(PAGE_WIDTH, 3.2),
        takes=("rod_length",),
        needs=BOTH,
        section=DYNAMICS,
        caption=(
            "Slip with infinite friction, support friction and inertia. Possible acceleration "
            "centres and accelerations of the contact: the paper's bound from the geometry of "
            "the line of force (light), and the exact set (dark), which narrows to a point "
            "where the line of force touches the ring. A fence that accelerates in a direction "
            "between the cone and the fence's left end makes the contact slip, whatever its "
            "magnitude."
        ),
        promise="slip with infinite friction under support friction and inertia, l = 5.",
    ),
)
