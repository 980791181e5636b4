"""The picture of the rotation centers of stable pushes."""

from functools import cache

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.path import Path
from scipy.spatial import cKDTree
from stability.flush import SCENES

import planar_pushing as pp
from planar_pushing.drawing.stable_centers import View, rings

SHAPE = np.array([6.0, 4.0])
#: A scene of each kind of picture: both areas, feet, no area, all of the plane, a line.
FEW = [
    "square",
    "four feet",
    "feet on a slanted line",
    "square, rough",
    "square, no friction at the fence",
]


@pytest.fixture(autouse=True)
def closed():
    yield
    plt.close("all")


@cache
def region_of(name):
    return pp.stable_centers(SCENES[name].scene)


@pytest.mark.parametrize("sense", pp.Sense)
@pytest.mark.parametrize(
    "name", [n for n, f in SCENES.items() if f.law not in (pp.Coulomb(0), pp.PerfectlyRough())]
)
def test_areas_are_the_stable_centers(name, sense):
    view = View(region_of(name), SHAPE)
    points = np.random.default_rng(3).uniform(*view.box, (2000, 2))
    inside = np.zeros(len(points), dtype=bool)
    for ring in rings(view, sense):
        inside |= Path(ring).contains_points(points)
    stable = view.region.contains(view.region.scene.to_object(points, "point"), sense)
    near = cKDTree(np.concatenate([np.empty((0, 2)), *view.curves]))
    apart = near.query(points)[0] > 0.02 * view.half
    assert np.array_equal(inside[apart], stable[apart])


def texts(ax):
    return {each.get_text().replace("\n", " ") for each in ax.texts}


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("square", {"force on the right edge", "force through the left end", "stable, clockwise"}),
        ("four feet", {"foot", "force through the right end", "stable, counterclockwise"}),
        ("square, rough", {"every push is stable"}),
        (
            "square, no friction at the fence",
            {f"stable, {sense}: force along the normal" for sense in pp.Sense},
        ),
    ],
)
def test_each_curve_has_its_reason(name, words):
    ax = pp.plot_stable_centers(SCENES[name].scene)
    assert texts(ax) >= words
    given = plt.figure().add_subplot()
    assert pp.plot_stable_centers(pp.stable_centers(SCENES[name].scene), ax=given) is given
    assert texts(given) >= words


@pytest.mark.parametrize(
    "names", [FEW, pytest.param([*SCENES], marks=pytest.mark.slow)], ids=["few", "all"]
)
def test_every_scene_can_be_drawn(names):
    for name in names:
        ax = pp.plot_stable_centers(SCENES[name].scene)
        ax.figure.canvas.draw()
        plt.close(ax.figure)


def test_a_unit_and_an_outline():
    square = SCENES["square"]
    scene = pp.Scene(
        slider=pp.Slider(
            rod_length=1.0, rod_angle=np.pi / 2, side=(-1.0, 1.0), flush=True,
            outline=[(-1.0, -1.5), (1.0, -1.5), (1.0, 1.5), (-1.0, 1.5)],
        ),
        contact=square.law, effects=square.effects, units=pp.Units(length="mm"),
    )  # fmt: skip
    assert any("mm" in each for each in texts(pp.plot_stable_centers(scene)))


def test_refused():
    with pytest.raises(pp.InvalidValue, match="axes of matplotlib"):
        pp.plot_stable_centers(SCENES["square"].scene, ax=plt.figure())
    with pytest.raises(pp.InvalidValue, match="load_scene"):
        pp.plot_stable_centers(3)
