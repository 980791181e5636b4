"""Objects with an outline: their contact, sizes, own outlines, supports and units of lengths."""

from dataclasses import replace
from urllib.parse import parse_qsl

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.explorer.address import query, state_in
from planar_pushing.explorer.boundary import lowest_place, nearest_to, perimeter, place_at, place_on
from planar_pushing.explorer.lengths import label, note, shown_unit
from planar_pushing.explorer.objects import object_of, with_contact, with_object_size, with_outline
from planar_pushing.explorer.own_outline import (
    BOX,
    CORNERS,
    DISC,
    FILE,
    NONE,
    corners_text,
    kind_of,
    parse_corners,
    sides_of,
    with_box,
    with_corners,
    with_kind,
)
from planar_pushing.explorer.pictures.following import follow
from planar_pushing.explorer.pictures.handles import drag_handle, handles_of, nudge_handle
from planar_pushing.explorer.pictures.maps import axes_of
from planar_pushing.explorer.presets import gallery, preset
from planar_pushing.explorer.state import Handle, with_effect, with_entries
from planar_pushing.explorer.supports import (
    LABELS,
    support_name,
    support_names,
    support_note,
    with_named_support,
)
from planar_pushing.explorer.view import table
from planar_pushing.explorer.widgets import fields, with_kinds
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import EffectKind

OUTLINED = ("box", "mug", "rounded_box", "box_along_a_wall")
ELL = "0, 0\n0.3, 0\n0.3, 0.1\n0.1, 0.1\n0.1, 0.2\n0, 0.2"


# -- the contact -------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", OUTLINED)
def test_a_contact_goes_round_the_outline_and_stays_on_it(name):
    state = preset(name)
    body = object_of(state)
    for part in np.linspace(0.0, 1.0, 11):
        place = place_at(body.outline, part * perimeter(body.outline))
        moved = with_contact(state, place)
        new = object_of(moved)
        np.testing.assert_allclose(new.outline.pieces, body.outline.pieces, atol=1e-9)
        np.testing.assert_allclose(new.place.point, place.point, atol=1e-9)
        assert moved.scene.to_object((0.0, 1.0), "vector") == pytest.approx(place.normal, abs=1e-6)
        assert [each.type for each in moved.file.effects] == [
            each.type for each in state.file.effects
        ]


