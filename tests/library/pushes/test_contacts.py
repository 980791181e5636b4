"""Contacts of pushes: one at a side, three at a corner, of which one is chosen."""

import numpy as np
import pytest
from pushes.written import SQUARE, turn

import planar_pushing as pp
from planar_pushing.pushes.fit.ellipsoid import Ellipsoid
from planar_pushing.pushes.fit.supported import OnSupport
from planar_pushing.pushes.logs.contacts import Ends, choose, contacts_of, final_poses
from planar_pushing.pushes.logs.measured import measurements_of

FEET = pp.Points(SQUARE, [1, 1, 1, 1])
TRIANGLE = [(0, 0), (3, 0), (0, 3)]
#: Both friction models of the square.
MODELS = {"support": OnSupport(FEET), "ellipsoid": Ellipsoid(np.diag([1.0, 1.0, 0.5]))}


def at(places, ways, radius=0.0, outline=SQUARE):
    """Pushes of the square whose finger touches these places, which it carries along."""
    count = len(places)
    after = np.column_stack([np.broadcast_to(ways, (count, 2)), np.zeros(count)])
    return measurements_of(pp.pushes_from_poses(
        outline=outline, poses_before=np.zeros((count, 3)), poses_after=after,
        finger_start=np.array(places), finger_end=np.array(places) + ways, finger_radius=radius,
        units=("mm", "N"),
    ))  # fmt: skip


def test_a_side_has_one_contact_and_a_corner_three():
    pushes = at([(0.5, -1), (1, 1), (-1, 0.25)], [(0, 0.2), (-0.2, -0.2), (0.2, 0)])
    found = contacts_of(pushes)
    assert found.push.tolist() == [0, 1, 1, 1, 2]
    assert found.sticks.tolist() == [False, False, False, True, False]
    diagonal = -np.sqrt(0.5)
    expected = np.array([(0, 1), (-1, 0), (0, -1), (diagonal, diagonal), (1, 0)])
    assert found.normal == pytest.approx(expected)
    # Along the lower side +x, along the left one -y; at a corner one side begins where the other ends.
    assert found.start == pytest.approx([-1.5, -2.0, 0.0, -np.inf, -0.75], abs=1e-8)
    assert found.end == pytest.approx([0.5, 0.0, 2.0, np.inf, 1.25], abs=1e-8)
    assert (found.start < 0).all()
    assert (found.end > 0).all()
    ends = found.point + found.end[:, None] * found.tangent
    assert ends[[0, 1, 2, 4]] == pytest.approx(np.array([(1, -1), (1, 1), (-1, 1), (-1, -1)]))
    assert found.aligned == pytest.approx([1, -diagonal, -diagonal, 1, 1])
    assert found.path[:, 0].tolist() == pushes.finger[found.push].tolist()


def test_a_corner_that_sticks_is_a_point():
    """A finger that does not turn carries a material point of the object along, whatever its radius."""
    pushes = at([(1.25, 0)], [(-0.5, 0)], radius=0.25)
    side = contacts_of(pushes)
    assert side.radius.tolist() == [0.25]
    corner = measurements_of(pp.pushes_from_poses(
        outline=SQUARE, poses_before=np.zeros((1, 3)), poses_after=[(-0.18, -0.18, 0)],
        finger_start=[(1.5, 1.5)], finger_end=[(1.0, 1.0)], finger_radius=0.25, units=("mm", "N"),
    ))  # fmt: skip
    assert corner.at_corner.tolist() == [True]
    found = contacts_of(corner)
    assert found.radius.tolist() == [0.25, 0.25, 0.0]
    assert found.point == pytest.approx(np.ones((3, 2)))


@pytest.mark.parametrize(("radius", "reach"), [(0.0, 0.5), (0.1, 0.4), (0.25, 0.25)])
def test_the_contact_ends_where_the_finger_meets_another_side(radius, reach):
    """In the notch of an L, it comes no closer to the corner than the radius."""
    ell = [(-1, -1), (1, -1), (1, 0), (0, 0), (0, 1), (-1, 1)]
    pushes = at([(radius, 0.5), (0.5, radius)], [(-0.01, -0.5), (-0.5, -0.01)], radius, ell)
    found = contacts_of(pushes)
    assert found.start == pytest.approx([-reach, -0.5], abs=1e-8)
    assert found.end == pytest.approx([0.5, reach], abs=1e-8)
    # Along the side: the finger does little more than slide, and the object stays behind it then.
    for model in (OnSupport(pp.Points(ell, [1] * 6)), Ellipsoid(np.diag([1.0, 1.0, 0.5]))):
        assert model.ends(found, 0.0).lasted == pytest.approx(2 * reach, abs=0.02)


@pytest.mark.parametrize("name", MODELS)
def test_a_symmetric_corner_is_pushed_alike_on_either_side(name):
    """Along the bisector: mirrored poses, and either side lasts to the end."""
    pushes = at([(1, 1)], [(-0.2, -0.2)])
    contacts = contacts_of(pushes)
    ends = MODELS[name].ends(contacts, 0.1)
    one, other, stuck = ends.poses
    assert one == pytest.approx(other[[1, 0, 2]] * [1, 1, -1], abs=1e-6)
    assert abs(one[2]) > 0.05
    assert ends.lasted == pytest.approx(1.0)
    assert stuck == pytest.approx([-0.2, -0.2, 0.0], abs=1e-6)
    found = final_poses(MODELS[name], pushes, 0.1)[0]
    assert min(abs(found - one).max(), abs(found - other).max()) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("turned", [0, 1, 2, 3])
