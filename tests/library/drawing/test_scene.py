"""Pictures of any scene."""

from dataclasses import replace

import numpy as np
import pytest
from drawing.scenes import (
    ASIDE,
    INERTIA,
    NO_ADHESION,
    RING,
    ROUGH,
    coulomb,
    dataset,
    scene,
    supported,
)
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanics.supports.cases import SUPPORTS, TRIPOD

import planar_pushing as pp
from planar_pushing.drawing.canvas.colors import CENTER, FORCE, MOTION, PUSHER, SLIP, tint
from planar_pushing.drawing.canvas.marks import Area, Arrow, Dot, Hatch, Label, Line, Picture
from planar_pushing.drawing.canvas.svg import to_svg
from planar_pushing.drawing.scene import PALE, add_scale, scene_picture
from planar_pushing.drawing.sketch import FAR, Sketch, forces, with_curve
from planar_pushing.drawing.words import best, best_row
from planar_pushing.mechanics.contact import ContactMode

SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])


def sketch(contact, angle, effects=(RING,), magnitude=1.0, **slider):
    return Sketch.of(scene(contact, effects, **slider), np.deg2rad(angle), magnitude)


def drawn(found, **options):
    """Marks of a picture, by kind."""
    marks = scene_picture(found, **options).marks
    return {
        each: [m for m in marks if isinstance(m, each)] for each in (Area, Line, Arrow, Dot, Label)
    }


def names(found):
    return [label.text for label in drawn(found)[Label]]


def arrows(marks, color):
    return [arrow for arrow in marks[Arrow] if arrow.color.lower() == color.lower()]


def points_of(mark):
    """Points of a mark; a label has none."""
    if isinstance(mark, Area):
        return np.concatenate(mark.rings)
    if isinstance(mark, (Line, Arrow)):
        return mark.points
    places = mark.strokes if isinstance(mark, Hatch) else getattr(mark, "place", ())
    return np.reshape(() if isinstance(mark, Label) else places, (-1, 2))


def same(one, other):
    """Whether two pictures have the same marks."""
    assert len(one.marks) == len(other.marks)
    for a, b in zip(one.marks, other.marks, strict=True):
        assert type(a) is type(b)
        assert points_of(a) == pytest.approx(points_of(b), abs=1e-12)
        assert [str(f) for f in a if isinstance(f, str)] == [
            str(f) for f in b if isinstance(f, str)
        ]


@pytest.mark.parametrize("effects", [(RING,), (RING, ASIDE), (INERTIA,), (supported(TRIPOD),)])
@pytest.mark.parametrize(
    ("contact", "angle"), [(coulomb(2), -10.0), (ROUGH, 135.0), (coulomb(0.5), 170.0)]
)
def test_a_scene_and_its_dataset_have_one_picture(contact, angle, effects):
    stored = Sketch.of_dataset(dataset(contact, angle, effects))
    same(scene_picture(stored), scene_picture(sketch(contact, angle, effects)))


@pytest.mark.parametrize(
    ("contact", "angle", "mode"),
    [
        (coulomb(2), -10, ContactMode.STICK),
        (coulomb(2), 170, ContactMode.SLIP_RIGHT),
        (coulomb(2), -90, ContactMode.SEPARATE),
        (NO_ADHESION, 165, None),
    ],
)
def test_a_sticking_solution_is_drawn_in_full_else_one_that_moves(contact, angle, mode):
    found = sketch(contact, angle)
    assert (found.solution.mode if found.solution else None) == mode
    modes = dataset(contact, angle)["mode"].values
    assert modes[best_row(modes)].tolist() == ([] if mode is None else [mode])
    if len(found.solutions) > 1:
        assert found.solutions[best(found.solutions, "SEPARATE")].mode == ContactMode.SEPARATE


@pytest.mark.parametrize(
    ("contact", "angle", "effects", "said"),
    [
        (ROUGH, -90, (RING,), r"$\mathbf{f}$ (adhesive)"),
        (coulomb(2), 44.9, (RING,), "radii away"),
        (coulomb(2), 44.9, (supported(SQUARE),), "half-widths away"),
        (coulomb(2), 60, (INERTIA,), r"\mathbf{a}_s = \mathbf{a}_p"),
        (coulomb(2), 60, (RING,), r"\mathbf{v}_s = \mathbf{v}_p"),
        (coulomb(2), 170, (RING,), r"\mathbf{v}_\mathrm{slip}"),
        (coulomb(2), 100, (supported(TRIPOD), ASIDE), "center\nof mass"),
        (coulomb(2), 100, (RING, ASIDE), "center\nof mass"),
        (coulomb(2), 100, (ASIDE,), "acceleration\ncenter"),
        (coulomb(2), 100, (RING,), "velocity\ncenter"),
    ],
)
def test_the_marks_are_named(contact, angle, effects, said):
    assert said in "; ".join(names(sketch(contact, angle, effects)))


