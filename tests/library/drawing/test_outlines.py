"""Pictures of outlines with arcs and holes, and of what touches them over time."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.drawing.animate import resample
from planar_pushing.drawing.body import FLAT, Body, add_body, body_of
from planar_pushing.drawing.canvas.marks import Area, Picture
from planar_pushing.drawing.supports import Pose
from planar_pushing.drawing.timeline import (
    contact,
    contact_jumps,
    finger_center,
    is_at_first_contact,
    normal,
    path_data,
    touching_wall,
)

BOX = [(-0.1, -0.05), (0.1, -0.05), (0.1, 0.05), (-0.1, 0.05)]
TEE = [(-60, 0), (-15, 0), (-15, -90), (15, -90), (15, 0), (60, 0), (60, 30), (-60, 30)]
HOLES = [pp.Disc(8, center=(0, 12)), [(-50, 10), (-40, 10), (-40, 20), (-50, 20)]]
#: Outlines, each with the area that it encloses.
OUTLINES = {
    "disc": (pp.Outline(pp.Disc(0.04)), np.pi * 0.04**2),
    "rounded": (pp.rounded(BOX, 0.02), 0.02 - (4 - np.pi) * 0.02**2),
    "tee": (pp.Outline(TEE, holes=HOLES), 120 * 30 + 30 * 90 - 64 * np.pi - 100),
    "ellipse": (pp.Outline.ellipse(0.06, 0.04), np.pi * 0.06 * 0.04),
    "round hole": (pp.Outline(BOX, holes=[pp.Disc(0.03, (0.05, 0.0))]), 0.02 - 9e-4 * np.pi),
}  # fmt: skip


def enclosed(ring):
    """Signed area of a closed polygon."""
    x, y = np.transpose(ring)
    return (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def scene(outline, point, mu=0.4, support=None):
    friction = pp.SupportFriction(support=support or pp.Ring(0.02 * outline.size))
    return pp.scene_at(point, outline=outline, contact=pp.Coulomb(mu), effects=(friction,))


@pytest.mark.parametrize("name", OUTLINES)
def test_the_drawn_area_is_that_of_the_outline(name):
    outline, area = OUTLINES[name]
    start = outline.vertices()[0]
    x, y = start + 0.5 * (outline.vertices()[1] - start) * np.isinf(outline.pieces[0, 2])
    body = body_of(scene(outline, (float(x), float(y))))
    picture = Picture()
    add_body(picture, Body(support=pp.Ring(1.0), outline=body.outline), Pose((0.3, 0.1), 0.4))
    (rings,) = (mark.rings for mark in picture.marks if isinstance(mark, Area))
    assert sum(map(enclosed, rings)) == pytest.approx(area, abs=6 * FLAT * outline.size**2)
    assert len(rings) == len(body.outline)


def test_an_outline_equal_to_the_support_is_drawn_once():
    plate = pp.Polygon(BOX, holes=[[(-0.01, -0.01), (0.01, -0.01), (0.01, 0.01), (-0.01, 0.01)]])
    assert body_of(scene(pp.Outline(plate), (0.02, -0.05), support=plate)).outline == ()
    bare = scene(pp.Outline(plate), (0.02, -0.05), support=pp.Polygon(BOX))
    assert len(body_of(bare).outline) == 2


@pytest.fixture(scope="module")
def rolled():
    """A mug around which a finger rolls and then slips."""
    mug = scene(pp.Outline(pp.Disc(0.04)), (0.0, -0.04), support=pp.Ring(0.04))
    finger = pp.Pusher(velocity=(0.02, 0.05), shape="finger", radius=0.008)
    return path_data(pp.simulate(mug, pusher=finger, duration=2))


@pytest.mark.parametrize(("count", "slack"), [(None, 1e-8), (37, 1e-4)], ids=["rows", "frames"])
def test_a_finger_touches_a_round_wall_toward_its_center(rolled, count, slack):
    data = rolled if count is None else resample(rolled, count)
    toward = data["path_position"].values - finger_center(data)
    assert np.hypot(*toward.T) == pytest.approx(0.048, abs=slack * 0.04)
    toward /= np.hypot(*toward.T)[:, None]
    np.testing.assert_allclose(normal(data), toward, atol=1e-8)
    np.testing.assert_allclose(contact(data), finger_center(data) + 0.008 * toward, atol=1e-8)
    assert np.ptp(np.arctan2(*toward.T)) > 0.5  # it went round


def test_a_finger_goes_from_a_side_round_a_corner():
    box = scene(pp.Outline(BOX), (0.095, -0.05), mu=0.1, support=pp.Polygon(BOX))
    finger = pp.Pusher(velocity=(0.05, 0.1), shape="finger", radius=0.02)
    data = path_data(pp.simulate(box, pusher=finger, duration=0.6))
    length = np.hypot(*np.diff(data["path_side"].values, axis=1)[:, 0].T)
    assert length[0] == pytest.approx(0.2)
    corner = length < 1e-3
    assert corner.any()
    assert not corner[0]
    # At the corner the finger touches the same point of the box.
    turn = np.deg2rad(data["path_rod_angle"].values - data["path_rod_angle"].values[0])
    arm = contact(data) - data["path_position"].values
    c, s = np.cos(turn), np.sin(turn)
    on_box = np.stack([c * arm[:, 0] + s * arm[:, 1], c * arm[:, 1] - s * arm[:, 0]], axis=-1)
    np.testing.assert_allclose(on_box[corner], [(0.1, -0.05)] * corner.sum(), atol=1e-8)


def test_the_contact_of_a_disc_on_a_fence_moves_without_jumps():
    disc = scene(pp.Outline(pp.Disc(1.0)), (0.0, -1.0), mu=0.2, support=pp.Ring(1.0))
    data = path_data(pp.simulate(disc, pusher=pp.Pusher(velocity=(1.0, 1.0)), duration=2))
    assert data.sizes["time"] > 2
    assert not contact_jumps(data).size
    assert np.ptp(touching_wall(data)) == 0
    np.testing.assert_allclose(contact(data)[:, 0], data["path_position"].values[:, 0], atol=1e-8)
    assert is_at_first_contact(data, 0)
    assert not is_at_first_contact(data, -1)  # another point of the disc


def test_a_square_that_turns_over_a_corner_still_jumps():
    square = pp.scene_at(
        (-1, -1), (0.3, 1), outline=[(-1, -1), (1, -1), (1, 1), (-1, 1)], contact=pp.Coulomb(0.5),
        effects=(pp.SupportFriction(support=pp.Disc(1.0)),),
    )  # fmt: skip
    data = path_data(pp.simulate(square, pusher=pp.Pusher(velocity=(0.0, 1.0)), duration=3))
    assert data["path_flush"].values[-1]
    assert contact_jumps(data).size == 1
