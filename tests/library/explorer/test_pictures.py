"""The pictures, against the mechanics."""

from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.drawing.canvas.colors import FORCE, MOTION, PUSHER
from planar_pushing.drawing.canvas.labels import settle
from planar_pushing.drawing.canvas.marks import Area, Arrow
from planar_pushing.drawing.words import best, outcome
from planar_pushing.explorer.boundary import place_at
from planar_pushing.explorer.objects import object_of, with_contact, with_object_size
from planar_pushing.explorer.own_outline import BOX, with_kind
from planar_pushing.explorer.pictures import curve, maps
from planar_pushing.explorer.pictures.following import energies, follow
from planar_pushing.explorer.pictures.handles import handle_positions
from planar_pushing.explorer.pictures.layout import RADIUS, Held, nearest_spot
from planar_pushing.explorer.pictures.pictures import (
    LONG,
    instant_picture,
    push_box,
    push_picture,
    solve_push,
    spots_of,
    time_picture,
)
from planar_pushing.explorer.presets import PUSHES, preset
from planar_pushing.explorer.state import Handle, with_law, with_push, with_rod, with_simulation
from planar_pushing.explorer.view import Order, map_markup, sheet_of, sheet_of_push, view

PRESETS = list(PUSHES)
SIZES = dict.fromkeys(("scene", "curve", "map", "time"), (700.0, 480.0))


def shown(state):
    """The page's markup of a state, each a tree of SVG or HTML."""
    found = view(Order(state, SIZES, push_box(state)))
    trees = {name: ElementTree.fromstring(f"<x>{text}</x>") for name, text in found.markup.items()}
    return found, trees


SHEETS = {"wide": (700.0, 480.0), "phone": (370.0, 320.0)}


def boxes_of_labels(picture, sheet):
    """Texts of the labels of a picture, and the corners of their boxes in pixels."""
    found = []
    for label in settle(picture, sheet):
        half = sheet.point * np.array(label.extent) / 2
        middle = sheet.to_sheet(label.position) + sheet.point * np.array([1.0, -1.0]) * label.offset
        middle[0] += {"left": 1.0, "right": -1.0}.get(label.align, 0.0) * half[0]
        found.append((label.text, np.array([middle - half, middle + half])))
    return found


def distance(box, point):
    return np.hypot(*np.maximum(np.maximum(box[0] - point, point - box[1]), 0.0))


def covered_labels(state, size):
    """Names of the labels that a handle or the name of a handle covers."""
    push, sheet = solve_push(state), sheet_of(size, push_box(state))
    spots = spots_of(push, sheet)
    labels = boxes_of_labels(push_picture(push, sheet), sheet)
    found = [
        text
        for text, box in labels
        for spot in spots.values()
        if distance(box, spot.center) < RADIUS
    ]
    names = [(text, box) for text, box in labels if text in spots]
    for text, box in names:
        others = [other for name, other in labels if name != text]
        found += [text for other in others if ((box[0] < other[1]) & (other[0] < box[1])).all()]
    return found


@pytest.mark.parametrize("angle", range(-170, 181, 25))
@pytest.mark.parametrize("name", ["figure_03", "figure_08", "box", "tripod", "mug"])
def test_no_handle_covers_a_label(name, angle):
    state = preset(name)
    assert covered_labels(with_push(state, float(angle), state.magnitude), SHEETS["wide"]) == []


def slow_box():
    """A box whose slow push at the middle of a side has a short arrow."""
    box = preset("box")
    return with_contact(with_push(box, 90.0, 0.01), place_at(object_of(box).outline, 0.15))


#: Pushes whose pusher, line of force, center and contact are on one line, or at one point.
SYMMETRIC = {
    "box": lambda: with_kind(preset("figure_03"), BOX),
    "upright rod": lambda: with_rod(with_push(preset("figure_03"), 90.0, 1.0), 1.0, 90.0),
    "no rod": lambda: with_rod(preset("figure_03"), 0.0, 90.0),
    "slow": lambda: with_rod(with_push(preset("figure_13"), 90.0, 0.01), 1.0, 90.0),
    "slow box": slow_box,
    "tiny box": lambda: with_object_size(preset("box"), 1e-6),
}


