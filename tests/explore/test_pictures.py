"""Columns of the pictures, against the mechanics."""

from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.explore.following import energies, followed, row_at
from planar_pushing.explore.handles import places
from planar_pushing.explore.pictures import curve, modes, motion, scene
from planar_pushing.explore.pictures.columns import COLUMNS, Marks
from planar_pushing.explore.pictures.svg import markup, sheet
from planar_pushing.explore.presets import preset, presets
from planar_pushing.explore.state import pushed, simulated, with_law
from planar_pushing.explore.words import best, number, outcome
from planar_pushing.figures.style import FORCE, MOTION, PUSHER, SLIP

PRESETS = list(presets())


def lines(columns, color):
    """Ends of the lines of a colour."""
    rows = columns["lines"]
    return [
        np.array([xs, ys]).T
        for xs, ys, each in zip(rows["xs"], rows["ys"], rows["color"], strict=True)
        if each == color
    ]


def angles(ends):
    """Directions of lines from the contact, degrees."""
    return [np.rad2deg(np.arctan2(*(each[-1])[::-1])) for each in ends if not each[0].any()]


@pytest.mark.parametrize("name", PRESETS)
def test_every_preset_is_drawn(name):
    state = preset(name)
    found = scene.found(state)
    for columns in (scene.picture(state, found), curve.picture(state, found)):
        assert set(columns) == set(COLUMNS)
        for kind, given in columns.items():
            assert list(given) == list(COLUMNS[kind])
            assert len({len(each) for each in given.values()}) == 1
    low, high = scene.bounds(state)
    assert (low < 0).all()
    assert (high > 0).all()


@pytest.mark.parametrize("name", PRESETS)
def test_every_mark_is_an_element_in_its_place(name):
    state = preset(name)
    columns, on = scene.picture(state, scene.found(state)), sheet(scene.bounds(state), 700, 480)
    root = ElementTree.fromstring(markup(columns, on))
    assert len(root) == sum(len(next(iter(each.values()))) for each in columns.values())
    for (low, high), size in zip(scene.bounds(state).T, (700, 480), strict=True):
        assert on.scale * (high - low) < size
    found = {each.get("data-handle"): each for each in root if each.get("data-handle")}
    for name, place in places(state, scene.found(state).force).items():
        pixel = [float(found[name].get(key)) for key in ("cx", "cy")]
        np.testing.assert_allclose(on.place(pixel), place, atol=0.02 / on.scale)


def test_letters_are_escaped():
    marks = Marks()
    marks.label((0.0, 0.0), "a < b & c", "#000", (0.0, 0.0))
    root = ElementTree.fromstring(markup(marks.columns, sheet([(-1, -1), (1, 1)], 100, 100)))
    assert root[0].text == "a < b & c"


def test_the_arrows_are_the_solutions():
    state = pushed(preset("figure_03"), -15.0, 1.0)
    found = scene.found(state)
    columns = scene.picture(state, found)
    forces, motions = angles(lines(columns, FORCE)), angles(lines(columns, MOTION))
    assert len(found.solutions) == 3
    for each in found.solutions:
        if each.mode != pp.ContactMode.SEPARATE:
            force, moves = (
                np.rad2deg(np.arctan2(*v[::-1])) for v in (each.force, each.contact_motion)
            )
            assert min(np.abs(np.subtract(forces, force))) < 0.01
            assert min(np.abs(np.subtract(motions, moves))) < 0.01


def test_the_slip_closes_the_triangle():
    state = preset("figure_08")
    columns = scene.picture(state, scene.found(state))
    (pusher,) = (each for each in lines(columns, PUSHER) if not each[0].any())
    slip = lines(columns, SLIP)[0]
    np.testing.assert_allclose(slip[0], pusher[-1], atol=1e-4)
    assert slip[0][1] == pytest.approx(slip[1][1], abs=1e-4)


