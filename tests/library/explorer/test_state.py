"""States: changes of them, and the ways out and back."""

from dataclasses import replace
from pathlib import Path
from urllib.parse import parse_qsl

import numpy as np
import pytest
from pydantic import ValidationError

import planar_pushing as pp
from planar_pushing.explorer.address import query, state_in
from planar_pushing.explorer.downloads import download
from planar_pushing.explorer.pictures.following import (
    choices_at,
    follow,
    has_choices,
    push_at,
    row_at,
    solution_at,
    with_choice,
    without_choices,
)
from planar_pushing.explorer.pictures.handles import drag_handle, handle_positions, nudge_handle
from planar_pushing.explorer.presets import PUSHES, gallery, preset, preset_file
from planar_pushing.explorer.python_lines import lines
from planar_pushing.explorer.state import (
    Handle,
    Start,
    effect,
    name_in,
    state_of,
    with_effect,
    with_law,
    with_push,
    with_rod,
    with_simulation,
    with_size,
    with_support,
)
from planar_pushing.scenes.contacts_files import load_any_file
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.options import EffectKind
from pulling_by_pushing.study.datasets.scenes import pusher_angle
from pulling_by_pushing.study.study_file import load_study

PRESETS = list(PUSHES)
WORKFLOW = Path("workflow")
MODES = {
    "stick": pp.ContactMode.STICK,
    "slip-right": pp.ContactMode.SLIP_RIGHT,
    "slip-left": pp.ContactMode.SLIP_LEFT,
    "separate": pp.ContactMode.SEPARATE,
}


def back(state):
    return state_in(dict(parse_qsl(query(state))))


def solved(state):
    return pp.solve(state.scene, np.deg2rad(state.angle), state.magnitude)


@pytest.mark.parametrize("name", PRESETS)
def test_an_address_holds_the_whole_state(name):
    state = preset(name)
    assert back(state) == state
    other = replace(
        with_push(with_rod(state, 1.25, 70.5), -12.3, 0.7),
        shown="STICK",
        across="rod angle",
        time=0.25,
        handle=Handle.ROD,
    )
    assert back(other) == other


@pytest.mark.parametrize("name", PRESETS)
def test_a_saved_scene_is_the_same_scene(name, tmp_path):
    state = preset(name)
    (tmp_path / "scene.yaml").write_bytes(download(state, "scene.yaml"))
    file = load_scene_file(tmp_path / "scene.yaml")
    assert file.build() == state.scene
    if state.start == Start.VELOCITY:
        assert state_of(file) == state


@pytest.mark.parametrize(
    "name", ["figure_03", "tripod", "figure_08", "box_side", "mug", "rounded_box"]
)
def test_the_lines_of_python_give_the_same_result(name, capsys):
    state = with_choice(replace(preset(name), time=0.1), "separate")
    found = {}
    exec(lines(state), found)
    capsys.readouterr()
    assert found["scene"] == state.scene
    assert found["solutions"] == solved(state)
    own = follow(state).log
    assert found["log"].identical(own)


def test_the_lines_accelerate_a_pusher_from_rest(capsys):
    state = with_push(preset("figure_13"), 170.0, 2.0)
    assert state.start == Start.ACCELERATION
    found = {}
    exec(lines(state), found)
    capsys.readouterr()
    own = follow(state).log
    np.testing.assert_array_equal(found["log"].rod_angle, own.rod_angle)
    turn, way = np.deg2rad(170.0), own.time[-1].item() ** 2  # half of the acceleration, 2
    np.testing.assert_allclose(own.pusher[-1], [way * np.cos(turn), way * np.sin(turn)])


@pytest.fixture(scope="module")
def study():
    return load_study(WORKFLOW / "config/paper.yaml")


#: Example scenes that are no presets: of an accuracy study, of the first page, and of a disc at two places.
OTHERS = {"turning_fence", "steep_retreat", "tee_in_its_corner"}
EXAMPLES = {path.stem: path for path in sorted((WORKFLOW / "scenes").glob("*.yaml"))}


@pytest.mark.parametrize("name", sorted(EXAMPLES.keys() - OTHERS))
def test_an_example_scene_is_a_preset(name):
    assert preset_file(name) == load_any_file(EXAMPLES[name])


def test_figures_are_pushed_as_in_the_study(study):
    for name, push in study.scenes.items():
        file = load_scene_file(push.file)
        assert preset(name).angle == pytest.approx(pusher_angle(file.build(), push), abs=1e-6)


def test_the_gallery_is_that_of_the_study_of_sliders():
    study = load_study(WORKFLOW / "config/sliders.yaml")
    content = {"slider": {"rod_length": 1, "rod_angle": 90}, "contact": {"law": "perfectly_rough"}}
    assert list(gallery()) == list(study.supports)
    for name, support in gallery().items():
        effects = [{"type": "support_friction", "support": support}]
        file = SceneFile.model_validate(content | {"effects": effects})
        assert file.effects[0].support == study.supports[name]