def test_arrows_are_the_vectors_of_the_solution_to_one_scale():
    found = sketch(coulomb(2), 170)
    marks, one, scale = drawn(found), found.solution, found.motion_scale
    for color, vector in ((MOTION, one.contact_motion), (PUSHER, found.pusher)):
        (arrow,) = arrows(marks, color)
        assert arrow.points[1] == pytest.approx(scale * vector)
        assert not arrow.filled
    (slip,) = arrows(marks, SLIP)
    assert slip.points == pytest.approx(scale * np.array([found.pusher, one.contact_motion]))
    assert (slip.dash, slip.filled) == ("--", False)
    (force,) = arrows(marks, FORCE)
    assert force.points[1] == pytest.approx(found.force_scale(one) * one.force)
    assert force.filled


def test_other_solutions_are_pale_and_have_no_names():
    found = sketch(coulomb(2), -10)
    assert len(found.solutions) > 1
    moving = [each for each in found.solutions if np.any(each.force)]
    pale, marks = tint(FORCE, PALE), drawn(found)
    assert len(arrows(marks, pale)) == len(moving) - 1
    assert len(arrows(marks, FORCE)) == 1
    assert max(a.order for a in arrows(marks, pale)) < arrows(marks, FORCE)[0].order
    alone = replace(found, solutions=(found.solution,), chosen=0)
    assert names(alone) == names(found)


def test_a_slider_without_a_push_has_its_cones_alone():
    own = scene(coulomb(2))
    marks = drawn(Sketch.of(own))
    assert not marks[Arrow]
    cones = [area for area in marks[Area] if area.ink in (MOTION, FORCE)]
    assert [cone.ink for cone in cones] == [MOTION, FORCE]
    edges = [pp.motion_cone(own), pp.friction_cone(own)]
    for cone, edge in zip(cones, edges, strict=True):
        ends = cone.rings[0][[1, -1]]
        assert np.arctan2(*ends.T[::-1]) == pytest.approx([float(edge.right), float(edge.left)])
    assert not [a for a in drawn(Sketch.of(own), cones=False)[Area] if a.ink in (MOTION, FORCE)]


def test_a_pivot_is_named_and_its_forces_are_a_fan():
    found = sketch(ROUGH, 135, (supported(TRIPOD),))
    marks, said = drawn(found, cones=False), names(found)
    assert "pivot" in said
    assert "velocity\ncenter" not in said
    (fan,) = (area for area in marks[Area] if area.ink == FORCE)
    right, left = (np.arctan2(*each[::-1]) for each in forces(found.solution))
    turns = np.unwrap(np.arctan2(*fan.rings[0][1:].T[::-1]))
    assert 0 < turns[-1] - turns[0] < np.pi
    assert np.cos(turns[[0, -1]] - [right, left]) == pytest.approx(1)
    assert len(arrows(marks, FORCE)) == 2
    assert len([dot for dot in marks[Dot] if dot.edge == CENTER.lower()]) == 3


def test_a_settled_force_has_no_fan():
    found = sketch(ROUGH, 100, (supported(TRIPOD),))
    assert not [area for area in drawn(found, cones=False)[Area] if area.ink == FORCE]
    assert len(forces(found.solution)) == 1


@pytest.mark.parametrize(("angle", "near"), [(100.0, True), (44.9, False)])
def test_a_near_center_is_marked_and_a_far_one_pointed_to(angle, near):
    found = sketch(coulomb(2), angle)
    one, marks = found.solution, drawn(found)
    assert found.is_near(one) == near == (found.distance(one) < FAR * found.span)
    marked = [dot.position for dot in marks[Dot] if CENTER.lower() in (dot.edge, dot.face)]
    assert all(place == pytest.approx(one.center) for place in marked)
    assert bool(marked) == near
    (guide,) = (line.points for line in marks[Line] if line.color == CENTER.lower())
    toward = guide[1] - guide[0]
    away = one.center - found.center
    assert toward @ away == pytest.approx(np.hypot(*toward) * np.hypot(*away))


def test_a_translation_has_no_center():
    assert "center" not in " ".join(names(sketch(coulomb(1), 90, rod_length=0.0)))


def test_a_finger_takes_the_place_of_the_fence():
    own = scene(coulomb(0.5))
    found = Sketch.of(own, np.deg2rad(100), side=(-0.5, np.inf))
    marks = scene_picture(found).marks
    assert not [mark for mark in marks if isinstance(mark, Hatch)]
    (side,) = (m.points for m in marks if isinstance(m, Line) and (m.points[:, 1] == 0).all())
    assert side[0].tolist() == [-0.5, 0]
    assert side[1, 0] == pytest.approx(1.5 * found.reach)
    assert [
        mark.position.tolist() for mark in marks if isinstance(mark, Dot) and mark.edge == PUSHER
    ] == [[0, 0]]