@pytest.mark.parametrize(
    "name", ["figure_03", "figure_13", "figure_09a", "figure_19", "pulling_with_inertia"]
)
@pytest.mark.parametrize("magnitude", [0.2, 1.0, 3.0])
def test_the_force_lies_on_the_limit_curve_and_the_motion_is_its_normal(name, magnitude):
    state = pushed(with_law(preset(name), {"law": "perfectly_rough"}), 40.0, magnitude)
    (solution,) = (
        each for each in scene.found(state).solutions if each.mode == pp.ContactMode.STICK
    )
    size = curve.level(state.scene, solution)
    found = curve.curve_at(state.scene, size)
    angle = np.arctan2(*solution.force[::-1]) % (2 * np.pi)
    there = np.interp(angle, found.force_angle, found.magnitude)
    if len(state.scene.kinds) > 1:
        assert there == pytest.approx(np.hypot(*solution.force), rel=3e-3)
    motions = np.unwrap(found.motion_angle)
    normal = np.interp(angle, found.force_angle, motions)
    assert np.cos(normal - np.deg2rad(40.0)) == pytest.approx(1.0, abs=2e-3)


@pytest.mark.parametrize("name", ["figure_03", "figure_13", "figure_19", "figure_15"])
def test_the_map_is_what_single_pushes_find(name):
    state = preset(name)
    assert modes.axes_of(state)
    for across in modes.axes_of(state):
        found = modes.mode_map(replace(state, across=across), (8, 5))
        assert found.axis == across
        for row, column in [(0, 0), (2, 3), (5, 1), (7, 4)]:
            angle = -180.0 + (row + 0.5) * 45.0
            along = found.left + (column + 0.5) * (found.right - found.left) / 5
            there = modes.gone(replace(state, across=across), angle, along)
            expected = sum({1 << each.mode for each in scene.found(there).solutions})
            assert found.codes[row, column] == expected


def test_a_click_on_the_cross_stays_there():
    for name in ("figure_03", "figure_13"):
        state = preset(name)
        for across in modes.axes_of(state):
            given = replace(state, across=across)
            there = modes.gone(given, state.angle, modes.AXES[across].here(given))
            assert there.scene == state.scene
            assert there.magnitude == pytest.approx(state.magnitude)


def test_the_outcome_is_said_in_words():
    state = pushed(preset("figure_06"), -10.0, 1.0)
    found = scene.found(state)
    assert outcome(tuple(found.solutions), found.pusher, found.shown) == (
        "The contact sticks while being pulled; two more ways: the contact breaks, or slips to the left "
        "while being pulled."
    )


def test_no_motion_is_said_too():
    state = with_law(preset("figure_08"), {"law": "infinite_friction", "at_zero_normal": "none"})
    found = scene.found(state)
    assert len(found.solutions) == 0
    assert "No motion" in outcome((), found.pusher, best(()))
    assert scene.picture(state, found)["heads"]["xs"] == []


@pytest.mark.parametrize(("given", "said"), [
    (0.0, "0"), (-1e-12, "0"), (-1e-6, "\u22121e\u221206"), (1.5, "1.5"), (-0.25, "\u22120.25"),
    (123456.0, "1.23e+05"),
])  # fmt: skip
def test_numbers_are_short(given, said):
    assert number(given) == said


@pytest.mark.parametrize("name", ["figure_14a", "figure_19", "impact"])
def test_a_motion_is_drawn_at_every_instant(name):
    found = followed(preset(name))
    for time in np.linspace(0, found.times[-1], 5):
        columns = motion.picture(found, float(time))
        row = row_at(found, float(time))
        dots = np.array([columns["dots"]["x"], columns["dots"]["y"]]).T
        center = found.log.position.values[row]
        assert np.abs(dots - center).sum(axis=1).min() < 1e-4
    bar = motion.mode_bar(found)
    assert bar["left"][1:] == bar["right"][:-1]
    balance = energies(found)
    if name == "figure_14a":
        np.testing.assert_allclose(
            balance["work"], balance["support friction"] + balance["contact friction"], atol=1e-8
        )


def test_a_finger_has_its_side():
    state = simulated(preset("figure_03"), pusher_shape="finger")
    assert scene.side_ends(state, scene.frame_of(state.scene)).shape == (2, 2)
    assert "path_side" in followed(simulated(state, duration=0.2)).data
