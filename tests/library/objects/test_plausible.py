"""Warnings about objects that are probably not meant as given, and their place, number and cost."""

from __future__ import annotations

import warnings
from math import acos, pi, sqrt

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.objects.plausible import sample_pressure, share_outside, spread_of

BOX = ((-0.15, -0.1), (0.15, -0.1), (0.15, 0.1), (-0.15, 0.1))
L_SHAPE = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0))
CONTACT = pp.Coulomb(0.5)
BASE = pp.Polygon(BOX)
GRID = pp.PressureMap([0.0, 1.0, 2.0], [0.0, 1.0, 2.0], [[1.0, 1.0], [1.0, 0.0]])


def moved(corners, scale=1.0, by=(0.0, 0.0)):
    return tuple((scale * x + by[0], scale * y + by[1]) for x, y in corners)


def segment_of_disc(height):
    """Share of a unit disc above a chord at a height."""
    return (acos(height) - height * sqrt(1.0 - height**2)) / pi


@pytest.mark.parametrize(
    ("support", "outline", "share"),
    [
        (BASE, BOX, 0.0),
        (pp.Points(BOX), BOX, 0.0),
        (pp.Polygon(moved(BOX, 1.005)), BOX, 0.0),  # no farther outside than drawings are precise
        (pp.Polygon(moved(BOX, 1e3)), BOX, 1.0),  # mm beside m
        (BASE, moved(BOX, 1e3), 0.0),  # m beside mm: as small as the foot of a lamp
        (BASE, moved(BOX, by=(2.0, 0.0)), 1.0),  # an outline in the world
        (BASE, moved(BOX, by=(0.15, 0.1)), 0.75),  # an outline from its corner
        (pp.Polygon(moved(BOX, by=(0.0, 0.1))), BOX, 0.5),
        (pp.Points([(0, 0), (0.5, 0), (0, 0.05)], [1.0, 2.0, 1.0]), BOX, 0.5),
        (pp.Segment((0.0, 0.0), (0.6, 0.0)), BOX, 0.75),
        (pp.Ring(1.0), moved(BOX, 10.0, (0.0, 1.0)), 0.5),
        (pp.Disc(1.0), moved(BOX, 20.0, (0.0, 2.0)), 0.5),
        (pp.Disc(1.0), moved(BOX, 20.0, (0.0, -1.5)), segment_of_disc(0.5)),
        (pp.Annulus(0.5, 1.0), moved(BOX, 20.0, (0.0, 2.0)), 0.5),
        (pp.Composite([(3.0, BASE), (1.0, pp.Disc(0.01, (1.0, 0.0)))]), BOX, 0.25),
        # Of a square, three quarters are in the L; a map without pressure in its notch is in it.
        (pp.Polygon([(0, 0), (2, 0), (2, 2), (0, 2)]), L_SHAPE, 0.25),
        (pp.Polygon(L_SHAPE), L_SHAPE, 0.0),
        (GRID, L_SHAPE, 0.0),
        (pp.PressureMap([0, 1, 2], [0, 1, 2], [[1, 1], [1, 3]]), L_SHAPE, 0.5),
        (pp.Polygon([(0, 0), (4, 0), (4, 4), (0, 4)], [[(1, 1), (3, 1), (3, 3), (1, 3)]]), L_SHAPE, 0.75),
    ],
)  # fmt: skip
def test_the_share_outside_is_that_of_the_area(support, outline, share):
    assert share_outside(support, pp.Outline(outline)) == pytest.approx(share, abs=3e-3)
    # A rotation and a shift of both change nothing.
    axis = (0.6, 0.8)
    placed = pp.Placement(point=(0.3, -0.2), normal=axis).fence
    corners = tuple(map(tuple, placed.point_in(outline).tolist()))
    assert share_outside(support.in_frame(placed), pp.Outline(corners)) == pytest.approx(
        share, abs=5e-3
    )


@pytest.mark.parametrize(
    "support",
    [BASE, GRID, pp.Points(BOX), pp.Ring(2.0), pp.Disc(0.5, (1.0, 2.0)), pp.Annulus(0.2, 0.4),
     pp.Segment((0.0, 1.0), (2.0, 0.0)), pp.Polygon(L_SHAPE)],
)  # fmt: skip
def test_samples_have_the_moments_of_the_pressure(support):
    points, shares = sample_pressure(support.pieces())
    center = shares @ points
    assert shares.sum() == pytest.approx(1.0, rel=1e-12)
    assert center == pytest.approx(support.center_of_pressure, abs=4e-3 * support.extent)
    spread = sqrt(shares @ ((points - center) ** 2).sum(axis=1))
    assert spread == pytest.approx(spread_of(support), rel=4e-3)


@pytest.mark.parametrize(
    ("support", "spread"),
    [(pp.Disc(2.0), sqrt(2.0)), (pp.Ring(2.0), 2.0), (BASE, sqrt((0.3**2 + 0.2**2) / 12)),
     (pp.Points([(1, 0), (-1, 0)]), 1.0), (pp.Segment((-1, 0), (1, 0)), sqrt(1 / 3))],
)  # fmt: skip
def test_radii_of_gyration(support, spread):
    assert spread_of(support) == pytest.approx(spread, rel=1e-12)


def effects(support=BASE, *more, weight=1.0):
    return (pp.SupportFriction(support=support, weight=weight), *more)


def mass(radius, **more):
    return pp.Inertia(mass=1.0, gyration_radius=radius, **more)