@pytest.mark.parametrize("size", SHEETS.values(), ids=SHEETS)
@pytest.mark.parametrize("name", SYMMETRIC)
def test_no_handle_hides_another_one(name, size):
    push = solve_push(state := SYMMETRIC[name]())
    sheet = sheet_of(size, push_box(state))
    spots = spots_of(push, sheet)
    centers = np.array([spot.center for spot in spots.values()])
    for i, center in enumerate(centers):
        apart = np.hypot(*(np.delete(centers, i, axis=0) - center).T)
        assert apart.min() >= 2.0 * RADIUS
        assert ((center >= 0.0) & (center <= sheet.size)).all()
        assert nearest_spot(spots, center) == list(spots)[i]
    own = Handle.CONTACT if state.has_outline else Handle.ROD
    assert set(spots) - {Handle.LINE} == {Handle.PUSHER, Handle.SIZE, own}
    assert (Handle.LINE in spots) == np.any(push.force)


def test_the_map_of_another_direction_or_unit_is_known():
    state = preset("box")
    *_, fine = maps.maps(state)
    turned = replace(with_push(state, 20.0, state.magnitude), unit="cm")
    assert np.array_equal(maps.quick_map(turned).codes, fine.codes)


@pytest.mark.parametrize("name", SYMMETRIC)
def test_the_name_of_a_handle_touches_it(name):
    push = solve_push(state := SYMMETRIC[name]())
    sheet = sheet_of(SHEETS["wide"], push_box(state))
    spots = spots_of(push, sheet)
    labels = dict(boxes_of_labels(push_picture(push, sheet), sheet))
    for name in spots:
        nearby = {other: distance(labels[name], at.center) for other, at in spots.items()}
        assert nearby[name] < 2.0 * RADIUS
        assert min(nearby, key=nearby.get) == name


def test_a_handle_that_is_held_keeps_its_offset_and_the_others_make_room():
    state = with_kind(preset("figure_03"), BOX)
    push = solve_push(state)
    sheet = sheet_of(SIZES["scene"], push_box(state))
    held = spots_of(push, sheet, Held(Handle.PUSHER, (12.0, 5.0)))
    assert held[Handle.PUSHER].offset == pytest.approx((12.0, 5.0))
    rest = [spot.center for name, spot in held.items() if name != Handle.PUSHER]
    assert np.hypot(*(np.array(rest) - held[Handle.PUSHER].center).T).min() >= 2.0 * RADIUS


def test_an_object_keeps_its_place_while_its_contact_is_dragged():
    """Every corner of the box is where it was on the sheet, and the contact is at the pointer."""
    state = preset("box")
    body, box = object_of(state), push_box(state)
    place = place_at(body.outline, 0.4)
    order = Order(
        with_contact(state, place), SIZES, box, 0, Held(Handle.CONTACT, (0.0, 0.0)), state
    )
    turned, before = sheet_of_push(order), sheet_of(SIZES["scene"], box)
    after = object_of(order.state)
    for corner in body.outline.corners:
        pixel = before.to_sheet(body.fence.point_in(corner))
        np.testing.assert_allclose(turned.to_sheet(after.fence.point_in(corner)), pixel, atol=1e-6)
        np.testing.assert_allclose(turned.to_scene(pixel), after.fence.point_in(corner), atol=1e-9)
    contact = before.to_sheet(body.fence.point_in(place.point))
    np.testing.assert_allclose(turned.to_sheet((0.0, 0.0)), contact, atol=1e-6)
    assert view(order).markup["scene"] != view(order._replace(grabbed=None)).markup["scene"]


def arrows(picture, color):
    return [
        mark.points
        for mark in picture.marks
        if isinstance(mark, Arrow) and mark.color.lower() == color.lower()
    ]


