"""Figure 13."""

import pytest

from planar_pushing.figures.paper.figure_13 import LEFT, RIGHT, SEPARATE, STICK


@pytest.mark.parametrize(
    ("contact", "pusher_angle", "modes"),
    [
        ("coulomb_2", -15, SEPARATE | STICK | LEFT),
        ("coulomb_2", -45, SEPARATE),
        ("coulomb_2", 90, STICK),
        ("coulomb_2", 150, RIGHT),
        ("coulomb_0.5", 45, LEFT),
        ("infinite_friction_free", 165, RIGHT),
        ("infinite_friction_none", 165, 0),
        ("perfectly_rough", 165, STICK),
        ("perfectly_rough", -165, SEPARATE | STICK),
    ],
)
def test_sets_of_modes(plotted, contact, pusher_angle, modes):
    here = plotted["figure_13"].modes.sel(contact=contact, pusher_angle=pusher_angle)
    assert int(here.sel(effects="support_friction")) == modes


def test_friction_is_told_by_its_angle(plotted):
    data = plotted["figure_13"]
    angles = data.friction_angle.sel(contact=["coulomb_0", "infinite_friction_free"])
    assert angles.values.tolist() == [0, 90]