#: Objects, and the beginning of the warning; an empty one stands for none.
DOUBTS = [
    ({"effects": effects()}, ""),
    ({"effects": effects(weight=1e6)}, ""),
    ({"effects": effects(moved_box := pp.Polygon(moved(BOX, 1e3)))}, "support: 100 % of"),
    ({"effects": effects(pp.Polygon(moved(BOX, by=(0.15, 0.1))))}, "support: 75 % of"),
    ({"effects": effects(BASE, pp.Viscous(support=moved_box))}, "support: 100 % of"),
    ({"effects": effects(BASE, mass(104.0))}, "gyration_radius: 104 beside"),
    ({"effects": effects(BASE, mass(0.005))}, "gyration_radius: 0.005 beside"),
    ({"effects": effects(BASE, mass(0.104))}, ""),
    ({"effects": effects(BASE, mass(0.2))}, ""),
    # A small foot in the middle of a large object says nothing about its mass.
    ({"effects": effects(pp.Disc(0.01), mass(0.1))}, ""),
    ({"effects": (mass(0.1),)}, ""),
    ({"effects": (mass(100.0),)}, "gyration_radius: 100 beside"),
    ({"effects": effects(BASE, mass(np.array([0.1, 30.0])))}, "gyration_radius: 30 beside"),
    ({"effects": effects() * 2}, "effects: two equal effects of the kind support_friction"),
    ({"effects": effects(BASE, pp.SupportFriction(support=pp.Disc(0.05)))}, ""),
    ({"effects": effects(BASE, mass(0.1), mass(0.1))}, "effects: two equal effects of the kind inertia"),
    ({"contact": pp.Coulomb(26.6)}, "friction_coefficient: 26.6"),
    ({"contact": pp.Coulomb(10.0)}, ""),
    ({"contact": pp.Coulomb(np.array([0.5, 11.0]))}, "friction_coefficient: 11"),
    ({"contact": [pp.Coulomb(0.5), pp.Coulomb(12.0)]}, "friction_coefficient: 12"),
    ({"contact": pp.InfiniteFriction()}, ""),
    ({"contact": pp.PerfectlyRough()}, ""),
]  # fmt: skip


@pytest.mark.parametrize(("given", "said"), DOUBTS)
@pytest.mark.parametrize("points", [(0.05, -0.1), np.full((1000, 2), (0.05, -0.1))])
def test_a_doubtful_object_warns_once(given, said, points):
    many = {"contact": CONTACT, "effects": effects()} | given
    sizes = [np.size(getattr(many["contact"], "friction_coefficient", many["contact"]))]
    sizes += [np.size(getattr(effect, "gyration_radius", 0.0)) for effect in many["effects"]]
    if np.ndim(points) == 2 and max(sizes) > 1:
        points = points[:2]
    if np.ndim(points) == 2 and any(isinstance(effect, pp.Viscous) for effect in many["effects"]):
        pytest.skip("viscous friction has no arrays of contacts")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        pp.solve(pp.scene_at(points, outline=BOX, **many), 1.5, 1.0)
    assert [str(each.message)[: len(said)] for each in caught] == [said] * bool(said)
    for each in caught:
        assert each.category is pp.SceneWarning
        assert each.filename == __file__  # the line of the user
        assert "; " in str(each.message)  # a remedy


def test_without_an_outline_the_support_tells_the_size():
    with pytest.warns(pp.SceneWarning, match="gyration_radius: 0.104 beside"):
        pp.scene_at((0, -1e2), (0, 1), effects=effects(moved_box, mass(0.104)), contact=CONTACT)
    pp.scene_at((2.0, -1.0), (0, 1), effects=effects(), contact=CONTACT)


FILE = """\
object: {{outline: [[0, 0], [0.3, 0], [0.3, 0.2], [0, 0.2]], contact: {{point: [0.1, 0]}}}}
contact: {{law: coulomb, friction_coefficient: {mu}}}
effects:
  - type: support_friction
    support: {{shape: rectangle, width: 0.3, height: 0.2}}
simulate: {{pusher_angle: 90, pusher_speed: 0.05, duration: 0.1, pusher_shape: {shape}}}
"""


def test_scene_files_warn_as_scenes_do(tmp_path):
    path, saved = tmp_path / "box.yaml", tmp_path / "saved.yaml"
    path.write_text(FILE.format(mu=11, shape="finger"), encoding="utf-8")
    for name in (path, saved):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            scene = pp.load_scene(name)
        said = sorted(str(each.message).split(";")[0] for each in caught)
        assert said == [
            "friction_coefficient: 11", "support: 75 % of the pressure lies outside the outline",
        ]  # fmt: skip
        assert {each.filename for each in caught} == {__file__}
        pp.save_scene(scene, saved)


def test_commands_print_a_warning_as_one_line(tmp_path, capsys):
    from planar_pushing.commands import main

    path = tmp_path / "box.yaml"
    path.write_text(FILE.format(mu=0.5, shape="fence"), encoding="utf-8")
    with warnings.catch_warnings():
        warnings.simplefilter("always")
        assert main(["simulate", str(path), "-o", str(tmp_path / "log.nc")]) == 0
    lines = capsys.readouterr().err.splitlines()
    start = "planar-pushing simulate: SceneWarning: "
    assert [line.removeprefix(start).split(";")[0] for line in lines if line.startswith(start)] == [
        "support: 75 % of the pressure lies outside the outline",
        "pusher: a fence at an inner point of a side, while the whole side lies on it",
    ]
