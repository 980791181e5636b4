"""Pictures of any scene."""

import io

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch

from figures.parts.conftest import INERTIA, NO_ADHESION, RING, ROUGH, coulomb, scene
from planar_pushing.figures import style
from planar_pushing.figures.parts.scene import draw_scene


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


@settings(max_examples=40, deadline=None)
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
