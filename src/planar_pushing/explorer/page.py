"""The page: events create new states, and every new state creates new pictures."""

from __future__ import annotations

import base64
import logging
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
import panel as pn
from panel.custom import JSComponent
from pydantic import ValidationError

from planar_pushing.explorer.address import query, refusal
from planar_pushing.explorer.downloads import download
from planar_pushing.explorer.field import Field
from planar_pushing.explorer.history import History
from planar_pushing.explorer.lengths import note
from planar_pushing.explorer.pictures.following import (
    CHOICES,
    choices_at,
    has_choices,
    with_choice,
    without_choices,
)
from planar_pushing.explorer.pictures.maps import maps
from planar_pushing.explorer.pointing import Pointing
from planar_pushing.explorer.presets import preset, titles
from planar_pushing.explorer.python_lines import lines
from planar_pushing.explorer.several import FIXED
from planar_pushing.explorer.several import lines as lines_of_contacts
from planar_pushing.explorer.state import State
from planar_pushing.explorer.supports import support_note
from planar_pushing.explorer.view import Order, View, box_of, map_markup, view
from planar_pushing.explorer.widgets import FRAMES, alike, fields, update
from planar_pushing.explorer.worker import Worker
from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.quantities import stop_text


class Screen(JSComponent):  # type: ignore[misc]
    """A component without its own display, which acts on the elements of the template.

    Parameters
    ----------
    hear : callable
        Called with each message of the page, which has a kind and the number of the last event.
    """

    _esm = Path(__file__).with_name("screen.js").read_text(encoding="utf-8")

    def __init__(self, hear: Callable[[dict[str, Any]], None]) -> None:
        super().__init__(width=0, height=0)
        self._hear = hear
        self._known: dict[str, str] = {}

    def _handle_msg(self, data: dict[str, Any]) -> None:
        self._hear(data)

    def tell(self, markup: dict[str, str], **rest: Any) -> None:
        """Send the markup of changed elements by id, and other data for the script."""
        fresh = {name: text for name, text in markup.items() if self._known.get(name) != text}
        self._known |= fresh
        if fresh or rest:
            self._send_msg({"markup": fresh, **rest})

    def forget(self) -> None:
        """Send all markup again, because the page is new."""
        self._known = {}


LOG = logging.getLogger("planar_pushing")
#: Milliseconds between checks of the page, seconds without a change that count as rest, and seconds after
#: which a picture and a map count as slow.
LOOK, REST, SLOW, SLOW_MAP = 100, 0.2, 0.6, 1.6
#: Labels of the buttons that save files, by file name.
SAVES = {
    "scene.yaml": "Scene (YAML)",
    "scene.svg": "Picture (SVG)",
    "log.nc": "Log (netCDF)",
    "scene.py": "Python",
}
COMPUTING = "Computing \u2026"
CLOSED = "The explorer is closed. You can close this page."


