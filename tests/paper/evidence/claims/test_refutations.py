"""A wrong claim comes out as refuted: wrong numbers for each check, and wrong premises for each proof."""

import math

import pytest
from evidence.claims.ledgers import entries, found, judge, ledger
from flint import arb

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.evidence.claims import any_support, cones, limit_curves
from pulling_by_pushing.evidence.proofs import identities as ids
from pulling_by_pushing.evidence.proofs import lemmas
from pulling_by_pushing.evidence.proofs.mechanics import LAWS, Oracle
from pulling_by_pushing.evidence.proofs.registry import CHECKS
from pulling_by_pushing.evidence.proofs.verdicts import Verdict

WRONG = [
    # formulas and identities
    ("friction-integrals", "friction-integrals", {"cross_term": 1}),
    ("force-in-the-fence-frame", "fence-frame", {"rod_angle": 30}),
    ("equations-of-motion", "equations-of-motion", {"mass": 2}),
    ("equations-of-motion", "equations-of-motion", {"gyration_radius": 2}),
    ("pulling-condition", "pulling-condition", {"tangential": 3}),
    ("pulling-condition", "threshold", {"threshold": 1.49}),
    ("pulling-condition", "threshold", {"threshold": 1.5 + 2**-50}),
    ("rod-on-a-wall", "rod-on-a-wall", {"numerator": 5}),
    ("centers-of-figure-9", "centers-on-a-line", {"distance": 0.4}),
    ("geometric-facts", "facts-5-to-7", {"moment_arm": 1.1}),
    ("ring-is-self-dual", "self-duality", {"force": 0.64}),
    # every force angle, every rod length, every magnitude
    ("nonnegative-work", "nonnegative-work", {"above": 1.01}),
    ("motion-turns-with-force", "motion-turns-with-force", {"above": 1.01}),
    ("short-and-long-rods", "tends-to-circle", {"coefficient": 0.99}),
    ("extrema-of-the-force", "extreme-forces", {"along": 46}),
    ("extrema-of-the-force", "extreme-forces", {"across": 134}),
    ("extrema-of-the-force", "extreme-forces", {"force": 0.9}),
    ("extrema-of-the-force", "parallel-at-four-angles", {"along": 44}),
    ("extrema-of-the-force", "parallel-at-four-angles", {"across": 134}),
    ("pulling-of-figure-11", "center-on-ring-pulls", {"rod_length": 1.25}),
    ("slip-of-figure-8", "slips-beyond-edge", {"pusher_angle": 138}),
    ("slip-of-figure-12", "slips-beyond-edge", {"pusher_angle": 138.8}),
    ("no-solution-under-definition-2", "figure-9b", {"pusher_angle": 146}),
    ("no-solution-under-definition-2", "figure-8", {"effects": "inertia", "pusher_angle": 137}),
    ("any-pressure", "rotation-for-any-pressure", {"low": 0.1746802}),
    ("any-pressure", "rotation-for-any-pressure", {"high": 0.441823}),
    ("stable-for-any-pressure", "stable-for-any-pressure", {"center": 1.9999999}),
    ("stable-for-any-pressure", "stable-for-any-pressure", {"friction": 0.23607}),
    ("motion-of-the-ellipsoid", "ellipsoid-turns-motion", {"angle": 19.48}),
    ("motion-of-the-ellipsoid", "ellipsoid-turns-motion", {"missing": 1e-5}),
    ("motion-of-the-ellipsoid", "ellipsoid-turns-motion", {"spin_ratio": 0.01}),
    ("speed-decides-pulling", "slow-pulls-fast-does-not", {"above": 1.26}),
    ("speed-decides-pulling", "slow-pulls-fast-does-not", {"below": 1.51}),
    # numbers, within their accuracy, exactly, and as bounds
    ("velocity-cone-of-figure-6", "right", {"near": -20.03845755}),
    ("velocity-cone-of-figure-6", "left", {"law": 2.1}),
    ("cones-of-figure-7", "left-5", {"rod_length": 4}),
    ("acceleration-cones-of-figure-9", "right", {"effects": "support_friction"}),
    ("exact-cone-of-figure-12", "right", {"near": -45}),
    ("bound-of-figure-12", "right", {"near": -44}),
    ("bound-of-figure-12", "left-gap", {"near": 3.2}),
    ("friction-cone", "half-angle", {"law": 1}),
    ("friction-cone", "infinite-left", {"equals": 170}),
    ("pulling-of-figure-3", "offset", {"force_angle": 43}),
    ("pulling-of-figure-3", "sense", {"force_angle": 62}),
    ("pulling-offset", "long-rod", {"near": 0.164}),
    ("pulling-offset", "short-rod", {"rod_length": 3}),
    ("speed-decides-pulling", "threshold", {"near": 1.27}),
    ("distance-from-the-ellipse", "long-rod", {"near": 0.09}),
    ("two-definitions", "slip", {"equals": 179}),
    ("two-definitions", "slip", {"pusher_angle": 100}),
    ("perfectly-rough", "adhesion", {"pusher_angle": 90}),
    ("normal-motion-dips", "least", {"near": -0.041}),
    ("normal-motion-dips", "least", {"law": 2}),
    ("normal-motion-dips", "force", {"near": 1.42}),
    ("normal-motion-dips", "return-force", {"near": 2.21}),
    ("cones-beyond-the-pure-ones", "both", {"power": 0.9}),
    ("cones-beyond-the-pure-ones", "inertia", {"mass_across": -0.5, "mass_along": 0}),
    ("pivots-of-a-tripod", "span", {"rod_length": 2.1}),
    ("pivots-of-a-tripod", "nearest", {"near": 0.268}),
    ("pivots-of-a-tripod", "farthest", {"near": 3.73}),
    ("corner-of-a-line", "span", {"rod_length": 1.5}),
    ("foot-ahead-holds", "margin", {"rod_length": 0.5}),
    ("center-beyond-bound", "product", {"spin_ratio": 900}),
    ("integration-constants", "strip", {"support": "rectangle"}),
    ("integration-constants", "ring", {"support": "disc"}),
    ("shape-of-an-l", "along-normal", {"rod_angle": 91}),
    ("shape-of-an-l", "difference", {"turn": 29}),
    ("shape-of-an-l", "least-force", {"rod_length": 5}),
    # contact modes
    ("case-analysis", "several", {"pusher_angle": 10}),
    ("case-analysis", "several", {"law": 1}),
    ("case-analysis", "none", {"law": "definition-1"}),
    ("pulling-is-ambiguous", "figure-11", {"magnitude": 1000, "pusher_angle": -45}),
    ("normal-motion-dips", "two-slips", {"magnitude": 1}),
    ("perfectly-rough", "first", {"pusher_angle": 120}),
]

