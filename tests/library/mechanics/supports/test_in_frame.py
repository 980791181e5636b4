"""Supports as another frame has them: the same pressure in another place, on both routes."""

from __future__ import annotations

import json

import numpy as np
import pytest
from mechanics.supports.cases import SUPPORTS

import planar_pushing as pp
from planar_pushing.mechanics.entries import entry
from planar_pushing.mechanics.outline import require_corners
from planar_pushing.mechanics.plane import Frame
from planar_pushing.scenes.scene_model import SceneFile
from pulling_by_pushing.oracle.shapes import support as enclosed_support

ANGLES = [0.0, np.pi / 2, np.pi, 0.7, -2.9]
WITH_SIZE = {
    name: case[0] if isinstance(case, tuple) else case
    for name, case in SUPPORTS.items()
    if getattr(case[0] if isinstance(case, tuple) else case, "radius", 0) is not None
}


def frame_at(angle: float) -> Frame:
    return Frame((0.3, -1.2), (float(np.cos(angle)), float(np.sin(angle))))


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("name", WITH_SIZE)
def test_the_wrench_in_another_frame_is_that_of_the_support(name, angle):
    """A twist and its wrench, taken by complex numbers from one frame to the other."""
    support, turn = WITH_SIZE[name], np.exp(1j * angle)
    other = support.in_frame(frame_at(angle))
    origin = complex(0.3, -1.2)
    random = np.random.default_rng(7)
    for v_x, v_y, omega in random.normal(size=(5, 3)):
        f_x, f_y, torque = pp.wrench(pp.SupportFriction(support=support), (v_x, v_y, omega))
        there = (complex(v_x, v_y) + 1j * omega * origin) / turn
        own = pp.wrench(pp.SupportFriction(support=other), (there.real, there.imag, omega))
        force = complex(f_x, f_y) / turn
        lever = torque - (origin.real * f_y - origin.imag * f_x)
        assert own == pytest.approx([force.real, force.imag, lever], abs=2e-13)


@pytest.mark.parametrize("name", WITH_SIZE)
def test_the_oracle_expresses_supports_alike(name):
    other = WITH_SIZE[name].in_frame(frame_at(0.7))
    found = enclosed_support(json.loads(json.dumps(entry(other))))
    x, y = (float(each.p) / float(each.q) for each in found.center)
    assert (x, y) == pytest.approx(other.center_of_pressure, abs=1e-13)
    assert float(found.extent.mid()) == pytest.approx(other.extent, rel=1e-13)


@pytest.mark.parametrize("name", WITH_SIZE)
def test_a_support_in_another_frame_comes_back_from_a_file(name, tmp_path):
    other = WITH_SIZE[name].in_frame(frame_at(-2.9))
    slider = pp.Slider(rod_length=1.0, rod_angle=1.0, radius=1.0)
    scene = pp.Scene(
        slider=slider, contact=pp.Coulomb(1.0), effects=(pp.SupportFriction(support=other),)
    )
    pp.save_scene(scene, tmp_path / "scene.yaml")
    assert pp.load_scene(tmp_path / "scene.yaml") == scene


def test_a_quarter_turn_is_exact():
    other = pp.Polygon.rectangle(2.0, 1.0).in_frame(Frame((0.0, 0.0), (0.0, 1.0)))
    assert set(other.vertices) == {(-0.5, 1.0), (-0.5, -1.0), (0.5, -1.0), (0.5, 1.0)}


def test_a_ring_off_the_center_is_no_ring_of_the_paper():
    slider = pp.Slider(rod_length=2.0, rod_angle=1.0, radius=1.0)
    off = pp.SupportFriction(support=pp.Ring(1.0, (0.2, 0.0)))
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(off,))
    assert not scene.isotropic
    assert pp.Ring(1.0, (0.0, 0.0)) == pp.Ring(1.0)


def test_a_ring_of_the_sliders_radius_has_no_other_frame():
    with pytest.raises(pp.InvalidValue, match="a ring with a radius"):
        pp.Ring().in_frame(frame_at(0.0))