def test_a_finger_of_finite_radius_is_below_its_side():
    found = Sketch.of(scene(coulomb(0.5)), np.deg2rad(100), side=(-0.5, np.inf), finger_radius=0.3)
    (rim,) = (
        m.points for m in scene_picture(found).marks if isinstance(m, Line) and m.color == PUSHER
    )
    assert rim.max(axis=0) == pytest.approx([0.3, 0.0])
    assert rim.min(axis=0) == pytest.approx([-0.3, -0.6])
    assert found.box[0, 1] <= -0.6
    huge = Sketch.of(scene(coulomb(0.5)), np.deg2rad(100), side=(-0.5, np.inf), finger_radius=1e3)
    assert np.ptp(huge.box[:, 1]) < 4 * found.span


@pytest.mark.parametrize(("length", "whole"), [(0.3, 0.2), (1.0, 1.0), (79.0, 50.0), (2e-4, 2e-4)])
def test_a_scale_has_a_round_length_and_lies_in_the_corner(length, whole):
    picture = Picture()
    add_scale(picture, np.array([(-1.0, -2.0), (3.0, 4.0)]), length)
    bar, label = picture.marks
    assert bar.points == pytest.approx(np.array([(3 - whole, -2), (3, -2)]))
    assert (float(label.text), label.held) == (whole, True)


def test_the_friction_of_points_is_in_the_ratio_of_their_weights():
    found = sketch(coulomb(0.5), 100, (supported(pp.Points([(1, 0), (-1, 0)], [1, 3])),))
    places, pulls = found.rubbing
    assert len(places) == 2
    assert np.hypot(*pulls.T) == pytest.approx([0.25, 0.75])
    lengths = [
        np.hypot(*np.diff(a.points, axis=0)[0]) for a in arrows(drawn(found), tint(FORCE, 0.62))
    ]
    assert lengths[1] == pytest.approx(3 * lengths[0])
    assert not arrows(drawn(found, friction=False), tint(FORCE, 0.62))


@pytest.mark.parametrize("name", SUPPORTS)
@pytest.mark.parametrize("angle", [90.0, 170.0, -90.0])
def test_the_box_holds_all_that_is_drawn_of_any_support(name, angle):
    found = sketch(coulomb(0.5), angle, (supported(SUPPORTS[name][0]),))
    one = () if found.solution is None else (found.solution,)
    low, high = found.box
    slack = 1e-9 + 0.03 * found.half
    for mark in scene_picture(replace(found, solutions=one, chosen=len(one) - 1)).marks:
        points = points_of(mark)
        assert np.isfinite(points).all()
        assert ((points >= low - slack) & (points <= high + slack)).all(), mark


LAWS = st.one_of(
    st.floats(0, 1e6).map(coulomb),
    st.sampled_from([{"law": "infinite_friction"}, NO_ADHESION, ROUGH]),
)


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
    found = sketch(contact, angle, **rest)
    picture = scene_picture(found)
    assert all(np.isfinite(points_of(mark)).all() for mark in picture.marks)
    assert "nan" not in to_svg(picture, found.box, (300, 300))


# -- limit curves ------------------------------------------------------------------------------------


def curved(effect, angle, contact):
    own = scene(contact, (effect,))
    return with_curve(Sketch.of(own, np.deg2rad(angle)), own)


@pytest.mark.parametrize("effect", [RING, supported(TRIPOD)])
@pytest.mark.parametrize(
    ("angle", "contact"), [(100.0, coulomb(0.5)), (-90.0, coulomb(0.5)), (135.0, ROUGH)]
)
def test_the_picture_holds_the_curve_and_the_forces_end_on_it(effect, angle, contact):
    found = curved(effect, angle, contact)
    curve, (low, high) = found.curve_scale * found.curve, found.box
    assert ((curve >= low) & (curve <= high)).all()
    assert any(
        line.points == pytest.approx(curve)
        for line in drawn(found)[Line]
        if len(line.points) == len(curve)
    )
    ends = [] if angle < 0 else forces(found.solution)
    assert len(ends) == {100.0: 1, -90.0: 0, 135.0: 1 if effect is RING else 2}[angle]
    for force in ends:
        tip = found.force_scale(found.solution) * force
        assert np.hypot(*(curve - tip).T).min() < 0.02 * found.reach


def test_a_foot_about_which_the_tripod_pivots_has_a_flat_for_either_sense():
    assert len(curved(RING, 100, coulomb(0.5)).flats) == 0
    found = curved(supported(TRIPOD), 100, coulomb(0.5))
    one, other = (found.curve[part] for part in found.flats)
    assert one == pytest.approx(-other, abs=1e-9)
    for flat in (one, other):
        ends = flat[-1] - flat[0]
        assert np.abs((flat - flat[0]) @ [-ends[1], ends[0]]).max() < 1e-9
    heavy = [line.points for line in drawn(found)[Line] if (line.color, line.width) == (FORCE, 2.6)]
    assert heavy == [pytest.approx(found.curve_scale * each) for each in (one, other)]


def test_friction_and_inertia_have_no_one_curve():
    both = scene(coulomb(1.0), (RING, INERTIA))
    with pytest.raises(
        pp.InvalidValue, match=r"limit_curve: .*leave the limit curve out, or list one"
    ):
        with_curve(Sketch.of(both), both)
