"""A wrong claim comes out as refuted: one wrong number for each kind of claim, and more."""

import math

import pytest

from evidence.claims.ledgers import claim, ledger, verdict_with
from planar_pushing.evidence.claims.proofs.verdicts import Verdict
from planar_pushing.evidence.claims.table import judge
from planar_pushing.terms.errors import InvalidFile

WRONG = [
    # formulas and identities
    ("eq-02-force-integral", {"cross_term": 1}),
    ("eq-03-torque-integral", {"cross_term": -2}),
    ("eq-06-torque-about-contact", {"rod_angle": 30}),
    ("eq-08-acceleration-along-fence", {"mass": 2}),
    ("eq-09-acceleration-across-fence", {"mass": 2}),
    ("gyration-radius-of-the-ring", {"gyration_radius": 0.5}),
    ("eq-10-angular-acceleration", {"gyration_radius": 2}),
    ("eq-11-rod-end-along-fence", {"gyration_radius": 0.5}),
    ("eq-12-rod-end-across-fence", {"gyration_radius": 0.5}),
    ("rod-on-a-wall", {"numerator": 5}),
    # numbers, within their accuracy and exactly
    ("edges-of-figure-6", {"right": -20.03845755}),
    ("edges-of-figure-6", {"left": 140.16416973}),
    ("edges-of-figure-7-long-rod", {"rod_length": 4}),
    ("edges-of-figure-9a", {"friction_coefficient": 2.1}),
    ("friction-threshold", {"threshold": 1.27}),
    ("inertia-threshold", {"threshold": 1.49}),
    ("inertia-threshold", {"threshold": 1.5 + 2**-50}),
    ("condition-13-coefficients", {"tangential": 3}),
    ("centers-of-figure-9", {"distance": 0.4}),
    ("ellipse-of-inertia", {"ratio": 0.4472}),
    ("bound-of-figure-12", {"right": -44}),
    ("bound-of-figure-12-conservative", {"left_gap": 3.2}),
    ("off-ellipse-long-rod", {"part": 0.09}),
    ("normal-motion-dips", {"least": -0.041}),
    ("fact-6-center-on-ring", {"moment_arm": 1.1}),
    ("force-with-center-on-ring", {"force": 0.64}),
    ("exact-cone-of-figure-12", {"right": -45}),
    ("force-at-the-dip", {"force": 1.42}),
    ("force-at-the-return", {"force": 2.21}),
    ("normal-motion-dips", {"friction_coefficient": 2}),
    ("friction-cone-half-angle", {"friction_coefficient": 1}),
    ("slip-without-normal-force", {"force_angle": 179}),
    ("slip-without-normal-force", {"pusher_angle": 100}),
    # inequalities
    ("dynamic-pulling-figure-9a", {"friction_coefficient": 1.4}),
    ("dynamic-slip-figure-9b", {"pusher_angle": 146}),
    ("directions-without-solution", {"pusher_angle": 148.61}),
    ("velocity-cone-of-figure-6", {"friction_coefficient": 1}),
    ("velocity-cone-of-figure-6", {"below": -21}),
    ("eq-13-pulling-condition", {"friction_coefficient": 1.25}),
    ("quasi-static-pulling", {"force_angle": 50}),
    ("pushing-figure-2", {"spin": 1}),
    ("pulling-of-figure-11", {"rod_length": 1.25}),
    ("perfectly-rough-adheres", {"pusher_angle": 90}),
    ("sliding-friction-opposes-slip", {"side": -1}),
    ("slip-of-figure-8", {"pusher_angle": 138}),
    ("slip-at-every-magnitude", {"pusher_angle": 138}),
    # every force angle, every rod length
    ("nonnegative-work", {"above": 1.01}),
    ("motion-turns-with-force", {"above": 1.01}),
    ("short-rod-gives-circle", {"coefficient": 0.99}),
    ("long-rod-gives-segment", {"half_width": 0.0101}),
    ("force-greatest-along-rod", {"force_angle": 46}),
    ("force-greatest-along-rod", {"force": 0.9}),
    ("force-least-across-rod", {"force_angle": 134}),
    ("parallel-only-at-extrema", {"across": 134}),
    ("motion-angle-equals-force-angle", {"along": 44}),
    # contact modes
    ("third-pulling-solution", {"pusher_angle": 10}),
    ("pulling-with-both-is-ambiguous", {"pusher_angle": -60}),
    ("case-4-translation", {"force_angle": 44}),
    ("neither-definition-is-perfectly-rough", {"pusher_angle": 120}),
    ("third-pulling-solution", {"friction_coefficient": 1}),
    ("pushing-is-unique", {"pusher_angle": -20}),
    ("definition-2-figure-8", {"pusher_angle": 90}),
    ("slow-pulling-without-fast", {"above": 1.26}),
    ("slow-pulling-without-fast", {"below": 1.51}),
    ("slow-sticks-fast-slips-off", {"fast": 0.1}),
    ("infinite-velocity-cone-spans-180", {"span": 170}),
    ("infinite-friction-cone", {"left": 170}),
    ("closed-and-open-interval", {"right": 10}),
    # any support
    ("one-pivot-for-many-forces", {"rod_length": 2.1}),
    ("tripod-pivots", {"nearest": 0.268}),
    ("tripod-pivots", {"farthest": 3.73}),
    ("corner-of-a-line", {"distance": 2.1}),
    ("foot-ahead-holds", {"distance": 0.5}),
    ("center-beyond-bound", {"spin_ratio": 900}),
    ("center-beyond-bound", {"spin_ratio": 0.9, "product": 0.5, "within": 1}),
    ("integration-constant-of-strip", {"aspect": 3}),
    ("integration-constant-of-ring", {"hole": 0.9}),
    ("gallery-pulls-and-slips", {"rod_angle": 90}),
    ("l-pulls-along-normal", {"rod_angle": 91}),
    ("curve-of-l-leans", {"turn": 29}),
    ("least-force-of-l", {"rod_length": 0.6}),
]