@pytest.mark.parametrize(
    "text",
    [
        {"shape": "rectangle", "width": 2, "height": 1, "center": [1, 0], "angle": 90},
        {"shape": "regular_polygon", "count": 6, "radius": 2, "angle": 30},
    ],
)
def test_shapes_of_files(text):
    effects = [{"type": "support_friction", "support": text}]
    content = {
        "slider": {"rod_length": 1, "rod_angle": 90},
        "contact": {"law": "perfectly_rough"},
        "effects": effects,
    }
    found = SceneFile.model_validate(content).build().effects[0].support
    if text["shape"] == "rectangle":
        assert np.array(found.vertices).max(axis=0) == pytest.approx([1.5, 1.0])
    else:
        corners = np.array(found.vertices)
        assert np.hypot(*corners.T) == pytest.approx(2.0)
        assert corners[0] == pytest.approx([np.sqrt(3), 1.0])


def test_layouts_are_about_their_centers():
    for feet in (pp.Points.rectangle(3, 1, (5, 2), 0.3), pp.Points.regular(5, 2, (5, 2)),
                 pp.Points.disc(3, 2, (5, 2))):  # fmt: skip
        assert feet.center_of_pressure == pytest.approx((5, 2))


def test_feet_of_a_disc_have_about_its_moments():
    """Mean square distance from the center: half the square of the radius for the disc."""
    feet = np.array(pp.Points.disc(4, 2.0).positions)
    assert len(feet) == 61
    assert (feet**2).sum(axis=1).mean() == pytest.approx(2.0, rel=0.02)


def test_points_by_names_and_without_weights():
    feet = pp.Points({"left": (0, 0), "right": (1, 0)})
    assert feet == pp.Points([(0, 0), (1, 0)], [1, 1], ["left", "right"])
    assert pp.Points([(0, 0), (1, 0)]).weights == (1.0, 1.0)


class Ring:
    """Stands in for the rings of shapely, with coordinates alone."""

    def __init__(self, coords):
        self.coords = coords


class Shape:
    """Stands in for the geometries of shapely that have no coordinates themselves."""

    @property
    def coords(self):
        raise NotImplementedError("their parts provide coordinates")


class Shapely(Shape):
    def __init__(self, exterior, *interiors):
        self.exterior, self.interiors = Ring(exterior), [Ring(each) for each in interiors]


class Several(Shape):
    def __init__(self, *geoms):
        self.geoms = geoms


def test_closed_rings_and_shapelys_exteriors():
    ring = [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]
    square = pp.Polygon(ring[:-1])
    assert pp.Polygon(ring) == square
    assert pp.Polygon(Shapely(ring)) == square
    assert pp.Polygon(np.array(ring)) == square
    assert pp.Polygon(Ring(ring)) == square
    assert pp.Polygon(square) == square


def test_the_holes_of_shapely_are_holes_of_a_support_and_not_of_an_outline():
    ring, hole = [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)], [(1, 1), (1, 3), (3, 3), (1, 1)]
    frame, other = pp.Polygon(ring, [hole]), [(3, 1), (3.5, 1), (3.5, 2)]
    assert frame.holes == (tuple(hole[:-1]),)
    assert pp.Polygon(Shapely(ring, hole)) == frame == pp.Polygon(frame)
    assert pp.Polygon(Shapely(ring), [Ring(hole)]) == frame != pp.Polygon(ring)
    both = pp.Polygon(ring, [hole, other])
    assert pp.Polygon(Shapely(ring, hole), [other]) == pp.Polygon(frame, [other]) == both
    assert require_corners(Shapely(ring, hole)) == require_corners(ring)


@pytest.mark.parametrize("use", [pp.Polygon, require_corners])
def test_several_polygons_are_none(use):
    parts = Several(Shapely([(0, 0), (1, 0), (0, 1)]), Shapely([(2, 0), (3, 0), (2, 1)]))
    with pytest.raises(pp.InvalidValue, match=r"one polygon.* Composite\(.* in shape\.geoms\]\)"):
        use(parts)


@pytest.mark.parametrize("away", [1e8, 1e9, 1e12])
def test_an_outline_far_from_the_origin_keeps_its_direction(away):
    box = np.array([(-0.15, -0.1), (0.15, -0.1), (0.15, 0.1), (-0.15, 0.1)])
    box *= away / 1e8
    for turn in np.random.default_rng(3).uniform(0, 2 * np.pi, 50):
        corners = box + away * np.array([np.cos(turn), np.sin(turn)])
        for given in (corners, corners[::-1]):
            found = np.array(require_corners(given))
            (a, b), (c, d) = found[1] - found[0], found[2] - found[0]
            assert a * d - b * c > 0
