"""Undo and redo."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from planar_pushing.explorer.history import JOINED, KEPT, History
from planar_pushing.explorer.page import Page
from planar_pushing.explorer.presets import preset
from planar_pushing.explorer.state import Handle, with_push

START = preset("figure_03")
TURNED, FARTHER = (with_push(START, angle, 1.0) for angle in (10.0, 20.0))


def test_a_step_is_undone_and_done_again():
    history = History()
    history.note(START, TURNED, "", 0.0)
    history.note(TURNED, FARTHER, "", 1.0)
    assert history.undo(FARTHER) == TURNED
    assert history.undo(TURNED) == START
    assert history.undo(START) is None
    assert history.redo(START) == TURNED
    assert history.redo(TURNED) == FARTHER
    assert history.redo(FARTHER) is None


def test_a_new_step_forgets_those_undone():
    history = History()
    history.note(START, TURNED, "", 0.0)
    assert history.undo(TURNED) == START
    history.note(START, FARTHER, "", 1.0)
    assert history.redo(FARTHER) is None
    assert history.undo(FARTHER) == START


def test_no_step_is_undone_during_a_drag():
    history = History()
    history.note(START, TURNED, "", 0.0)
    page = SimpleNamespace(state=TURNED, pointing=SimpleNamespace(held="scene"))
    Page.step(page, history.undo)
    assert history.undo(TURNED) == START


def test_a_drag_is_one_step():
    history, before = History(), START
    for angle in range(1, 30):
        after = with_push(START, float(angle), 1.0)
        history.note(before, after, "drag", 0.1 * angle)
        before = after
    history.rest()
    history.note(before, FARTHER, "drag", 3.0)
    assert history.undo(FARTHER) == before
    assert history.undo(before) == START


@pytest.mark.parametrize(("source", "seconds"), [("angle", 2 * JOINED), ("friction", 0.1)])
def test_a_later_change_and_one_by_another_widget_are_steps_of_their_own(source, seconds):
    history = History()
    history.note(START, TURNED, "angle", 0.0)
    history.note(TURNED, FARTHER, source, seconds)
    assert len(history.past) == 2


@pytest.mark.parametrize("changes", [
    {"time": 0.3}, {"handle": Handle.ROD}, {"shown": "STICK"}, {"across": "rod angle"}, {"unit": "cm"},
])  # fmt: skip
def test_what_is_only_shown_is_no_step(changes):
    history = History()
    history.note(START, replace(START, **changes), "", 0.0)
    assert history.past == []


def test_the_map_stays_and_the_motion_ends_when_a_step_is_undone():
    history = History()
    history.note(START, TURNED, "", 0.0)
    back = history.undo(replace(TURNED, time=0.5, across="rod angle"))
    assert back == replace(START, across="rod angle")


def test_the_steps_that_are_kept_are_limited():
    history, before = History(), START
    for angle in range(KEPT + 50):
        after = with_push(START, angle / 3.0, 1.0)
        history.note(before, after, "", 0.0)
        before = after
    assert len(history.past) == KEPT
