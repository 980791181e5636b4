"""Supports of a user's own class: every public function takes them, or refuses them in one line."""

from __future__ import annotations

from types import SimpleNamespace

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
            rings, others = [one.position], [other.position]
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
        assert line == pytest.approx(POSE.to_plane([(a, b), (c, d)]))


def test_a_class_that_extends_one_of_the_package_is_ones_own(tmp_path):
    own = scene(Plate(0.7))
    assert pp.draw(own, 1.4).figure
    with pytest.raises(pp.InvalidValue, match=r"support: Plate\(radius=0.7"):
        pp.save_scene(own, tmp_path / "scene.yaml")


class Framed(Own):
    """A support that can be expressed in another frame."""

    def in_frame(self, frame):
        return Framed(self.like.in_frame(frame))


BOX, TWIST = [(-1, -1), (1, -1), (1, 1), (-1, 1)], (0.0, 1.0, 0.1)
PUSH = {"pusher": pp.Pusher(velocity=(0.3, 1.0)), "duration": 0.1}


def friction(support):
    return [pp.SupportFriction(support=support)]


def placed(support, point=(0.0, -1.0)):
    effects = [*friction(support), pp.Inertia()]
    return pp.scene_at(point, (0, 1), effects=effects, contact=pp.Coulomb(0.5), outline=BOX)


#: Public functions; a support of a user's own class is like that whose pressure it has.
CALLS = {
    "solve": lambda support: pp.solve(scene(support), np.array([1.0, 2.0])).force,
    "derivatives": lambda support: pp.solve(scene(support), 1.2, derivatives=True)[0].force,
    "motion_cone": lambda support: pp.motion_cone(scene(support)).degrees,
    "limit_curve": lambda support: pp.limit_curve(scene(support), np.array([1.0, 2.0])).force,
    "motion_angle": lambda support: pp.motion_angle(scene(support), 1.0),
    "motion_centers": lambda support: pp.motion_centers(scene(support), 1.0),
    "spin_ratio": lambda support: pp.spin_ratio(scene(support), 1.0),
    "motion_of_force": lambda support: pp.motion_of_force(scene(support), 1.0).twist,
    "wrench": lambda support: pp.wrench(*friction(support), TWIST),
    "potential": lambda support: pp.potential(*friction(support), TWIST),
    "fit_ellipsoid": lambda support: pp.fit_ellipsoid(support).matrix,
    "simulate": lambda support: pp.simulate(scene(support), **PUSH)["rod_angle"],
    "time-stepping": lambda support: pp.simulate(scene(support), **PUSH, method="time-stepping")["slip"],
    "simulate_batch": lambda support: pp.simulate_batch(scene(support), **PUSH)["rod_angle"],
    "to_pandas": lambda support: pp.to_pandas(pp.simulate(scene(support), **PUSH))["slip"],
    "composite": lambda support: pp.solve(scene(pp.Composite([(1, support), (1, pp.Disc(2))])), 1)[0].force,
    "array": lambda support: pp.solve(scene(np.array([support, pp.Disc(1.0)], dtype=object)), 1.2).force,
    "scene_at": lambda support: pp.solve(placed(support), 1.2)[0].force,
    "contacts": lambda support: pp.solve(placed(support, np.array([(0.0, -1), (0.2, -1)])), 1.2).force,
    "to_mjcf": lambda support: len(pp.to_mjcf(placed(support))),
    "pushes_for": lambda support: [push.point for push in pp.pushes_for(friction(support), TWIST, BOX)],
    "wrench_set": lambda support: pp.wrench_set(friction(support), TWIST).offset,
    "simulate_pushes": lambda support: pp.simulate_pushes(friction(support), BOX, 3)["contact"],
    "viscous": lambda support: pp.wrench(pp.Viscous(support=support), TWIST),
}  # fmt: skip


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_it_is_as_good_as_one_of_the_package(call):
    support = pp.Polygon([(-0.5, -1), (1, -1), (1, 1), (-1, 1)])
    np.testing.assert_allclose(call(Framed(support)), call(support), rtol=1e-9, atol=1e-12)


def test_it_is_drawn_and_compared():
    support = Framed(pp.Disc(1.0))
    assert scene(support)._repr_svg_()
    assert pp.draw(scene(support), 1.2, limit_curve=True).figure
    pushes = pp.simulate_pushes(friction(pp.Disc(1.0)), BOX, 8)
    assert "mine" in pp.compare(pushes, {"mine": support}, resamples=2)["model"]


class Outdated(Own):
    """A support whose method has the name of an earlier version."""

    def moved(self, frame):
        return Outdated(self.like.in_frame(frame))


@pytest.mark.parametrize(("kind", "remedy"), [
    (Own, "add one that returns the support with its positions transformed by frame.point_in"),
    (Outdated, "rename its method moved, the former name, to in_frame"),
])  # fmt: skip
def test_without_a_method_in_frame_it_is_in_the_body_frame_only(kind, remedy):
    support = kind(pp.Disc(1.0))
    allowed = f"a support with a method in_frame(frame); {remedy}"
    pushes = pp.simulate_pushes(friction(pp.Disc(1.0)), BOX, 8)
    assert pp.solve(scene(support), 1.2)
    for use in (
        lambda: placed(support),
        lambda: placed(support, np.array([(0.0, -1), (0.2, -1)])),
        lambda: placed(pp.Composite([(1, support)])),
        lambda: pp.compare(pushes, {"mine": support}, resamples=2),
    ):
        with pytest.raises(pp.InvalidValue) as error:
            use()
        assert str(error.value).endswith(allowed), str(error.value)
        assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("change", "allowed"),
    [
        ({"pieces": 3}, "whose pieces() are Pieces with shares that add up to 1; return those of"),
        ({"pieces": [np.ones((1, 3))]}, "whose pieces() are Pieces with shares that add up to 1"),
        (
            {"pieces": pp.Disc(1.0).pieces()._replace(rings=pp.Ring(1.0).pieces().rings)},
            "add up to 1",
        ),
        (
            {"extent": 2.0},
            "center_of_pressure and extent are those of its pieces(), here (0, 0) and 1;",
        ),
        (
            {"center_of_pressure": (0.1, 0.0)},
            "are those of its pieces(), here (0, 0) and 1; correct these",
        ),
    ],
    ids=str,
)
def test_what_says_something_else_of_itself_than_its_pieces(change, allowed):
    disc = pp.Disc(1.0)
    parts = {"center_of_pressure": (0.0, 0.0), "extent": 1.0, "pieces": disc.pieces()} | change
    pieces = parts.pop("pieces")
    own = Own(SimpleNamespace(**parts, pieces=lambda: pieces))
    for make in (
        lambda: pp.SupportFriction(support=own), lambda: pp.Viscous(support=own),
        lambda: pp.fit_ellipsoid(own), lambda: pp.Composite([(1, own)]),
    ):  # fmt: skip
        with pytest.raises(pp.InvalidValue) as caught:
            make()
        assert f"given; allowed: a support {allowed}" in str(caught.value) or allowed in str(
            caught.value
        )
        assert "\n" not in str(caught.value)