@pytest.mark.parametrize("name", PRESETS)
def test_every_preset_is_shown_with_its_handles_in_their_places(name):
    state = preset(name)
    found, trees = shown(state)
    sheet = sheet_of(SIZES["scene"], push_box(state))
    circles = {each.get("data-handle"): each for each in trees["scene"].iter("circle")}
    spots = spots_of(found.push, sheet)
    for handle, place in handle_positions(state, found.push.force).items():
        pixel = [float(circles[handle].get(key)) for key in ("cx", "cy")]
        np.testing.assert_allclose(pixel, spots[handle].center, atol=0.1)
        if handle != Handle.LINE:
            np.testing.assert_allclose(sheet.to_scene(spots[handle].anchor), place, atol=1e-9)
        assert f">{handle}</tspan>" in found.markup["scene"]
    assert len(list(trees["solutions"].iter("tr"))) == 1 + len(found.push.solutions)
    assert found.markup["words"] == outcome(
        found.push.solutions, found.push.sketch.pusher, found.push.chosen
    )


def test_the_arrows_are_the_solutions():
    push = solve_push(with_push(preset("figure_03"), -15.0, 1.0))
    picture = push_picture(push)
    assert len(push.solutions) == 3
    (force,), (motion,) = (arrows(picture, color) for color in (FORCE, MOTION))
    stick = push.solutions[push.chosen]
    for points, vector in ((force, stick.force), (motion, stick.contact_motion)):
        angles = [np.arctan2(*each[::-1]) for each in (points[-1] - points[0], vector)]
        assert angles[0] == pytest.approx(angles[1])


@pytest.mark.parametrize(
    "name", ["figure_03", "figure_13", "figure_09a", "tripod", "pulling_with_inertia"]
)
@pytest.mark.parametrize("magnitude", [0.2, 1.0, 3.0])
def test_the_force_lies_on_the_limit_curve_and_the_motion_is_its_normal(name, magnitude):
    state = with_push(with_law(preset(name), {"law": "perfectly_rough"}), 40.0, magnitude)
    (solution,) = (
        each for each in solve_push(state).solutions if each.mode == pp.ContactMode.STICK
    )
    found = curve.curve_at(state.scene, curve.level(state.scene, solution))
    angle = np.arctan2(*solution.force[::-1]) % (2 * np.pi)
    if len(state.scene.rows.entries) > 1:
        there = np.interp(angle, found.force_angle, found.magnitude)
        assert there == pytest.approx(np.hypot(*solution.force), rel=3e-3)
    normal = np.interp(angle, found.force_angle, np.unwrap(found.motion_angle))
    assert np.cos(normal - np.deg2rad(40.0)) == pytest.approx(1.0, abs=2e-3)


@pytest.mark.parametrize("name", ["figure_03", "figure_13", "tripod", "slipping"])
def test_the_map_is_the_modes_of_single_pushes(name):
    for across in maps.axes_of(preset(name)):
        state = replace(preset(name), across=across)
        found = maps.mode_map(state, (8, 5))
        assert maps.axis_of(state) == across
        for row, column in [(0, 0), (2, 3), (5, 1), (7, 4)]:
            place = np.array([maps.WIDE * (column + 0.5) / 5, (row + 0.5) / 8])
            there = solve_push(maps.state_at(state, place)).solutions
            assert found.codes[row, column] == sum({1 << each.mode for each in there})


def test_a_map_covers_its_cells_and_names_every_set_of_modes():
    state = preset("figure_03")
    found = maps.mode_map(state, (36, 15))
    areas = [mark for mark in maps.map_picture(state, found).marks if isinstance(mark, Area)]
    sizes = [np.prod(np.ptp(ring, axis=0)) for area in areas for ring in area.rings]
    assert sum(sizes) == pytest.approx(maps.WIDE)
    legend = map_markup(state, found, (350.0, 260.0))["legend"]
    assert legend.count('class="key"') == len(areas)
    assert "other" not in legend


@pytest.mark.parametrize("name", ["figure_03", "figure_13"])
def test_a_click_on_the_cross_stays_there(name):
    for across in maps.axes_of(preset(name)):
        state = replace(preset(name), across=across)
        there = maps.state_at(state, maps.position_of(state))
        assert there.scene == state.scene
        assert (there.angle, there.magnitude) == pytest.approx((state.angle, state.magnitude))


