"""Pictures of any scene."""

import io

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch, Wedge

import planar_pushing as pp
from figures.parts.conftest import INERTIA, NO_ADHESION, RING, ROUGH, coulomb, scene
from mechanics.supports.cases import SUPPORTS
from planar_pushing.figures import style
from planar_pushing.figures.parts.forces import FAN_ORDER
from planar_pushing.figures.parts.scene import draw_scene
from planar_pushing.figures.parts.shown import shown
from planar_pushing.figures.parts.sketch import Sketch
from planar_pushing.figures.parts.supports import extents
from planar_pushing.mechanics.entries import support_entry


def texts(dataset):
    ax = draw_scene(Figure(figsize=(3.4, 3.4)), dataset)
    return " ".join([ax.get_title(), *(text.get_text() for text in ax.texts)])


@pytest.mark.parametrize(
    ("dataset", "words"),
    [
        (scene(NO_ADHESION, 165), "no consistent solution"),
        (scene(coulomb(2), -90), "the contact breaks"),
        (scene(coulomb(2), -10), "the contact sticks (one of several solutions)"),
        (scene(ROUGH, -90), "(adhesive)"),
        (scene(coulomb(2), 44.9), "radii away"),
        (scene(coulomb(2), 60, effects=(INERTIA,)), r"\mathbf{a}_s = \mathbf{a}_p"),
        (scene(coulomb(2), 60), r"\mathbf{v}_s = \mathbf{v}_p"),
    ],
)
def test_the_picture_says_what_it_shows(dataset, words):
    assert words in texts(dataset)


def test_a_translation_has_no_center():
    assert "centre" not in texts(scene(coulomb(1), 90, rod_length=0.0))


def test_a_scene_is_drawn_on_given_axes():
    figure = Figure(figsize=(7, 3.4))
    left, right = figure.subplots(1, 2)
    draw_scene(right, scene(coulomb(2), 100))
    assert not left.patches
    assert right.patches
    figure.savefig(io.BytesIO(), format="png")


LAWS = st.one_of(
    st.floats(0, 1e6).map(coulomb),
    st.just({"law": "infinite_friction"}),
    st.just(NO_ADHESION),
    st.just(ROUGH),
)


def arrows(figure):
    return [p for ax in figure.axes for p in ax.patches if isinstance(p, FancyArrowPatch)]


@settings(max_examples=20)
@given(
    contact=LAWS,
    angle=st.one_of(
        st.integers(-180_000, 180_000).map(lambda n: n / 1000),
        st.sampled_from([-180, -90, 0, 45, 90, 180]),
    ),
    effects=st.sampled_from([(RING,), (INERTIA,), (RING, INERTIA)]),
    magnitude=st.floats(1e-3, 1e3),
    rod_length=st.one_of(st.floats(0, 10), st.sampled_from([0.0, 1e-9, 1.0, 10.0])),
    rod_angle=st.floats(0.01, 179.99),
    radius=st.floats(1e-2, 1e2),
)
def test_any_scene_can_be_drawn(contact, angle, **rest):
    with style.paper_style():
        figure = Figure(figsize=(3.4, 3.4))
        draw_scene(figure, scene(contact, angle, **rest))
        figure.savefig(io.BytesIO(), format="png", dpi=50)
    assert all(np.all(np.isfinite(patch.get_path().vertices)) for patch in arrows(figure))


def supported(support, **more):
    return {"type": "support_friction", "support": support_entry(support)} | more


ASIDE = INERTIA | {"center": [0.3, -0.2]}
TRIPOD = pp.Points([(1, 0), (-0.5, np.sqrt(0.75)), (-0.5, -np.sqrt(0.75))], [1, 1, 1])


@pytest.mark.parametrize("name", SUPPORTS)
@pytest.mark.parametrize("angle", [90.0, 170.0, -90.0])
def test_a_scene_of_any_support_can_be_drawn(name, angle):
    data = scene(coulomb(0.5), angle, effects=(supported(SUPPORTS[name][0]),))
    figure = Figure(figsize=(3.4, 3.4))
    with style.paper_style():
        ax = draw_scene(figure, data)
        figure.savefig(io.BytesIO(), format="png", dpi=50)
    sketch = Sketch.of(data)
    low, high = extents(sketch.body.support, sketch.pose)
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    assert ([left, bottom] < low).all()
    assert ([right, top] > high).all()
    assert all(np.all(np.isfinite(patch.get_path().vertices)) for patch in arrows(figure))


def test_a_pivot_is_named_and_its_forces_are_a_fan():
    data = scene(ROUGH, 135, effects=(supported(TRIPOD),))
    ax = draw_scene(Figure(figsize=(3.4, 3.4)), data)
    words = [text.get_text() for text in ax.texts]
    assert "pivot" in words
    assert "velocity\ncentre" not in words
    assert ax.get_title().startswith("the contact sticks, the slider pivots")
    (fan,) = (each for each in ax.patches if isinstance(each, Wedge) and each.zorder == FAN_ORDER)
    one = shown(data).isel(solution=0)
    ends = [np.rad2deg(np.arctan2(*each.values[::-1])) for each in (one.force, one.force_end)]
    assert 0 < fan.theta2 - fan.theta1 < 180
    turns = np.subtract.outer([fan.theta1, fan.theta2], ends) % 360
    assert np.minimum(turns, 360 - turns).min(axis=1) == pytest.approx([0, 0], abs=1e-9)


def test_a_settled_force_has_no_fan():
    ax = draw_scene(Figure(figsize=(3.4, 3.4)), scene(ROUGH, 100, effects=(supported(TRIPOD),)))
    assert not [each for each in ax.patches if each.zorder == FAN_ORDER]


@pytest.mark.parametrize("effects", [(supported(TRIPOD), ASIDE), (RING, ASIDE), (ASIDE,)])
def test_a_centre_of_mass_aside_is_named(effects):
    assert "centre\nof mass" in texts(scene(coulomb(2), 100, effects=effects))


def test_a_far_centre_of_a_box_is_told_in_its_half_widths():
    square = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    assert "half-widths away" in texts(scene(coulomb(2), 44.9, effects=(supported(square),)))


def test_the_friction_of_points_is_in_the_ratio_of_their_weights():
    data = scene(coulomb(0.5), 100, effects=(supported(pp.Points([(1, 0), (-1, 0)], [1, 3])),))
    places, (pulls,) = Sketch.of(data).rubbing
    assert len(places) == 2
    assert np.hypot(*pulls.T) == pytest.approx([0.25, 0.75])