#: Their numbers say where to evaluate what holds everywhere.
SAMPLES = {"sideways-force", "closed-forms-on-grid", "rotation-sense-as-printed"}
#: Without a rod the cones agree for every coefficient.
SAMPLES |= {"aligned-without-rod"}
#: How many supports and contacts are drawn.
SAMPLES |= {f"{name}-random-supports" for name in
            ("normal-push-on", "slip-outside-cone-on", "cones-of", "centers-of")}  # fmt: skip


def test_every_check_that_reads_numbers_has_a_wrong_one():
    wrong = {claim(name).check for name, _ in WRONG}
    assert {each.check for each in ledger().claims if each.claimed} - wrong == SAMPLES


@pytest.mark.parametrize(("name", "numbers"), WRONG)
def test_wrong_numbers_are_refuted(name, numbers):
    found = verdict_with(name, **numbers)
    assert found.verdict is Verdict.REFUTED
    assert found.reason


def test_a_right_rotation_sense_would_be_noticed():
    """The one refuted statement of the paper is so by a margin, not by default."""
    found = judge(claim("rotation-sense-as-printed")).evidence
    assert found.verdict is Verdict.REFUTED
    assert found.margin < -0.6
    assert verdict_with("rotation-sense-as-printed", spin_ratio=0.01).verdict is Verdict.REFUTED


def test_an_accuracy_beyond_the_enclosure_is_undecided():
    """The enclosure of the least normal motion is some 1e-13 wide."""
    middle = float(judge(claim("normal-motion-dips")).evidence.value.mid())
    found = [
        verdict_with("normal-motion-dips", least=middle, within=within) for within in (1e-11, 1e-14)
    ]
    assert [each.verdict for each in found] == [Verdict.PROVED, Verdict.UNDECIDED]
    assert "contains zero" in found[1].reason


def test_a_bound_that_is_touched_is_undecided():
    """Both sides vanish alike as the rod does: with the coefficient 1 boxes never end."""
    found = verdict_with("short-rod-gives-circle", coefficient=1)
    assert found.verdict is Verdict.UNDECIDED
    assert found.reason == "open after 2000 boxes"


@pytest.mark.parametrize("numbers", [{"rod_length": math.inf}])
def test_numbers_that_a_check_is_not_defined_for_are_named(numbers):
    with pytest.raises(InvalidFile, match=r"edges-of-figure-6.claimed: .*inf.* given; allowed: "):
        verdict_with("edges-of-figure-6", **numbers)
