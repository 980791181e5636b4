"""Figure 13."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.figures.parts.mode_sets import LEFT, RIGHT, SEPARATE, STICK
from planar_pushing.mechanics.contact import ContactMode


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


@pytest.mark.parametrize("place", range(3))
def test_sticking_ends_on_the_line(plotted, pictures, place):
    data = plotted["figure_13"]
    slider = pp.Slider(rod_length=float(data.rod_length), rod_angle=np.deg2rad(45))
    kinds = {"support_friction": pp.RingFriction(), "inertia": pp.Inertia()}
    effects = tuple(kinds[each] for each in str(data.effects.values[place]).split("+"))
    for line in pictures["figure_13"].axes[place].lines[:2]:
        for steep, angle in np.transpose(line.get_data())[1:-1]:
            for factor, sticks in ((1 - 1e-9, False), (1 + 1e-9, True)):
                law = pp.Coulomb(factor * np.tan(np.deg2rad(steep)))
                scene = pp.Scene(slider=slider, contact=law, effects=effects)
                found = pp.solve(scene, np.deg2rad(angle))
                assert (ContactMode.STICK in [each.mode for each in found]) == sticks


def test_bands_meet_at_the_line_where_sticking_ends(plotted, pictures):
    data = plotted["figure_13"]
    for place, ax in enumerate(pictures["figure_13"].axes[:3]):
        angle, ends = ax.lines[1].get_data()
        corners = np.concatenate([p.vertices for each in ax.collections for p in each.get_paths()])
        for contact in ("coulomb_0.5", "coulomb_2"):
            here = float(data.friction_angle.sel(contact=contact))
            found = corners[np.isclose(corners[:, 0], here)][:, 1]
            assert np.abs(found - np.interp(here, angle, ends)).min() < 0.1, place
