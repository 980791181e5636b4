"""Figures that the paper does not have: of its subjects, of accuracy and of cost."""

from __future__ import annotations

from planar_pushing.study.figures.base import PAGE_WIDTH, Figure, by_name

#: Figures of the paper's subjects.
SUBJECTS = by_name(
    Figure(
        name="figure_13",
        drawing="figures.paper.figure_13",
        datasets=("motion_cones",),
        size=(PAGE_WIDTH, 3.6),
        takes=("rod_length", "pusher_magnitude"),
        section="Ours, contact modes",
        caption=(
            "Consistent contact modes over the coefficient of friction (linear in its angle) "
            "and the angle of the fence's motion. The strips on the right are infinite "
            "friction without tangential force at zero normal force (the second definition) "
            "and perfectly rough contact. The line is where sticking ends. With one effect it "
            "passes through the edges of the motion cones (dots); with both the cone covers all "
            "magnitudes of the motion, and the map is drawn for one."
        ),
    ),
    Figure(
        name="figure_14",
        drawing="figures.paper.figure_14",
        datasets=("simulations/figure_14a", "simulations/figure_14b"),
        size=(PAGE_WIDTH, 2.6),
        section="Ours, motion over time",
        caption=(
            "Pulling over time. The fence first pushes, then its direction turns away from the "
            "slider: where the contact is kept the slider is pulled along and turns on, where "
            "it is lost the slider stays behind. Slider and fence at some instants, the paths "
            "of the contact and of the motion centre, and over time the rod angle, the gap at "
            "the contact and the contact mode. The path of the motion centre (dashed) is drawn "
            "inside the picture, without its jumps; an arrowhead tells where it leaves. A tick "
            "marks the point of the fence that the contact touched first."
        ),
    ),
    Figure(
        name="figure_15",
        drawing="figures.paper.figure_15",
        datasets=("simulations/figure_15",),
        size=(PAGE_WIDTH, 2.9),
        section="Ours, motion over time",
        caption=(
            "Slip with infinite friction over time. The force stays along the fence, so that "
            "the ring's centre keeps its height; the rod leans more and more and the contact "
            "slips to the right. Slider and fence at some instants, the paths of the contact "
            "and of the motion centre, and over time the rod angle, the accumulated slip and "
            "the contact mode."
        ),
    ),
)

#: Figures about how this work computes, in the order of the report.
OURS = by_name(
    Figure(
        name="accuracy_evaluations",
        drawing="figures.evidence.accuracy_evaluations",
        datasets=("accuracy_errors/wrench",),
        size=(PAGE_WIDTH, 2.7),
        caption=(
            "Error of the friction wrench against evaluations of the integrand, at four spin "
            "ratios k, a marker for each setting of a method. Formulas evaluate no integrand "
            "and stand in the grey strip; an error of zero and a result of NaN stand at the ends of the "
            "axis. Dotted: rounding of a double."
        ),
    ),
    Figure(
        name="accuracy_time",
        drawing="figures.evidence.accuracy_time",
        datasets=("accuracy_time",),
        size=(PAGE_WIDTH, 2.7),
        caption=(
            "Error of the friction wrench against the time that one wrench takes, for the methods, "
            "settings and spin ratios of the previous figure. A marker stands at the least time of "
            "repeated runs, and a hair leads to their median; methods that take arrays are timed on "
            "arrays. Other machines, and other runs, give other times. Dotted: rounding of a double."
        ),
    ),
    Figure(
        name="hard_cases",
        drawing="figures.evidence.hard_cases",
        datasets=("hard_cases",),
        size=(PAGE_WIDTH, 3.1),
        caption=(
            "Error of each hard case in units in the last place, from best to worst condition "
            "within a group, beside the error that half a unit in the inputs causes."
        ),
    ),
)

#: Figures of times, measured on one machine, in the order of the supplement; it holds their captions.
SUPPLEMENT = by_name(
    *(
        Figure(
            name=name,
            drawing=f"figures.evidence.{name}",
            datasets=(dataset,),
            size=(PAGE_WIDTH, height),
        )
        for name, dataset, height in (
            ("accuracy_wrench", "accuracy/wrench", 7.4),
            ("accuracy_cone", "accuracy/cone", 3.7),
            ("accuracy_motion", "accuracy/motion", 3.3),
            ("effects", "effects", 3.0),
        )
    )
)
