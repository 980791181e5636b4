"""The page without a browser: what it says while it waits, and which pictures it makes."""

import threading
import time
from dataclasses import replace

import numpy as np
import panel as pn
import pytest

from planar_pushing.explorer import page as module
from planar_pushing.explorer.pictures.handles import handle_positions
from planar_pushing.explorer.presets import preset
from planar_pushing.explorer.state import Handle
from planar_pushing.explorer.view import sheet_of
from planar_pushing.explorer.worker import Worker


class Loop:
    """A document whose loop the tests turn."""

    def __init__(self):
        self.waiting = []

    def add_next_tick_callback(self, call):
        self.waiting.append(call)

    def turn(self, until):
        """Run what waits until something is true."""
        end = time.monotonic() + 60
        while not until():
            assert time.monotonic() < end
            for call in list(self.waiting):
                self.waiting.remove(call)
                call()
            time.sleep(0.001)


class Slow:
    """Pictures that are made only once they may be."""

    def __init__(self, made):
        self.may, self.made, self.orders = threading.Event(), made, []

    def __call__(self, order):
        self.orders.append(order)
        assert self.may.wait(60)
        return self.made(order)


@pytest.fixture
def slow(monkeypatch):
    found = Slow(module.view)
    monkeypatch.setattr(module, "view", found)
    yield found
    found.may.set()


@pytest.fixture
def page(slow, monkeypatch):
    monkeypatch.setattr(pn.state, "add_periodic_callback", lambda *given: None)
    found = module.Page(Loop(), preset("figure_03"), "", lambda: None)
    found.told = {}
    monkeypatch.setattr(found.screen, "_send_msg", lambda sent: found.told.update(sent["markup"]))
    yield found
    found.end()


def rest(page):
    """Let all pictures be made."""
    page.document.turn(lambda: not page.painter.seconds and not page.painter.wanted)


def pointer(page, kind, place, number):
    x, y = sheet_of(page.sizes["scene"], page.box).to_sheet(place)
    page._hear({"kind": kind, "picture": "scene", "x": x, "y": y, "number": number})


def test_a_slow_picture_is_said_to_be_computed(page, slow, monkeypatch):
    monkeypatch.setattr(module, "SLOW", 0.0)
    page.draw()
    page._look()
    assert page.told["note"] == module.COMPUTING
    slow.may.set()
    rest(page)
    page._look()
    assert page.told["note"] == ""
    assert "The contact sticks" in page.told["words"]


def test_moves_that_come_while_a_picture_is_made_are_one_move(page, slow):
    slow.may.set()
    page.draw()
    rest(page)
    slow.may.clear()
    pointer(page, "grab", handle_positions(page.state, page.force)[Handle.PUSHER], 1)
    for number, angle in enumerate((10.0, 20.0, 30.0)):
        turn = np.deg2rad(angle)
        pointer(page, "drag", (np.cos(turn), np.sin(turn)), 2 + number)
    slow.may.set()
    rest(page)
    assert [order.state.angle for order in slow.orders[1:]] == pytest.approx([10.0, 30.0])
    assert slow.orders[-1].number == 4


def test_widgets_follow_a_drag_once_it_rests(page, slow):
    slow.may.set()
    page.draw()
    rest(page)
    angle = page.fields["angle"].widget
    before = angle.value
    pointer(page, "grab", handle_positions(page.state, page.force)[Handle.PUSHER], 1)
    pointer(page, "drag", (0.0, 1.0), 2)
    assert (page.state.angle, angle.value) == (pytest.approx(90.0), before)
    page._rest()
    assert angle.value == pytest.approx(90.0)


def test_an_early_end_of_a_run_is_called_a_stop(page, slow):
    slow.may.set()
    page.put(replace(preset("figure_02"), time=0.0))
    rest(page)
    page._look()
    end = page.view.motion.times[-1]
    assert end < page.state.duration
    reason = "the slider&#x27;s center comes down to the fence"
    assert page.told["note"] == f"Stopped at t = {end:.6g}: {reason}"
    page.put(preset("figure_02"))
    rest(page)
    page._look()
    assert page.told["note"] == ""


def test_another_preset_stops_the_player(page, slow):
    slow.may.set()
    player = page.fields["time"].widget
    page.fields["follow"].widget.value = True
    rest(page)
    assert (player.direction, page.state.time) == (1, 0.0)
    page.preset.value = "figure_08"
    rest(page)
    assert player.direction == 0
    assert page.state == preset("figure_08")
    player.value += 1  # on its way when the player stopped
    assert page.state == preset("figure_08")
    page.fields["follow"].widget.value = True
    rest(page)
    assert player.direction == 1


@pytest.mark.parametrize(("name", "value", "said"), [
    ("weight", -1.0, "Friction W: -1.0 given; allowed: a finite number > 0"),
    ("effects", [], "Effects: nothing given; allowed: a list with at least one entry"),
])  # fmt: skip
def test_a_bad_value_is_said_in_one_line_and_taken_back(page, name, value, said):
    widget = page.fields[name].widget
    before = widget.value
    widget.value = value
    page.document.turn(lambda: widget.value == before)
    assert page.fixed["error"].replace("&gt;", ">").startswith(said)
    assert page.state == preset("figure_03")


def test_a_worker_hands_errors_to_its_owner():
    found, loop = [], Loop()
    worker = Worker(loop, lambda order: 1 / order, lambda order, result: found.append(result))
    worker.ask(0)
    loop.turn(lambda: found)
    assert isinstance(found[0], ZeroDivisionError)
    worker.close()
