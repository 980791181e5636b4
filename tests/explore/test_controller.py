"""The page's state without a browser: what it says while it waits, and how fast it sends pictures."""

import json
import threading
import time

import numpy as np
import pytest
from bokeh.document import Document

from planar_pushing.explore.handles import Handle, places
from planar_pushing.explore.page import drawing
from planar_pushing.explore.page.controller import Controller
from planar_pushing.explore.page.view import View
from planar_pushing.explore.presets import preset


class Slow:
    """Pictures that are made only once they may be, as on the first call of code that is compiled."""

    def __init__(self):
        self.may, self.made, self.orders = threading.Event(), drawing.pictures, []

    def __call__(self, order):
        self.orders.append(order)
        assert self.may.wait(20)
        return self.made(order)


@pytest.fixture
def slow(monkeypatch):
    found = Slow()
    monkeypatch.setattr(drawing, "pictures", found)
    yield found
    found.may.set()


@pytest.fixture
def page(slow):
    """A page that is shown; what is in the browser is played by the tests."""
    found = Controller(Document(), View(), preset("figure_03"))
    found.start()
    yield found
    found.close()


def play(page, kind):
    """The page's loop calls what waits for it; how many calls there were."""
    waiting = [
        each for each in page.document.session_callbacks if type(each).__name__ == f"{kind}Callback"
    ]
    for each in waiting:
        each.callback()
    return len(waiting)


def finish(page):
    """Let the worker end, and the page's loop take its result."""
    end = time.monotonic() + 20
    while page.painter.worker.busy and not play(page, "NextTick"):
        assert time.monotonic() < end
        time.sleep(0.001)


def take(page):
    """The browser takes the last picture."""
    page.view.channels.taken.data = {"number": [page.painter.sent]}


def move(page, kind, place):
    """The browser tells of a pointer at a place of the picture."""
    x, y, scale = page.view.scene.sheet
    data = {"kind": [kind], "x": [x + scale * place[0]], "y": [y - scale * place[1]], "number": [0]}
    page.view.channels.pointers["scene"].data = data


def content(page):
    return json.loads(page.view.channels.picture.data["content"][0])


def test_a_slow_first_picture_is_said_to_be_compiled(page, slow, monkeypatch):
    monkeypatch.setattr(drawing, "LONG", 0.0)
    play(page, "Periodic")
    assert "Compiling this kind of slider" in page.view.status.text
    slow.may.set()
    finish(page)
    play(page, "Periodic")
    assert page.view.status.text == ""
    assert "The contact sticks" in content(page)["words"]


def test_moves_that_come_while_a_picture_is_made_are_one_move(page, slow):
    slow.may.set()
    finish(page)
    take(page)
    slow.may.clear()
    move(page, "grab", places(page.state, page.force)[Handle.PUSHER])
    for angle in (10.0, 20.0, 30.0):
        turn = np.deg2rad(angle)
        move(page, "drag", (np.cos(turn), np.sin(turn)))
    assert page.state.angle == pytest.approx(10.0)
    slow.may.set()
    finish(page)
    assert page.state.angle == pytest.approx(30.0)
    finish(page)
    assert [order.state.angle for order in slow.orders[-2:]] == pytest.approx([10.0, 30.0])
    assert page.view.channels.picture.data["moves"] == [3]


def test_a_page_that_is_behind_is_not_sent_more(page, slow, monkeypatch):
    monkeypatch.setattr(drawing, "PATIENCE", 1e6)
    slow.may.set()
    finish(page)
    while page.has_room:
        page.resend()
    sent, angle = page.painter.sent, page.state.angle
    move(page, "grab", places(page.state, page.force)[Handle.PUSHER])
    move(page, "drag", (0.0, 1.0))
    assert (page.painter.sent, page.state.angle) == (sent, angle)
    take(page)
    assert page.state.angle == pytest.approx(90.0)


def test_a_drop_is_followed_even_then(page):
    move(page, "grab", places(page.state, None)[Handle.PUSHER])
    move(page, "drag", (0.0, 1.0))
    move(page, "drop", (0.0, 1.0))
    assert page.state.angle == pytest.approx(90.0)
    assert page.pointing.held is None


def test_only_what_is_new_is_sent(page, slow):
    slow.may.set()
    finish(page)
    assert set(content(page)) == {"scene", "curve", "words", "solutions"}
    page.resend()
    assert content(page) == {}
    page.view.channels.sizes.data = {"scene": [350.0, 240.0], "curve": [340.0, 340.0]}
    assert "scene" in content(page)
    assert "words" not in content(page)


def test_widgets_follow_a_drag_once_it_rests(page, slow):
    slow.may.set()
    finish(page)
    take(page)
    angle = page.view.controls["angle"].widget
    before = angle.value
    move(page, "grab", places(page.state, None)[Handle.PUSHER])
    move(page, "drag", (0.0, 1.0))
    assert angle.value == before
    play(page, "Timeout")
    assert angle.value == pytest.approx(90.0)
