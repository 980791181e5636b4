"""Forces in the picture of a scene: the limit curve that they end on."""

import numpy as np
import pytest
from matplotlib.figure import Figure

import planar_pushing as pp
from figures.parts.conftest import RING, coulomb, scene
from planar_pushing.figures.parts.forces import limit_curve
from planar_pushing.figures.parts.scene import LAYERS, draw_scene
from planar_pushing.figures.parts.sketch import Sketch
from planar_pushing.figures.style import CENTER, FORCE
from planar_pushing.mechanics.entries import support_entry
from planar_pushing.study.datasets.scenes import with_limit_curve
from planar_pushing.study.files.scene_model import SceneFile

TRIPOD = pp.Points([(1, 0), (-0.5, np.sqrt(0.75)), (-0.5, -np.sqrt(0.75))], [1, 1, 1])
FEET = {"type": "support_friction", "support": support_entry(TRIPOD)}


def curved(effect, angle, contact):
    content = {"slider": {"rod_length": 2.0, "rod_angle": 45.0}, "contact": contact}
    own = SceneFile.model_validate(content | {"effects": [effect]}).build()
    return with_limit_curve(scene(contact, angle, effects=(effect,), radius=None), own)


def lines(data, color):
    ax = draw_scene(Figure(figsize=(3.4, 3.4)), data, layers=(limit_curve, *LAYERS))
    wide = 0.9 if color == FORCE else 2.4
    found = [each for each in ax.lines if (each.get_color(), each.get_linewidth()) == (color, wide)]
    return ax, [each.get_xydata() for each in found]


@pytest.mark.parametrize("effect", [RING, FEET])
@pytest.mark.parametrize("angle", [100.0, -90.0])
def test_the_picture_holds_the_curve_and_the_force_ends_on_it(effect, angle):
    data = curved(effect, angle, coulomb(0.5))
    ax, (curve,) = lines(data, FORCE)
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    assert ((curve > [left, low]) & (curve < [right, high])).all()
    sketch = Sketch.of(data)
    if sketch.moves:
        near = np.hypot(*(curve - sketch.drawn_force(sketch.force)).T).min()
        assert near < 0.02 * sketch.reach


def test_a_ring_has_no_flats():
    assert lines(curved(RING, 100, coulomb(0.5)), CENTER)[1] == []


def test_a_foot_about_which_the_tripod_pivots_has_a_flat_for_either_sense():
    _, flats = lines(curved(FEET, 100, coulomb(0.5)), CENTER)
    one, other = flats
    assert one == pytest.approx(-other, abs=1e-9)
    for flat in flats:
        ends = flat[-1] - flat[0]
        off = (flat - flat[0]) @ [-ends[1], ends[0]]
        assert np.abs(off).max() < 1e-9


def test_both_ends_of_a_fan_lie_on_the_curve():
    data = curved(FEET, 135, {"law": "perfectly_rough"})
    _, (curve,) = lines(data, FORCE)
    sketch = Sketch.of(data)
    assert len(sketch.forces) == 2
    for force in sketch.forces:
        assert np.hypot(*(curve - sketch.drawn_force(force)).T).min() < 0.02 * sketch.reach


def test_friction_and_inertia_have_no_one_curve():
    both = pp.Scene(
        slider=pp.Slider(rod_length=1.0, rod_angle=1.0), contact=pp.Coulomb(1.0),
        effects=(pp.RingFriction(), pp.Inertia()),
    )  # fmt: skip
    data = scene(coulomb(1.0), 100)
    with pytest.raises(pp.InvalidValue, match=r"limit_curve: .*allowed: a scene with one effect"):
        with_limit_curve(data, both)