class Page:
    """One page: its state, its widgets, and its pictures.

    Parameters
    ----------
    document : Document
        Document of the session; everything except the work of the threads runs in its loop.
    state : State
        The first state.
    message : str
        Error message for the address, if any.
    close : callable
        Ends the server.
    """

    def __init__(
        self, document: Any, state: State, message: str, close: Callable[[], None]
    ) -> None:
        self.document, self.state = document, state
        self.number, self.orders, self.changed_at = 0, 0, 0.0
        self.quiet = self.starts = False
        self.sizes = dict.fromkeys(("scene", "curve", "map", "time"), (700.0, 480.0))
        self.box, self.view = box_of(state), View({})
        self.history = History()
        self.screen, self.pointing = Screen(self._hear), Pointing(self)
        self.fields = fields()
        self.fixed = {"error": escape(message), "note": ""}
        self.painter = Worker(document, view, self._show)
        self.mapper = Worker(document, self._map, self._offer_modes)
        self.writer = Worker(document, lambda order: download(*order), self._save)
        self._build()
        self._listen(close)
        self.show_widgets()
        pn.state.add_periodic_callback(self._look, LOOK)

    def _build(self) -> None:
        """Create the widgets that do not belong to the state."""
        options = {"Start from \u2026": ""} | {title: name for name, title in titles().items()}
        self.preset = pn.widgets.Select(options=options, sizing_mode="stretch_width", margin=0)
        self.solution = pn.widgets.RadioButtonGroup(margin=(2, 6))
        self.choices = {
            policy: pn.widgets.Button(label=name, visible=False) for policy, name in CHOICES.items()
        }
        self.forget = pn.widgets.Button(label="Forget the choices made", visible=False)
        self.saves = {name: pn.widgets.Button(label=word, margin=0) for name, word in SAVES.items()}
        self.undo, self.redo = (
            pn.widgets.Button(label=name, margin=0, disabled=True) for name in ("Undo", "Redo")
        )
        self.close = pn.widgets.Button(label="Close", color="danger", margin=0)

    def _listen(self, close: Callable[[], None]) -> None:
        for field in self.fields.values():
            field.widget.param.watch(partial(self._edit, field), "value")
        self.preset.param.watch(self._start_from, "value")
        self.solution.param.watch(self._choose, "value")
        for policy, button in self.choices.items():
            button.on_click(partial(self._take, policy))
        self.forget.on_click(lambda event: self.change(without_choices))
        for name, button in self.saves.items():
            button.on_click(partial(self._write, name))
        self.undo.on_click(lambda event: self.step(self.history.undo))
        self.redo.on_click(lambda event: self.step(self.history.redo))
        self.close.on_click(partial(self._close, close))

    @property
    def roots(self) -> dict[str, Any]:
        """Everything that the template places, by name."""
        widgets = {name: field.widget for name, field in self.fields.items()}
        widgets |= {name.replace(".", "_"): button for name, button in self.saves.items()}
        widgets |= {"preset": self.preset, "solution": self.solution, "forget": self.forget}
        widgets |= {"undo": self.undo, "redo": self.redo}
        choices = pn.FlexBox(*self.choices.values())
        return widgets | {"close": self.close, "choices": choices, "screen": self.screen}

    # -- states --------------------------------------------------------------------------------------

    def change(
        self, make: Callable[[State], State], name: str = "", value: Any = None, source: str = ""
    ) -> None:
        """Show the state after a change, or report why it is not possible.

        `name` and `value` are the changed widget and its value, and changes of one `source` that follow one
        another are undone together.
        """
        if self.state.several is not None:
            self.document.add_next_tick_callback(self.show_widgets)
            return
        try:
            state = make(self.state)
            _ = state.scene
        except (PlanarPushingError, ValidationError) as error:
            self.say(refusal(error, name, value))
            self.document.add_next_tick_callback(self.show_widgets)
            return
        self.say("")
        if state != self.state:
            self.history.note(self.state, state, source or name, time.monotonic())
            self.put(state)

    def step(self, move: Callable[[State], State | None]) -> None:
        """Undo or redo a step, if there is one; not during a drag."""
        if self.pointing.held:
            return
        state = move(self.state)
        if state is not None:
            self.say("")
            self._stop_player()
            self.put(state)

    def turn_upright(self) -> None:
        """Draw the push again after its contact was dragged, with the fence below."""
        self.box = box_of(self.state)
        self.draw()

    def put(self, state: State) -> None:
        """Show another state; while a handle or only the time moves, the widgets are updated at rest."""
        times = self.state.time, state.time
        plays = None not in times and replace(self.state, time=state.time) == state
        self.state = state
        if not (self.pointing.held or plays):
            self.show_widgets()
        self.draw()

    def draw(self) -> None:
        """Request the pictures of the state."""
        self.orders, self.changed_at = self.orders + 1, time.monotonic()
        self.painter.ask(self._order())

    def _order(self) -> Order:
        """Request for the pictures of the state as it is now."""
        grip, grabbed = self.pointing.grip, self.pointing.grabbed
        return Order(self.state, self.sizes, self.box, self.number, grip, grabbed)

    @property
    def force(self) -> Array | None:
        """The force drawn in full."""
        return None if self.view.push is None else self.view.push.force

    @property
    def subject(self) -> State:
        """State for the map: that of the push, or of the instant."""
        return self.view.instant or replace(self.state, time=None)

    # -- events --------------------------------------------------------------------------------------

    def _hear(self, event: dict[str, Any]) -> None:
        """Handle an event of the page; answer with a picture, or with its number if no picture is new."""
        self.number, orders = event["number"], self.orders
        if event["kind"] == "sizes":
            self._resize(event["sizes"])
        elif event["kind"] in ("undo", "redo"):
            self.step(getattr(self.history, event["kind"]))
        else:
            self.pointing.hear(event)
        if self.orders == orders and self.painter.seconds:
            self.draw()
        elif self.orders == orders:
            self.screen.tell({}, number=self.number)

    def _resize(self, sizes: dict[str, list[float]]) -> None:
        """Draw for a page that has been loaded or has pictures of other sizes."""
        self.sizes |= {name: (float(w), float(h)) for name, (w, h) in sizes.items() if w and h}
        self.screen.forget()
        self.draw()

    def _edit(self, field: Field, event: Any) -> None:
        late = field is self.fields["time"] and self.state.time is None
        if not (self.quiet or late or alike(event.new, field.read(self.state))):
            name = field.widget.label
            self.change(lambda state: field.write(state, event.new), name, event.new)
            self.starts = field is self.fields["follow"] and event.new
            if field is self.fields["time"] and event.new < field.widget.end:
                field.widget.loop_policy = "once"

    def _start_from(self, event: Any) -> None:
        if event.new:
            self.preset.value = ""
            self._stop_player()
            state = preset(event.new)
            self.history.note(self.state, state, "", time.monotonic())
            self.put(state)

    def _stop_player(self) -> None:
        """Stop the player; a frame that the browser sends before it knows is not taken."""
        self.starts, self.fields["time"].widget.direction = False, 0

    def _choose(self, event: Any) -> None:
        if not self.quiet and event.new:
            self.change(lambda state: replace(state, shown=event.new))

    def _take(self, policy: str, event: Any) -> None:
        self.change(lambda state: with_choice(state, policy))

    def _write(self, name: str, event: Any) -> None:
        self.writer.ask((self.state, name))

    def _save(self, order: tuple[State, str], answer: Any) -> None:
        """Send a file to the browser."""
        if isinstance(answer, BaseException):
            self.say(refusal(answer))
        else:
            self.screen.tell({}, file=[order[1], base64.b64encode(answer).decode()])

    def _close(self, close: Callable[[], None], event: Any) -> None:
        self.screen.tell({"words": CLOSED})
        close()

    def end(self) -> None:
        """Stop the threads of a closed page."""
        for worker in (self.painter, self.mapper, self.writer):
            worker.close()

    # -- pictures, texts and widgets -----------------------------------------------------------------

    def _show(self, order: Order, answer: Any) -> None:
        """Show the pictures of a state, or report why there are none."""
        if isinstance(answer, BaseException):
            LOG.debug("no picture", exc_info=answer)
            self.say(refusal(answer))
            self.screen.tell({}, number=order.number)
            return
        self.view = answer
        self.screen.tell(self.fixed | answer.markup, number=order.number)
        if self.starts and answer.motion is not None:
            self.starts, self.fields["time"].widget.direction = False, 1

    def say(self, text: str) -> None:
        """Show an error message, or clear it."""
        self.fixed["error"] = escape(text)
        self.screen.tell(self.fixed)

    def show_widgets(self) -> None:
        """Update the widgets from the state."""
        self.quiet = True
        try:
            for field in self.fields.values():
                update(field.widget, field.more(self.state) | {"value": field.read(self.state)})
            self._show_choices()
            update(self.undo, {"disabled": not self.history.past})
            update(self.redo, {"disabled": not self.history.future})
        finally:
            self.quiet = False

    def _show_choices(self) -> None:
        """Offer the solutions to draw in full, the available times, and a button to forget choices."""
        self.forget.visible = has_choices(self.state)
        motion, push = self.view.motion, self.view.push
        if push is not None:
            names = [solution.mode.name for solution in push.solutions]
            labels = {name.replace("_", " ").capitalize(): name for name in names}
            value = names[push.chosen] if names else None
            off = self.state.time is not None or len(names) < 2
            update(self.solution, {"options": labels, "value": value, "disabled": off})
        elif self.state.several is not None:
            update(self.solution, {"options": {}, "value": None, "disabled": True})
        if motion is not None and self.state.time is not None:
            player = self.fields["time"].widget
            end = max(int(np.ceil(FRAMES * motion.times[-1] / self.state.duration - 1e-9)), 1)
            over = player.value >= end  # then it restarts from the beginning
            update(player, {"end": end, "loop_policy": "loop" if over else "once"})

    def _look(self) -> None:
        """Report slow computations, and update the page once it is at rest."""
        motion = self.view.motion if self.state.time is not None else None
        said = "" if motion is None else stop_text(motion.log)
        said = said if self.state.several is None else FIXED
        if self.painter.seconds > SLOW or self.mapper.seconds > SLOW_MAP:
            said = COMPUTING
        self.fixed["note"] = escape(said[:1].upper() + said[1:])
        self.screen.tell(self.fixed)
        rested = time.monotonic() - self.changed_at > REST and not self.painter.seconds
        if self.changed_at and rested:
            self.changed_at = 0.0
            self._rest()

    def _rest(self) -> None:
        """Update what takes longer: all widgets, the frame, the address, and the map."""
        self.show_widgets()
        box = box_of(self.state)
        if not self.pointing.held and not np.array_equal(box, self.box):
            self.box = box
            self.painter.ask(self._order())
        title = self.state.file.title
        contacts = self.state.several
        program = lines(self.state) if contacts is None else lines_of_contacts(contacts)
        texts = {"python": escape(program), "title": escape(title)}
        texts |= {
            "lengths": escape(note(self.state)),
            "support-note": escape(support_note(self.state)),
        }
        self.screen.tell(texts, address=query(self.state), title=title)
        if contacts is None:
            self.mapper.ask((self.state, self.subject, self.view))

    def _map(self, order: tuple[State, State, View]) -> tuple[str, ...]:
        """Draw a coarse and a finer map; return the modes to choose from. Runs in the mapper's thread."""
        state, subject, current = order
        for modes in maps(subject):
            markup = map_markup(subject, modes, self.sizes["map"])
            markup["map-when"] = current.markup["when"]
            self.document.add_next_tick_callback(partial(self._show_map, order, markup))
            if self.mapper.wanted:
                return ()
        if state.time is None or current.motion is None:
            return ()
        return choices_at(state, current.motion, state.time)

    def _show_map(self, order: tuple[State, State, View], markup: dict[str, str]) -> None:
        """Show a map if its picture is still shown, so that both are of one instant."""
        if order[0] == self.state:
            self.screen.tell(markup)

    def _offer_modes(self, order: tuple[State, State, View], answer: Any) -> None:
        """Offer the modes to choose from at an instant if it is still shown."""
        if isinstance(answer, BaseException):
            LOG.debug("no map", exc_info=answer)
        elif order[0] == self.state:
            self.screen.tell({"choice": "From here on, the contact" if answer else ""})
            for policy, button in self.choices.items():
                update(button, {"visible": policy in answer})