def test_every_figure_of_a_scene_has_a_preset():
    figures = {name.removeprefix("figure_")[:2] for name in PRESETS if name.startswith("figure")}
    assert figures == {f"{number:02}" for number in range(1, 14)}


@pytest.mark.parametrize("name", list(gallery()))
def test_a_support_of_the_gallery_keeps_its_name_at_any_size(name):
    state = with_support(preset("figure_13"), None if name == "ring" else gallery()[name])
    for size in (0.3, 1.0, 2.7):
        large = with_size(state, size)
        assert large.size == pytest.approx(size)
        support = effect(large, EffectKind.SUPPORT_FRICTION).get("support")
        assert name_in(gallery(), support, large.size) == name


def test_an_own_support_has_no_name():
    state = preset("plate")
    assert (
        name_in(gallery(), effect(state, EffectKind.SUPPORT_FRICTION)["support"], state.size) == ""
    )


def test_one_effect_at_least_stays():
    with pytest.raises(ValidationError, match="at least one"):
        with_effect(preset("figure_03"), EffectKind.SUPPORT_FRICTION, None)


def test_inertia_starts_the_pusher_from_rest():
    state = with_effect(preset("figure_03"), EffectKind.INERTIA, {"type": "inertia"})
    assert state.start == Start.ACCELERATION
    assert with_effect(state, EffectKind.INERTIA, None).start == Start.VELOCITY


@pytest.mark.parametrize("name", ["figure_03", "figure_13", "tripod", "figure_09a"])
def test_a_handle_is_dragged_to_where_it_is_dropped(name):
    state = preset(name)
    force = solved(state)[-1].force
    for handle in (Handle.PUSHER, Handle.ROD):
        place = np.array([0.4, 0.9])
        moved = handle_positions(drag_handle(state, handle, place), force)[handle]
        angle = [np.arctan2(*each[::-1]) for each in (moved, place)]
        assert angle[0] == pytest.approx(angle[1])
    moved = handle_positions(drag_handle(state, Handle.ROD, place), force)
    assert moved[Handle.ROD] == pytest.approx(place)


def test_the_size_follows_its_handle():
    state = preset("figure_03")
    away = handle_positions(state, None)[Handle.ROD] + np.array([1.0, -1.0])
    assert drag_handle(state, Handle.SIZE, away).size == pytest.approx(np.sqrt(2.0))
    larger = nudge_handle(replace(state, handle=Handle.SIZE), None, 0, 1, False)
    assert larger.size == pytest.approx(1.02 * state.size)


@pytest.mark.parametrize(
    "name", ["figure_03", "figure_13", "tripod", "figure_09a", "support_limit_curves"]
)
@pytest.mark.parametrize("degrees", [70.0, 95.0])
def test_a_line_of_force_is_that_of_the_push_that_sticks(name, degrees):
    state = with_law(preset(name), {"law": "coulomb", "friction_coefficient": 2})
    angle = np.deg2rad(degrees)
    moved = drag_handle(state, Handle.LINE, np.array([np.cos(angle), np.sin(angle)]))
    stick = next(each for each in solved(moved) if each.mode == pp.ContactMode.STICK)
    assert np.arctan2(*stick.force[::-1]) == pytest.approx(angle, abs=2e-3)


def test_a_line_of_force_where_a_share_of_inertia_does_not_determine_the_motion():
    inertia = {"type": "inertia", "center": [0.1, 0.2]}
    state = with_effect(preset("tripod"), EffectKind.INERTIA, inertia)
    state = with_law(state, {"law": "coulomb", "friction_coefficient": 2})
    moved = drag_handle(state, Handle.LINE, np.array([0.3, 1.0]))
    stick = next(each for each in solved(moved) if each.mode == pp.ContactMode.STICK)
    assert np.arctan2(*stick.force[::-1]) == pytest.approx(np.arctan2(1.0, 0.3), abs=2e-3)


def test_a_line_of_force_stays_in_the_cone():
    state = with_law(preset("figure_02"), {"law": "coulomb", "friction_coefficient": 0.5})
    moved = drag_handle(state, Handle.LINE, np.array([1.0, -0.2]))
    edge = pp.friction_cone(state.scene).right
    assert np.deg2rad(moved.angle) == pytest.approx(pp.motion_angle(state.scene, edge))


def test_keys_turn_the_push_by_degrees():
    state = with_push(preset("figure_03"), 30.0, 1.0)
    assert nudge_handle(state, None, 1, 0, False).angle == pytest.approx(29.0)
    assert nudge_handle(state, None, -1, 0, True).angle == pytest.approx(40.0)
    longer = nudge_handle(replace(state, handle=Handle.ROD), None, 0, 1, False)
    assert longer.file.slider.rod_length == pytest.approx(3.06)


