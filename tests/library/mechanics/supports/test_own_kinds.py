"""Supports of a user's own class: they are drawn, and files refuse them."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.supports.cases import SUPPORTS

import planar_pushing as pp
from planar_pushing.drawing.canvas.marks import Area, Dot, Line, Picture
from planar_pushing.drawing.supports import Ink, Pose, add_support

POSE = Pose((0.3, -0.2), 0.7, 0.5)
ALONE = [name for name in SUPPORTS if name not in ("map", "peak", "composite")]


class Own:
    """The pressure of another support."""

    def __init__(self, like):
        self.like = like

    @property
    def center_of_pressure(self):
        return self.like.center_of_pressure

    @property
    def extent(self):
        return self.like.extent

    def pieces(self):
        return self.like.pieces()


class Plate(pp.Disc):
    """A support whose class extends one of the package."""


def scene(support):
    slider = pp.Slider(rod_length=2.0, rod_angle=1.3)
    effects = (pp.SupportFriction(support=support),)
    return pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=effects)


def drawn(support):
    picture = Picture()
    add_support(picture, support, POSE, Ink())
    return picture.marks


@pytest.mark.parametrize("name", ALONE)
def test_it_is_drawn_like_its_pressure(name):
    support, _ = SUPPORTS[name]
    marks, wanted = drawn(Own(support)), drawn(support)
    assert [type(each) for each in marks] == [type(each) for each in wanted]
    for one, other in zip(marks, wanted, strict=True):
        if isinstance(one, Area):
            rings, others = one.rings, other.rings
        elif isinstance(one, Line):
            rings, others = [one.points], [other.points]
        else:
            assert isinstance(one, Dot)
            rings, others = [one.place], [other.place]
        for ring, wanted_ring in zip(
            rings, others, strict=True
        ):  # from any vertex, either way around
            ends = [np.sort(np.round(each, 9), axis=0) for each in (ring, wanted_ring)]
            if isinstance(one, Line):  # the line of a polygon starts within an edge
                ends = [np.array([each.min(axis=0), each.max(axis=0)]) for each in ends]
            assert ends[0] == pytest.approx(ends[1], abs=1e-9)


def test_edges_that_are_no_polygon_are_drawn_as_lines():
    support, _ = SUPPORTS["map"]
    (edges,) = support.pieces().plates
    marks = drawn(Own(support))
    lines = [mark.points for mark in marks if isinstance(mark, Line)]
    assert len(lines) == len(marks) == len(edges)
    for line, (a, b, c, d, _) in zip(lines, edges, strict=True):
        assert line == pytest.approx(POSE.at([(a, b), (c, d)]))


def test_a_class_that_extends_one_of_the_package_is_ones_own(tmp_path):
    own = scene(Plate(0.7))
    assert pp.draw(own, 1.4).figure
    with pytest.raises(pp.InvalidValue, match=r"support: Plate\(radius=0.7"):
        pp.save_scene(own, tmp_path / "scene.yaml")
