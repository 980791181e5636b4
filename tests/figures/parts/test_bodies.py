"""The slider of a picture, and its centres of pressure and of mass."""

import numpy as np
import pytest
import xarray as xr

import planar_pushing as pp
from figures.parts.conftest import INERTIA, RING, coulomb, scene
from planar_pushing.figures.parts.bodies import (
    RIM,
    Body,
    body_of,
    draw_body,
    explain_centers,
    name_centers,
)
from planar_pushing.figures.parts.supports import Pose

BOX = {"shape": "polygon", "vertices": [[-1, -1], [3, -1], [3, 1], [-1, 1]]}
FRICTION = {"type": "support_friction", "support": BOX}
ASIDE = INERTIA | {"center": [0.4, 0.3]}
HERE = Pose((0.0, 0.0), 0.0)


def body(*effects, **slider):
    return body_of(scene(coulomb(2), 100, effects=effects, **slider))


def test_the_body_is_read_from_the_scene():
    found = body(FRICTION)
    assert found.support == pp.Polygon(BOX["vertices"])
    assert dict(found.centers) == {"pressure": (1.0, 0.0)}
    assert (found.half, found.middle.tolist(), found.is_ring) == (2.0, [1.0, 0.0], False)


def test_a_dataset_without_a_scene_is_of_a_ring():
    assert body_of(xr.Dataset({"radius": 1.5})) == Body(support=pp.Ring(1.5))


def test_the_centre_of_a_ring_is_not_marked():
    assert body(RING, radius=2.0) == Body(support=pp.Ring(2.0))
    assert body(RING, INERTIA).centers == ()


def test_a_centre_of_mass_off_the_centre_is_marked():
    assert dict(body(RING, ASIDE).centers) == {
        "pressure": (0.0, 0.0), "mass": pytest.approx((0.4, 0.3)),
    }  # fmt: skip
    assert [name for name, _ in body(ASIDE).centers] == ["mass"]


def test_the_box_holds_support_and_centres():
    far = body(FRICTION, INERTIA | {"center": [5.0, 0.0]})
    rim = RIM * far.half
    assert far.box(HERE) == pytest.approx(np.array([[-1 - rim, -1 - rim], [5 + rim, 1 + rim]]))


def test_signs_are_named_beside_them_or_in_a_legend(ax):
    found = body(FRICTION, ASIDE)
    draw_body(ax, found, HERE)
    marked = {tuple(np.round(line.get_xydata()[0], 9)) for line in ax.lines}
    assert {(1.0, 0.0), (0.4, 0.3)} <= marked
    name_centers(ax, found, HERE)
    assert {text.get_text() for text in ax.texts} == {"centre of\npressure", "centre\nof mass"}
    explain_centers(ax, found)
    words = [text.get_text() for text in ax.get_legend().get_texts()]
    assert words == ["centre of pressure", "centre of mass"]


def test_a_slider_without_signs_has_no_legend(ax):
    explain_centers(ax, Body(support=pp.Ring(1.0)))
    assert ax.get_legend() is None