def test_no_motion_is_said_too():
    state = with_law(preset("figure_08"), {"law": "infinite_friction", "at_zero_normal": "none"})
    found, _ = shown(state)
    assert found.push.solutions == ()
    assert best(()) == -1
    assert found.markup["words"] == "No motion of the slider is consistent with this push."


@pytest.mark.parametrize(
    "name", ["pulling", "tripod", "impact", "box", "box_side", "mug", "rounded_box"]
)
def test_a_motion_is_shown_at_every_instant(name):
    motion = follow(preset(name))
    end = float(motion.times[-1])
    for time in np.linspace(0, end, 5):
        found, _ = shown(replace(preset(name), time=float(time)))
        assert found.motion is motion
        assert (found.markup["when"] == "of the push at the start") == (found.instant is None)
        assert found.markup["map-when"] == found.markup["when"]
        subject = found.instant or preset(name)
        quick = map_markup(subject, maps.quick_map(subject), SIZES["map"])
        assert found.markup["areas"] == quick["areas"]
        assert instant_picture(motion, float(time)).marks
    areas = (mark for mark in time_picture(motion).marks if isinstance(mark, Area))
    bar = [mark.rings[0] for mark in areas if mark.hatch != "|"]
    assert np.sum([np.ptp(ring[:, 0]) for ring in bar]) == pytest.approx(LONG)


def test_the_energies_add_up():
    found = energies(follow(preset("pulling")))
    total = found["support friction"] + found["contact friction"] + found["kinetic energy"]
    np.testing.assert_allclose(found["work"], total, atol=1e-8)


def test_a_finger_has_its_side():
    state = with_simulation(preset("figure_03"), pusher_shape="finger")
    assert solve_push(state).sketch.side == (-np.inf, np.inf)
    assert "path_side" in follow(with_simulation(state, duration=0.2)).data


def test_a_finger_has_its_radius():
    state = with_simulation(preset("figure_03"), pusher_shape="finger", pusher_radius=0.3)
    assert solve_push(state).sketch.finger_radius == 0.3
    assert follow(with_simulation(state, duration=0.2)).log.attrs["pusher_radius"] == 0.3


# -- a side on the fence -----------------------------------------------------------------------------


@pytest.mark.parametrize("angle", [90.0, 30.0, 150.0, -90.0])
def test_a_side_on_the_fence_has_a_handle_and_a_table_of_its_own(angle):
    state = with_push(preset("box_side"), angle, 1.0)
    found, trees = shown(state)
    circles = [each.get("data-handle") for each in trees["scene"].iter("circle")]
    assert [each for each in circles if each] == [Handle.PUSHER]
    head = [each.text for each in trees["solutions"].iter("th")][:7]
    assert head == [
        "Mode",
        "Contact",
        "Force (N)",
        "At x* (m)",
        "Motion (m/s)",
        "Center (m)",
        "Slip (m/s)",
    ]
    for name in ("curve", "areas"):
        texts = found.markup | map_markup(state, next(maps.maps(state)), SIZES["map"])
        assert "A side lies on the fence" in texts[name]
    assert texts["legend"] == ""
    assert not list(trees["cross"].iter("path"))


def test_the_handle_of_a_side_is_at_the_tip_of_the_pusher():
    state = with_push(preset("box_side"), 150.0, 1.0)
    push = solve_push(state)
    assert not push.solutions[push.chosen].flush
    tips = [points[-1] for points in arrows(push_picture(push), PUSHER)]
    (place,) = handle_positions(state, push.force).values()
    assert any(np.allclose(place, tip) for tip in tips)


def test_an_instant_says_that_a_side_is_flush():
    said = {}
    for time in (1.0, 3.0, 5.5):
        found, _ = shown(replace(preset("box_side"), time=time))
        said[time] = found.markup["words"]
        assert "a side flush on the fence" in found.markup["energies"]
        assert (found.instant is None) == (time > 4)
    assert said[1.0] == "At time 1.000 the side is flush and sticks."
    assert said[3.0] == "At time 3.000 the side slips to the left, flush."
    assert said[5.5].endswith("the contact sticks.")
    assert "flush" not in shown(replace(preset("pulling"), time=0.5))[0].markup["energies"]