#: Their numbers say where, and how often, the library and the closed forms are evaluated.
SAMPLED = {name for name, check in CHECKS.items() if check.kind is Verdict.SAMPLED}


def function_of(entry):
    """The function of a check, without the part of its numbers."""
    return entry.argument


def test_every_check_that_takes_numbers_has_a_wrong_one():
    wrong = {function_of(entries()[claim, name]) for claim, name, _ in WRONG}
    given = {function_of(entry) for entry in entries().values() if entry.claimed or entry.at}
    assert given - wrong == SAMPLED | {"rotation-sense"}  # refuted as it is


@pytest.mark.parametrize(("claim", "name", "numbers"), WRONG)
def test_wrong_numbers_are_refuted(claim, name, numbers):
    evidence = judge(claim, name, **numbers)
    assert evidence.verdict is Verdict.REFUTED
    assert evidence.reason


SLIDE = (ids.a + ids.k * any_support.POINT[1] + ids.a**2, ids.b + ids.k * any_support.POINT[0])
PREMISES = {
    "the force of the ring": (
        lemmas, "FORCE", 1 + 2 * ids.k * ids.c,
        ("closed-forms", "unique-center", "limit-surface", "motion-normal-to-curve",
         "tends-to-segment", "left-force-pushes", "every-rod-pulls-and-slips",
         "sticks-inside-slips-outside", "lines-opposite-center", "cases-by-line-of-force"),
    ),
    "the speed of a point": (lemmas, "RADICAND", lemmas.RADICAND + ids.s, ("lines-of-force",)),
    "the motion of the contact": (
        ids, "MOTION", (ids.x + ids.k * ids.l * ids.q + ids.ONE, ids.y - ids.k * ids.l * ids.p),
        ("acceleration-turns-with-force", "infinite-cone-spans", "aligned-without-rod",
         "both-effects-lie-between"),
    ),
    "the sine": (ids, "s", ids.c, ("ellipse-of-inertia",)),
    "the slide of a point": (
        any_support, "SLIDE", SLIDE,
        ("power-of-any-support", "motion-never-turns-back", "opposite-edges", "symmetric-about-rod",
         "normal-push-sticks", "aligned-where-symmetric", "pull-has-a-slip", "pulls-where-it-slips"),
    ),
    "the angle of two slides": (ids, "ROD_COSINE", ids.ONE, ("largest-through-center-of-pressure",)),
    "a slide about a center": (
        any_support, "_slide", lambda place, center: place, ("corner-of-a-line",),
    ),
    "a center beyond a": (ids, "c", ids.b, ("center-within-bound",)),
    "the open cone": (
        cones, "LAWS", dict.fromkeys(LAWS, LAWS["definition-1"]), ("open-cone-inside-closed",),
    ),
}  # fmt: skip