@pytest.mark.parametrize("name", OUTLINED)
def test_a_contact_back_at_its_place_pushes_as_before(name):
    state = preset(name)
    away = with_contact(
        state, place_at(object_of(state).outline, 0.6 * perimeter(object_of(state).outline))
    )
    back = with_contact(away, object_of(state).place)
    for one, two in zip(*(pp.solve(each.scene, 1.3, 1.0) for each in (state, back)), strict=True):
        assert one.mode == two.mode
        np.testing.assert_allclose(one.twist, two.twist, rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(one.force, two.force, rtol=1e-9, atol=1e-12)


def test_a_contact_moved_by_hand_is_that_of_scene_at():
    state = drag_handle(preset("box"), Handle.CONTACT, np.array([-0.1, 0.02]))
    box = pp.Polygon.rectangle(0.3, 0.2)
    own = pp.scene_at(
        (-0.06, -0.1), contact=pp.Coulomb(0.5), outline=box,
        effects=(
            pp.SupportFriction(weight=3.53, support=box), pp.Inertia(mass=1.2, gyration_radius=0.104),
        ),
    )  # fmt: skip
    for one, two in zip(*(pp.solve(each, 1.5, 0.05) for each in (state.scene, own)), strict=True):
        np.testing.assert_allclose(one.twist, two.twist, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("outside", [(0.5, 0.05), (0.04, 0.9), (-0.9, 0.1), (0.02, 0.03)])
def test_a_pointer_off_the_object_finds_the_nearest_place(outside):
    """The fence frame of the box has its origin 0.04 to the right of the middle of the lower side."""
    state = preset("box")
    place = object_of(drag_handle(state, Handle.CONTACT, np.array(outside))).place
    point = np.array(outside) + np.array([0.04, -0.1])
    low, high = np.array([-0.15, -0.1]), np.array([0.15, 0.1])
    inside = np.clip(point, low, high)
    gaps = np.minimum(inside - low, high - inside)
    shortest = np.hypot(*(point - inside)) or gaps.min()
    assert np.hypot(*(point - place.point)) == pytest.approx(shortest, abs=2e-3)
    assert np.isclose(np.abs(place.point), high).any()


def test_a_contact_does_not_stop_at_a_corner():
    outline = pp.Outline([(0, 0), (3, 0), (3, 1), (0, 1)])
    for point in [(3.0, 0.0), (3.2, -0.1), (3.1, -0.3)]:
        place = nearest_to(outline, np.array(point))
        assert 0.0 < np.hypot(*np.subtract(place.point, (3.0, 0.0))) < 0.02


def test_a_contact_stays_off_an_inner_corner():
    outline = pp.Outline(parse_corners(ELL))
    place = nearest_to(outline, np.array([0.1, 0.1]))
    assert 0.0 < np.hypot(*np.subtract(place.point, (0.1, 0.1))) < 0.002
    assert len(pp.solve(with_contact(with_corners(preset("box"), ELL), place).scene, 1.5, 1.0)) >= 1


def test_keys_move_a_contact_along_the_outline_and_past_corners():
    state, lengths = replace(preset("box"), handle=Handle.CONTACT), []
    for _ in range(110):
        state = nudge_handle(state, None, 1, 0, False)
        lengths.append(object_of(state).place.length)
    assert (np.diff(lengths) > 0.0).sum() == len(lengths) - 2  # it passes the first corner once
    back = nudge_handle(nudge_handle(state, None, 0, 1, True), None, -1, 0, True)
    assert object_of(back).place.length == pytest.approx(lengths[-1])


def test_a_handle_that_an_object_does_not_have_is_the_pusher_for_the_keys():
    state = replace(preset("box"), handle=Handle.ROD)
    assert fields()["handle"].read(state) == Handle.PUSHER
    assert nudge_handle(state, None, 1, 0, False).angle == pytest.approx(state.angle - 1.0)


def test_walls_stay_with_the_outline():
    state = preset("box_along_a_wall")
    moved = drag_handle(state, Handle.CONTACT, np.array([0.3, 0.0]))
    assert moved.file.simulate.walls == state.file.simulate.walls
    assert follow(moved).times[-1] > 0.0


def test_the_handles_of_an_outline_are_not_those_of_a_rod():
    assert Handle.ROD not in handles_of(preset("box"))
    assert Handle.CONTACT not in handles_of(preset("figure_03"))
    assert handles_of(preset("box_side")) == [Handle.PUSHER]
    assert "rod angle" not in axes_of(preset("box"))
    assert "rod angle" in axes_of(preset("figure_03"))


# -- sizes -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [*OUTLINED, "box_side"])
@pytest.mark.parametrize("ratio", [1e-4, 0.5, 3.0])
def test_a_scaled_object_moves_alike(name, ratio):
    state = preset(name)
    scaled = with_object_size(state, ratio)
    assert scaled.size == pytest.approx(ratio * state.size)
    np.testing.assert_allclose(
        np.array(object_of(scaled).place.point),
        ratio * np.array(object_of(state).place.point),
        atol=1e-9,
    )
    for one, two in zip(*(pp.solve(each.scene, 1.4, 1.0) for each in (state, scaled)), strict=True):
        np.testing.assert_allclose(one.force, two.force, rtol=1e-7, atol=1e-9)
        np.testing.assert_allclose(one.twist[2], ratio * two.twist[2], rtol=1e-7, atol=1e-9)


def test_the_size_of_an_object_follows_its_handle():
    state = preset("box")
    corner = np.array([-0.19, 0.2])  # the corner farthest from the contact, in the fence frame
    larger = drag_handle(state, Handle.SIZE, 1.5 * corner)
    assert sides_of(larger) == pytest.approx((0.45, 0.3))
    assert drag_handle(state, Handle.SIZE, -corner).size > 0.0


def test_keys_up_and_down_change_the_size_of_an_object():
    state = replace(preset("box"), handle=Handle.SIZE)
    assert sides_of(nudge_handle(state, None, 0, 1, False)) == pytest.approx((0.306, 0.204))
    assert sides_of(nudge_handle(state, None, 0, -1, True)) == pytest.approx((0.24, 0.16))
    assert nudge_handle(state, None, 1, 0, False) == state


# -- own outlines ------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["figure_03", "figure_13", "plate", "box", "mug", "impact"])
@pytest.mark.parametrize("kind", [BOX, DISC, CORNERS])
def test_every_scene_takes_an_outline(name, kind):
    state = with_kind(preset(name), kind)
    assert kind_of(state) == kind
    assert state_in(dict(parse_qsl(query(state)))) == state
    assert len(pp.solve(state.scene, np.deg2rad(state.angle), state.magnitude)) >= 1
    assert follow(state).times[-1] > 0.0
    bare = with_kind(state, NONE)
    assert kind_of(bare) == NONE
    assert bare.file.slider.rod_length == state.file.slider.rod_length


def test_a_box_has_the_width_and_the_height_that_are_entered():
    state = with_box(preset("figure_03"), 0.4, 0.1)
    assert sides_of(state) == (0.4, 0.1)
    assert object_of(state).place.point == pytest.approx((0.0, -0.05))
    wider = with_box(with_contact(state, place_at(object_of(state).outline, 0.1)), 0.8, 0.1)
    assert object_of(wider).place.point == pytest.approx((-0.2, -0.05))
    assert pp.solve(state.scene, np.pi / 2, 1.0)[0].twist == pytest.approx([0.0, 1.0, 0.0])


def test_a_contact_on_an_arc_has_no_place_on_a_box():
    """A box with round corners has as many pieces as one with sharp corners, which have no length."""
    state = preset("rounded_box")
    outline = object_of(state).outline
    box = with_kind(with_contact(state, place_on(outline, 1, 0.02)), BOX)
    assert kind_of(box) == BOX
    assert object_of(box).place.point == pytest.approx((0.0, -0.1))


def test_corners_are_shown_without_rounding_errors():
    state = with_corners(preset("figure_03"), "0, 0; 3e7, 0; 3e7, 1e7; 1e7, 1e7; 1e7, 2e7; 0, 2e7")
    outline = object_of(state).outline
    moved = with_contact(state, place_at(outline, 0.4 * perimeter(outline)))
    assert corners_text(moved) == corners_text(state)


def test_corners_are_entered_and_shown():
    state = with_corners(preset("figure_03"), ELL)
    assert kind_of(state) == CORNERS
    assert corners_text(state) == ELL
    assert object_of(state).outline.area == pytest.approx(0.04)
    again = with_corners(state, corners_text(state))
    np.testing.assert_allclose(
        object_of(again).outline.pieces, object_of(state).outline.pieces, atol=1e-12
    )
    assert again.file.slider.rod_length == pytest.approx(state.file.slider.rod_length)
    assert lowest_place(object_of(state).outline).point == pytest.approx((0.15, 0.0))
    assert parse_corners("(0, 0); [1 0]; 1, 1e0") == [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]


@pytest.mark.parametrize(("text", "said"), [
    ("", "Corners: 0 given; allowed: 3 to 200 corners"),
    ("0, 0; 1, 0", "Corners: 2 given; allowed: 3 to 200 corners"),
    ("0, 0\n" * 201, "Corners: 201 given; allowed: 3 to 200 corners"),
    ("0, 0\n1, 0\none, 1", "Corners: corner 3: 'one, 1' given; allowed: two finite numbers"),
    ("0, 0\n1, 0\n1", "Corners: corner 3: '1' given; allowed: two finite numbers"),
    ("0, 0\n1, 0, 0\n1, 1", "Corners: corner 2: '1, 0, 0' given; allowed: two finite numbers"),
    ("0, 0\n1, inf\n1, 1", "Corners: corner 2: '1, inf' given; allowed: two finite numbers"),
    ("0, 0; 1, 1; 1, 0; 0, 1", "Corners: "),
    ("0, 0; 1, 0; 2, 0", "Corners: "),
])  # fmt: skip
def test_bad_corners_are_refused_in_one_line(text, said):
    with pytest.raises(InvalidValue) as refused:
        with_corners(preset("figure_03"), text)
    assert str(refused.value).startswith(said)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("value", [None, 0.0, -1.0, 1e300, np.inf, np.nan])
@pytest.mark.parametrize("name", ["width", "height", "diameter"])
def test_a_bad_length_is_refused_by_its_name(name, value):
    with pytest.raises(
        InvalidValue, match=f"^{name.capitalize()}: .*allowed: a number from 1e-09 "
    ):
        fields()[name].write(preset("figure_03"), value)


def test_a_box_that_is_too_slender_is_refused():
    with pytest.raises(InvalidValue, match=r"^Width: 1.0 given; allowed: from 1e-09 to 0.1 "):
        with_box(preset("figure_03"), 1.0, 1e-5)


def test_an_outline_with_arcs_keeps_its_kind():
    state = preset("rounded_box")
    assert kind_of(state) == FILE
    assert FILE in fields()["outline"].more(state)["options"]
    assert FILE not in fields()["outline"].more(preset("box"))["options"]
    assert sides_of(state) == pytest.approx((0.3, 0.2))


def test_an_own_outline_turns_the_fence_into_a_finger():
    """A fence would touch the whole side, while the page shows a contact at one point."""
    assert preset("figure_03").shape == "fence"
    assert with_kind(preset("figure_03"), BOX).shape == "finger"
    assert with_outline(preset("box_side"), pp.Outline([(0, 0), (2, 0), (2, 1), (0, 1)])).flush


def test_another_size_keeps_a_velocity_that_changes_over_time():
    pieces = [{"time": 0.0, "angle": 90.0}, {"time": 0.5, "angle": 60.0}]
    state = with_entries(preset("box_side"), simulate={"pusher": pieces, "duration": 1.5})
    wide = with_box(state, 3.0, 1.0)
    assert wide.scene.slider.outline != state.scene.slider.outline
    assert wide.file.simulate == state.file.simulate


# -- supports ----------------------------------------------------------------------------------------


def test_every_support_has_a_name_that_says_what_it_is():
    assert list(LABELS) == list(gallery())
    assert not [name for name in LABELS.values() if "_" in name]
    assert support_names(preset("tripod"))["three feet"] == "tripod"
    assert support_note(preset("tripod")).endswith(
        "shape points; in the gallery of supports: tripod."
    )
    assert support_note(preset("impact")) == "There is no friction on the support."
    assert "from the scene file" in support_names(preset("plate"))
    assert "even pressure over the base" not in support_names(preset("plate"))
    assert "even pressure over the base" in support_names(preset("box"))


@pytest.mark.parametrize("name", [*LABELS, "base"])
@pytest.mark.parametrize("start", ["box", "mug", "rounded_box"])
def test_a_support_lies_under_its_object_and_keeps_its_name(start, name):
    state = with_named_support(preset(start), name)
    assert support_name(state) == name
    before, after = object_of(preset(start)), object_of(state)
    assert after.place.point == pytest.approx(before.place.point, abs=1e-9)
    support = after.effects[0].support
    assert support.center_of_pressure == pytest.approx(after.outline.centroid, abs=1e-9)
    assert support.extent <= after.outline.size
    assert support_name(drag_handle(state, Handle.SIZE, np.array([0.5, 0.5]))) == name


@pytest.mark.parametrize("start", ["box", "box_side"])
def test_friction_that_returns_is_even_over_the_base(start):
    state = preset(start)
    smooth = with_kinds(
        with_effect(state, EffectKind.INERTIA, {"type": "inertia"}), [EffectKind.INERTIA]
    )
    rough = with_kinds(smooth, [EffectKind.INERTIA, EffectKind.SUPPORT_FRICTION])
    assert support_name(rough) == "base"
    assert rough.scene.weight == 1.0
    assert rough.flush == state.flush
    assert support_name(with_named_support(smooth, "tripod")) == "tripod"


def test_even_pressure_is_on_the_base_without_its_holes():
    square, hole = [(-2, -1), (2, -1), (2, 1), (-2, 1)], pp.Disc(0.5, center=(1.0, 0.0))
    state = with_outline(preset("figure_03"), pp.Outline(square, holes=[hole]))
    body = object_of(state)
    assert body.effects[0].support.center_of_pressure == pytest.approx(
        body.outline.centroid, abs=1e-4
    )
    assert body.outline.centroid[0] < -0.1
    assert support_name(state) == "base"
    assert support_name(with_named_support(state, "tripod")) == "tripod"


def test_a_support_about_a_centroid_outside_of_the_object_is_refused():
    thin = with_corners(preset("box"), "0, 0; 1, 0; 1, 0.05; 0.05, 0.05; 0.05, 1; 0, 1")
    with pytest.raises(
        InvalidValue, match=r"^Support: 'three feet' given; allowed: even pressure "
    ):
        with_named_support(thin, "tripod")
    assert support_name(with_named_support(thin, "base")) == "base"


# -- units -------------------------------------------------------------------------------------------


def test_lengths_are_shown_in_another_unit():
    state = replace(preset("box"), unit="cm")
    assert (shown_unit(state), label("Width", state)) == ("cm", "Width (cm)")
    assert sides_of(state) == (30.0, 20.0)
    assert fields()["width"].write(state, 40.0).file.slider.rod_length == pytest.approx(
        with_box(preset("box"), 0.4, 0.2).file.slider.rod_length
    )
    assert corners_text(replace(with_corners(preset("box"), ELL), unit="mm")).startswith(
        "0, 0\n300, 0"
    )
    for name, size in (("gyration", 10.4), ("place", 19.0)):
        assert fields()[name].read(state) == pytest.approx(size)
        assert fields()[name].more(state)["label"].endswith("(cm)")
    same = fields()["gyration"].write(state, 10.4)
    assert same.scene.masses[0].gyration_radius == pytest.approx(0.104)
    assert state_in(dict(parse_qsl(query(state)))) == state


def test_the_radius_of_gyration_is_that_of_the_outline_without_a_number():
    gyration = fields()["gyration"]
    plate = gyration.write(replace(preset("box"), unit="cm"), None)
    assert gyration.read(plate) == pytest.approx(100.0 * np.hypot(0.3, 0.2) / np.sqrt(12.0))


def test_the_table_names_its_units():
    state = replace(preset("box"), unit="mm")
    (solution,) = pp.solve(state.scene, np.pi / 2, 0.05)
    text = table([solution], np.array([0.0, 0.05]), 0, state, True)
    for head in ("Force (N)", "Motion (m/s\N{SUPERSCRIPT TWO})", "Center (mm)"):
        assert f"<th>{head}</th>" in text
    assert f"({1e3 * solution.center[0]:.3f}, 0)".replace("-", "\N{MINUS SIGN}") in text
    bare = table([solution], np.array([0.0, 0.05]), 0, preset("figure_13"), True)
    assert "<th>Center</th>" in bare


def test_a_scene_without_a_unit_says_so_and_takes_one():
    state = preset("figure_03")
    assert note(state).startswith(
        "Lengths are multiples of one unit, which the scene does not name"
    )
    unit = fields()["unit"]
    assert unit.more(state)["options"] == ["no unit", "m", "cm", "mm"]
    named = unit.write(state, "cm")
    assert (named.file.units.length, shown_unit(named), note(named)) == ("cm", "cm", "")
    assert named.file.slider == state.file.slider
    meters = unit.write(named, "m")
    assert fields()["rod_length"].read(meters) == pytest.approx(0.03)


def test_the_center_of_mass_is_in_the_object_s_frame():
    state = drag_handle(preset("box"), Handle.CONTACT, np.array([0.3, 0.1]))
    assert [fields()[name].read(state) for name in ("mass_x", "mass_y")] == [0.0, 0.0]
    moved = fields()["mass_x"].write(state, 0.05)
    assert [fields()[name].read(moved) for name in ("mass_x", "mass_y")] == [0.05, 0.0]
    center = moved.scene.masses[0].center
    assert object_of(moved).body.point_out(center) == pytest.approx((0.05, 0.0))
    assert with_effect(moved, EffectKind.INERTIA, None).has_outline