def test_a_push_that_slides_onto_one_side(name, turned):
    """The normal of the finger is the nearest of two sides that both last; also at the other corners."""
    matrix = turn(turned * np.pi / 2)
    pushes = at(np.array([(1, 1)]) @ matrix.T, np.array([(-0.3, -0.1)]) @ matrix.T)
    contacts = contacts_of(pushes)
    ends = MODELS[name].ends(contacts, 0.1)
    side = int(np.argmax(contacts.aligned[:2]))
    found = final_poses(MODELS[name], pushes, 0.1)[0]
    assert found == pytest.approx(ends.poses[side], abs=1e-12)
    # The side x = 1: pushed at its upper end towards -x it turns counterclockwise.
    assert matrix.T @ contacts.normal[side] == pytest.approx([-1, 0], abs=1e-12)
    x, y = matrix.T @ found[:2]
    assert x < -0.05
    assert abs(y) < 0.1
    assert found[2] > 0.02


@pytest.mark.parametrize("model", [
    OnSupport(pp.Points(TRIANGLE, [1, 1, 1])), Ellipsoid.about(np.array([1, 1]), np.diag([1, 1, 0.4])),
])  # fmt: skip
@pytest.mark.parametrize("mirrored", [False, True])
def test_a_push_that_leaves_one_side_at_once_pushes_the_other(model, mirrored):
    """At a sharp corner, along the bisector but for 7 degrees: both normals are equally near."""
    angle = np.deg2rad(210)
    place, way = np.array([(3, 0)]), 0.2 * np.array([(np.cos(angle), np.sin(angle))])
    if mirrored:
        place, way = place[:, ::-1], way[:, ::-1]
    pushes = at(place, way, outline=TRIANGLE)
    ends = model.ends(contacts_of(pushes), 0.1)
    left, pushed = (1, 0) if mirrored else (0, 1)
    assert ends.lasted[left] < 1e-3
    assert ends.lasted[pushed] == pytest.approx(1.0, abs=0.02)
    found = final_poses(model, pushes, 0.1)[0]
    assert found == pytest.approx(ends.poses[pushed])
    assert np.hypot(*found[:2]) > 0.02


def test_a_push_that_leaves_both_sides_at_once_sticks():
    """Past an end of a long object, with little friction."""
    long = [(0, 0), (6, 0), (6, 1), (0, 1)]
    pushes = at([(6, 0)], [(0.1, 0.2)], outline=long)
    model = OnSupport(pp.Points(long, [1, 1, 1, 1]))
    contacts = contacts_of(pushes)
    ends = model.ends(contacts, 0.05)
    assert (ends.lasted[:2] < 1e-3).all()
    assert final_poses(model, pushes, 0.05)[0] == pytest.approx(ends.poses[2])
    assert np.hypot(*ends.poses[2, :2]) > 0.01


@pytest.mark.parametrize("name", MODELS)
def test_much_friction_sticks_on_either_side(name):
    """The corner then moves with the finger, whichever contact is chosen."""
    way = np.array([-0.2, -0.15])
    found = final_poses(MODELS[name], at([(1, 1)], [way]), 1e6)[0]
    corner = turn(found[2]) @ (1, 1) + found[:2]
    assert corner == pytest.approx(1 + way, abs=1e-5)


def some(lasted, aligned, sticks):
    """Contacts of one push at a corner, whose poses are their numbers."""
    contacts = contacts_of(at([(1, 1)], [(-0.2, -0.2)]))
    object.__setattr__(contacts, "aligned", np.array(aligned))
    object.__setattr__(contacts, "sticks", np.array(sticks))
    return contacts, Ends(np.repeat(np.arange(3.0)[:, None], 3, axis=1), np.array(lasted))


@pytest.mark.parametrize(("lasted", "aligned", "number"), [
    ([0.5, 1.0, 1.0], [0.9, 0.1, 1.0], 1), ([1.0, 0.5, 1.0], [0.1, 0.9, 1.0], 0),
    ([1.0, 1.0, 1.0], [0.6, 0.8, 1.0], 1), ([1.0, 1.0 - 1e-9, 1.0], [0.6, 0.8, 1.0], 1),
    ([0.0, 0.0, 1.0], [0.6, 0.8, 1.0], 2), ([0.0, 0.02, 1.0], [0.6, 0.8, 1.0], 1),
])  # fmt: skip
def test_the_side_that_lasts_longest_is_chosen(lasted, aligned, number):
    contacts, ends = some(lasted, aligned, [False, False, True])
    assert choose(contacts, ends).tolist() == [[number] * 3]


def test_pushes_stay_in_order():
    """Final poses of sides and corners together are those of each alone."""
    places, ways = [(1, 1), (0, -1), (-1, 1)], np.array([(-0.3, -0.1), (0.05, 0.2), (0.1, -0.3)])
    together = final_poses(MODELS["support"], at(places, ways), 0.2)
    for k in range(3):
        alone = final_poses(MODELS["support"], at([places[k]], ways[[k]]), 0.2)
        assert together[k] == pytest.approx(alone[0], abs=1e-12)
