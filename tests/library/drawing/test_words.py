"""Outcomes in words, and the numbers of solutions as short texts."""

import numpy as np
import pytest
from drawing.scenes import RING, ROUGH, coulomb, scene, supported
from mechanics.supports.cases import TRIPOD

import planar_pushing as pp
from planar_pushing.drawing.words import best, does, number, outcome, row


def solved(contact, angle, effects=(RING,)):
    angle = np.deg2rad(angle)
    found = tuple(pp.solve(scene(contact, effects), angle))
    return found, np.array([np.cos(angle), np.sin(angle)])


@pytest.mark.parametrize(
    ("contact", "angle", "said"),
    [
        (coulomb(2), 100, ["the contact sticks"]),
        (coulomb(2), 170, ["slips to the right"]),
        (coulomb(2), -10, ["the contact breaks", "the contact sticks while being pulled",
                           "slips to the left while being pulled"]),
        (ROUGH, -90, ["the contact breaks", "the contact sticks, held by adhesion"]),
    ],
)  # fmt: skip
def test_what_the_contact_does(contact, angle, said):
    solutions, pusher = solved(contact, angle)
    assert [does(each, pusher) for each in solutions] == said
    for shown, words in enumerate(said):
        sentence = outcome(solutions, pusher, shown)
        subject = words if words.startswith("the contact") else f"the contact {words}"
        assert sentence.lower().startswith(subject)
        assert sentence.endswith(".")
        assert all(each in sentence for each in said[:shown] + said[shown + 1 :])


def test_a_pivot_and_no_solution_are_told():
    solutions, pusher = solved(ROUGH, 135, (supported(TRIPOD),))
    assert "turning about a support point" in outcome(solutions, pusher, best(solutions))
    assert outcome((), pusher, best(())) == "No motion of the slider is consistent with this push."


def test_the_numbers_of_a_solution():
    solutions, pusher = solved(coulomb(2), -10)
    rows = [list(row(each, pusher).values()) for each in solutions]
    assert rows[0] == ["separate", "0", "0", "–", "–"]
    assert rows[1][:1] + rows[1][2:3] + rows[1][4:] == ["stick", "1 at −10°", "0"]
    assert rows[2][0] == "slip left"
    slip = solutions[2].contact_motion[0] - pusher[0]
    assert float(rows[2][4].replace("−", "-")) == pytest.approx(slip, abs=5e-4)
    still, pusher = solved(coulomb(1), 45)  # along the rod
    assert "at infinity" in row(still[0], pusher).values()


@pytest.mark.parametrize(
    ("given", "said"),
    [(0.0, "0"), (-1e-12, "0"), (-1e-6, "−1e−06"), (1.5, "1.5"), (-0.25, "−0.25"), (123456.0, "1.23e+05")],
)  # fmt: skip
def test_numbers_are_short_with_a_true_minus(given, said):
    assert number(given) == said