@pytest.mark.parametrize("premise", PREMISES)
def test_a_proof_from_a_wrong_premise_is_refuted(monkeypatch, premise):
    place, name, wrong, checks = PREMISES[premise]
    monkeypatch.setattr(place, name, wrong)
    for check in checks:
        assert CHECKS[check].run(Oracle()).verdict is Verdict.REFUTED, check


def test_an_ellipse_would_be_noticed(monkeypatch):
    monkeypatch.setattr(limit_curves, "profile", lambda k: (arb(0), arb(0.5)))
    assert CHECKS["never-an-ellipse"].run(Oracle()).verdict is Verdict.REFUTED


def test_every_proof_without_numbers_has_a_wrong_premise():
    plain = {entry.check for entry in entries().values() if entry.check and not entry.claimed}
    tested = {check for *_, checks in PREMISES.values() for check in checks}
    assert plain == tested | {"never-an-ellipse"}


def test_the_printed_sense_of_rotation_is_refuted_by_a_margin_and_the_other_is_proved():
    evidence = found("rotation-sense", "rotation-sense")
    assert evidence.verdict is Verdict.REFUTED
    assert evidence.margin < -0.5
    assert judge("rotation-sense", "rotation-sense", sign=1).verdict is Verdict.PROVED


def test_closer_to_the_center_the_contact_is_pushed():
    """The force at 43 degrees passes at 0.105 R, and moves the contact into the slider."""
    angle = judge("pulling-of-figure-3", "direction", force_angle=43, near=11.8, within=0.05)
    assert angle.verdict is Verdict.ENCLOSED


def test_an_accuracy_beyond_the_enclosure_is_undecided():
    """The least normal motion is known to some 1e-19; the double next to it is off by more."""
    value = found("normal-motion-dips", "least").value
    near = float(value.mid())
    off = float(abs(value.mid() - near))
    tried = [
        judge("normal-motion-dips", "least", near=near, within=within) for within in (1e-11, off)
    ]
    assert [each.verdict for each in tried] == [Verdict.ENCLOSED, Verdict.UNDECIDED]
    assert "contains zero" in tried[1].reason


def test_a_bound_that_is_touched_is_undecided():
    """Both sides vanish alike as the rod does: with the coefficient 1 boxes never end."""
    evidence = judge("short-and-long-rods", "tends-to-circle", coefficient=1)
    assert evidence.verdict is Verdict.UNDECIDED
    assert evidence.reason == "undecided after 2000 boxes"


@pytest.mark.parametrize("wrong", [{"law": "coulomb"}, {"effects": "friction"}, {"mode": 1}])
def test_arguments_that_a_check_does_not_take_are_named(wrong):
    with pytest.raises(InvalidFile, match=r"velocity-cone-of-figure-6\.right: .* given; allowed: "):
        judge("velocity-cone-of-figure-6", "right", **wrong)


def test_numbers_that_a_check_is_not_defined_for_are_named():
    with pytest.raises(
        InvalidFile, match=r"velocity-cone-of-figure-6.right: .*inf.* given; allowed: "
    ):
        judge("velocity-cone-of-figure-6", "right", rod_length=math.inf)


def test_the_ledger_expects_one_refutation():
    (claim,) = (each for each in ledger().claims if each.expect == "refuted")
    assert claim.id == "rotation-sense"
    assert "without consequence" in claim.reason
