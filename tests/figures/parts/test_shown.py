"""The solution that a picture of a scene shows."""

import pytest

from figures.parts.conftest import NO_ADHESION, coulomb, scene
from planar_pushing.figures.parts.shown import shown
from planar_pushing.mechanics.contact import ContactMode


@pytest.mark.parametrize(
    ("contact", "angle", "mode"),
    [
        (coulomb(2), -10, [ContactMode.STICK]),
        (coulomb(2), 170, [ContactMode.SLIP_RIGHT]),
        (coulomb(2), -90, [ContactMode.SEPARATE]),
        (NO_ADHESION, 165, []),
    ],
)
def test_a_sticking_solution_is_shown_else_one_that_moves(contact, angle, mode):
    data = shown(scene(contact, angle))
    assert data["mode"].values.tolist() == mode
    assert data.identical(shown(data))
