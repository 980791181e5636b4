"""Figures 16 to 20: any slider."""

from __future__ import annotations

from planar_pushing.study.figures.base import PAGE_WIDTH, Figure, by_name

SECTION = "Ours, any slider"

GALLERY = by_name(
    Figure(
        name="figure_16",
        drawing="figures.sliders.figure_16",
        datasets=("supports",),
        size=(PAGE_WIDTH, 5.25),
        section=SECTION,
        caption=(
            "Limit curves of a gallery of supports (solid), each beside that of a ring of the same "
            "size (dashed): the forces through the contact under which the slider moves. The slider "
            "with its rod is drawn in the corner, as it lies above the fence. A support of points "
            "has flats (thick): every force of a flat turns the slider about the same point, and "
            "moves the contact alike."
        ),
    ),
    Figure(
        name="figure_17",
        drawing="figures.sliders.figure_17",
        datasets=("supports",),
        size=(PAGE_WIDTH, 4.6),
        section=SECTION,
        caption=(
            "How much friction pulling takes: the smallest coefficient of friction at the contact "
            "with which it can stick while the pusher moves away, linear in its angle, over the "
            "length and over the angle of the rod, for supports on areas (above) and on points and "
            "lines (below). Where a curve reaches infinity the slider can never be pulled: about an "
            "upright rod no support is that mirrors itself in it. The curve of the quadruped jumps "
            "where a foot stands straight above the contact, and that of the tripod at the upright "
            "rod alone: there the motion along the fence is a pivot."
        ),
    ),
    Figure(
        name="figure_18",
        drawing="figures.sliders.figure_18",
        datasets=("supports", "support_cones"),
        size=(PAGE_WIDTH, 4.6),
        section=SECTION,
        caption=(
            "Slip with infinite friction: the part of all pushes into the slider that slip, over the "
            "length and over the angle of the rod. The motion cone is a half plane for every support; "
            "the fraction of pushes that slip equals its tilt from the friction cone. Dots are the "
            "cones of the study's grid."
        ),
    ),
    Figure(
        name="figure_19",
        drawing="figures.sliders.figure_19",
        datasets=("simulations/tripod",),
        size=(PAGE_WIDTH, 3.4),
        section=SECTION,
        caption=(
            "A tripod that pivots. The fence moves up, the contact slips, and the motion centre "
            "(dashed) moves until it meets a foot, where it stays. Right: limit curves at the start "
            "and at the end, with the friction cone (shaded), the forces at its edges and the motions "
            "that they cause. At the end both edges lie on the flat of one foot, and the motion cone "
            "is a single direction. Feet and flats are numbered alike."
        ),
    ),
    Figure(
        name="figure_20",
        drawing="figures.sliders.figure_20",
        datasets=("supports",),
        size=(PAGE_WIDTH, 2.9),
        section=SECTION,
        caption=(
            "What the ellipsoid in a support's place costs: the integration constant that fits it to "
            "the support's torque of spinning, and the angles between its forces and the support's "
            "for the same motion, and between its motions and the support's under the same force, "
            "as means over motions spread evenly and as maxima over all motions."
        ),
    ),
)