def test_a_way_taken_by_hand_is_taken_from_its_time_on():
    state = replace(preset("figure_03"), time=0.3)
    before, hand = follow(state), with_choice(state, "slip-left")
    after = follow(hand)
    assert has_choices(hand)
    early = before.log.sel(time=slice(0, 0.29)).rod_angle
    np.testing.assert_allclose(after.log.sel(time=slice(0, 0.29)).rod_angle, early, atol=1e-9)
    row = int(np.searchsorted(after.times, 0.31))
    assert after.log["mode"][row] == pp.ContactMode.SLIP_LEFT
    assert without_choices(hand) == state
    earlier = with_choice(replace(hand, time=0.2), "separate")
    assert [piece.time for piece in earlier.file.simulate.policies] == [0.0, 0.2]


def turned_finger():
    """A pull by a finger whose side has turned by the time."""
    return replace(with_simulation(preset("figure_03"), pusher_shape="finger"), time=0.3)


def in_motion():
    """A pull of a slider with inertia, which moves by the time."""
    return replace(preset("pulling_with_inertia"), time=0.25)


@pytest.mark.parametrize("state", [
    pytest.param(replace(preset("figure_03"), time=0.3), id="fence"),
    pytest.param(turned_finger(), id="finger"), pytest.param(in_motion(), id="inertia"),
])  # fmt: skip
def test_the_ways_on_are_those_that_are_consistent(state):
    motion = follow(state)
    row = row_at(motion, state.time)
    ways = choices_at(state, motion, state.time)
    assert len(ways) == motion.log["solutions"][row] == 3
    for way in ways:
        after = follow(with_choice(state, way))
        later = int(np.searchsorted(after.times, state.time + 1e-6))
        assert MODES[way] == after.log["mode"][later]


def test_the_ways_on_from_rest_are_the_solutions():
    state = replace(preset("pulling_with_inertia"), start=Start.ACCELERATION, time=0.0)
    modes = {each.mode for each in solved(state)}
    assert {MODES[way] for way in choices_at(state, follow(state), 0.0)} == modes


def test_one_way_on_is_no_choice():
    state = replace(preset("figure_08"), time=0.1)
    assert choices_at(state, follow(state), 0.1) == ()


def test_another_push_forgets_the_choices():
    hand = with_choice(replace(preset("figure_03"), time=0.3), "slip-left")
    assert not has_choices(with_push(hand, 10.0, 1.0))
    assert not has_choices(with_rod(hand, 2.0, 45.0))


SCENE = {
    "slider.rod_length": "2", "slider.rod_angle": "45", "contact.law": "perfectly_rough",
    "effects": '[{"type":"ring_friction"}]',
}  # fmt: skip


@pytest.mark.parametrize(("given", "said"), [
    ({"angle": "up"}, "address: angle: 'up' given; allowed: a finite number, degrees"),
    ({"magnitude": "0"}, "address: magnitude: '0' given; allowed: a finite number > 0"),
    ({"start": "late"}, "address: start: 'late' given; allowed: velocity or acceleration"),
    ({"slider.rod_length": "nan"},
     "address: slider.rod_length: 'nan' given; allowed: a finite number >= 0"),
    ({"effects": "[]"}, "address: effects: [] given; allowed: a list with at least one entry"),
    ({"effects": "[" * 3000}, "address: effects: '[[[["),
    ({"effects": "[" * 900 + "]" * 900}, "address: effects[0]: "),
    ({"nothing": "1"}, "address: nothing: 1 given; allowed: the keys title, slider,"),
    ({"slider": "3"}, "address: slider: 3 given; allowed: a mapping with the keys rod_length,"),
])  # fmt: skip
def test_a_wrong_address_is_refused_in_one_line_of_our_own(given, said):
    with pytest.raises(PlanarPushingError) as refused:
        state_in(SCENE | given)
    assert str(refused.value).startswith(said)
    assert str(refused.value).endswith("; the page shows its first preset instead")
    assert not set(str(refused.value)) & set("\n")
    assert "pydantic" not in str(refused.value)


@pytest.mark.parametrize("time", [0.2, 0.67, 1.2])
def test_an_instant_of_a_fence_is_a_push_of_its_own(time):
    state = replace(preset("pulling"), time=time)
    motion = follow(state)
    row, instant = row_at(motion, time), push_at(state, motion, time)
    found = solved(instant)
    own, _ = solution_at(state, motion, time)
    same = next(each for each in found if each.mode == own.mode)
    assert len(found) == motion.log["solutions"][row]
    np.testing.assert_allclose(same.twist, own.twist, atol=1e-7)
    np.testing.assert_allclose(same.force, own.force, atol=1e-7)
    np.testing.assert_allclose(same.center, own.center, atol=1e-6)


@pytest.mark.parametrize("state", [
    pytest.param(turned_finger(), id="finger"), pytest.param(in_motion(), id="inertia"),
    pytest.param(replace(preset("pulling_lost"), time=1.0), id="broken"),
])  # fmt: skip
def test_other_instants_are_no_push_of_their_own(state):
    motion = follow(state)
    assert push_at(state, motion, state.time) is None
    solution, pusher = solution_at(state, motion, state.time)
    if solution.mode == pp.ContactMode.STICK:
        assert solution.contact_motion[0] == pytest.approx(pusher[0], abs=1e-6)
