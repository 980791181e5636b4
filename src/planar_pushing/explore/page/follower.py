"""Following a push over time on the page: play, scrub, and choose among consistent modes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from bokeh.events import Tap
from bokeh.models import Button, RadioButtonGroup, Slider, Toggle

from planar_pushing.explore.following import (
    WAYS,
    Motion,
    chosen,
    energies,
    followed,
    forgotten,
    said_at,
    taken,
    ways_at,
)
from planar_pushing.explore.page.canvas import TimeCanvas
from planar_pushing.explore.page.controller import Controller
from planar_pushing.explore.page.workers import Worker
from planar_pushing.explore.pictures.motion import mode_bar, picture
from planar_pushing.explore.state import State
from planar_pushing.terms.errors import PlanarPushingError

#: Milliseconds between pictures of a motion that is played, and seconds that the whole of it takes.
STEP, WHOLE = 33, 6.0
#: What stands before the ways on.
CHOICE = "From here on take the way on which it"


class Follower:
    """The widgets of the motion over time, and the motion that they show."""

    def __init__(self, controller: Controller) -> None:
        self.controller = controller
        self.motion: Motion | None = None
        self.key: State | None = None
        self.ways: tuple[str, ...] = ()
        self.quiet = False
        self.canvas = TimeCanvas()
        self.follow = Toggle(name="follow", label="Follow over time", button_type="primary")
        self.play = Toggle(name="play", label="Play", disabled=True)
        self.time = Slider(
            name="time", title="Time", start=0.0, end=1.0, value=0.0, step=0.001, format="0.000",
            disabled=True, sizing_mode="stretch_width",
        )  # fmt: skip
        self.way = RadioButtonGroup(name="way", labels=[], visible=False)
        self.forget = Button(name="forget", label="Forget the choices made", visible=False)
        self.worker = Worker(controller.document, followed, self._keep)
        self.chooser = Worker(controller.document, lambda order: ways_at(*order), self._offer)
        self._listen()

    @property
    def roots(self) -> list[Any]:
        """What the template places."""
        widgets = [self.follow, self.play, self.time, self.way, self.forget]
        return [*widgets, self.canvas.bar, self.canvas.energy]

    def _listen(self) -> None:
        self.follow.on_change("active", lambda name, old, new: self._toggle(new))
        self.play.on_change("active", lambda name, old, new: self._play(new))
        self.time.on_change("value", lambda name, old, new: self._scrub(new))
        self.way.on_change("active", lambda name, old, new: self._take(new))
        self.forget.on_click(self._forget)
        for on in (self.canvas.bar, self.canvas.energy):
            on.on_event(Tap, lambda event: self._jump(event.x))
        self.controller.listeners.append(self._changed)
        self.controller.document.add_periodic_callback(self._tick, STEP)

    def _guarded(self, change: Callable[[], None]) -> None:
        """Change widgets without taking that for the user's doing."""
        self.quiet = True
        try:
            change()
        finally:
            self.quiet = False

    # -- the state ---------------------------------------------------------------------------

    def _changed(self, state: State) -> None:
        """Follow the state anew where it asks for another motion, or stop following."""
        following = state.time is not None
        self._guarded(lambda: self._show_widgets(state, following))
        if not following:
            self.play.active = False
            return
        wanted = replace(state, time=0.0, shown="", across="")
        if wanted != self.key:
            self.key, self.motion = wanted, None
            self.controller.view.say("Following the push \u2026")
            self.worker.ask(wanted)
        else:
            self._draw()

    def _show_widgets(self, state: State, following: bool) -> None:
        self.follow.update(
            active=following, label="Back to the push" if following else "Follow over time"
        )
        self.play.disabled = self.time.disabled = not following
        for figure in (self.canvas.bar, self.canvas.energy):
            figure.visible = following
        self.forget.visible = chosen(state)
        self.controller.view.handle.disabled = following
        if following:
            self.controller.view.solution.disabled = True
        if not following:
            self._show_ways(())

    def _toggle(self, active: bool) -> None:
        if not self.quiet:
            state = self.controller.state
            self.controller.put(replace(state, time=0.0 if active else None))
            if active:
                self.play.active = True
            else:
                self.controller.fit()

    def _play(self, active: bool) -> None:
        self.play.label = "Pause" if active else "Play"
        if active and self.motion is not None and self._now >= self.motion.times[-1]:
            self._scrub(0.0)
        elif not active:
            self._draw()

    def _tick(self) -> None:
        """Go on while the motion is played."""
        if self.play.active and self.motion is not None and self.controller.has_room:
            end = float(self.motion.times[-1])
            later = min(self._now + end * STEP / 1000 / WHOLE, end)
            self._scrub(later)
            self.play.active = later < end

    @property
    def _now(self) -> float:
        return self.controller.state.time or 0.0

    def _scrub(self, given: float) -> None:
        state = self.controller.state
        if not self.quiet and state.time is not None and given != state.time:
            self.controller.move(replace(state, time=float(given)))
            self._draw()

    def _jump(self, given: float) -> None:
        if self.motion is not None:
            self._scrub(min(max(given, 0.0), float(self.motion.times[-1])))

    def _take(self, index: int | None) -> None:
        """Choose a mode where several are consistent."""
        if self.quiet or self.motion is None or index is None:
            return
        self.play.active = False
        self.controller.put(taken(self.controller.state, self.ways[index]))

    def _forget(self) -> None:
        self.controller.put(forgotten(self.controller.state))

    # -- the motion --------------------------------------------------------------------------

    def _keep(self, wanted: State, found: Any) -> None:
        if wanted != self.key:
            return
        if isinstance(found, BaseException):
            known = isinstance(found, PlanarPushingError)
            self.controller.view.say(str(found) if known else f"{type(found).__name__}: {found}")
            return
        self.motion = found
        self.controller.view.say(found.log.attrs["stopped"])
        self.canvas.show(mode_bar(found), found.times, energies(found))
        self._guarded(lambda: self.time.update(end=float(found.times[-1])))
        self.controller.frame(found.bounds)
        self._draw()

    def _draw(self) -> None:
        """Show the instant of the state."""
        if self.motion is None or self.controller.state.time is None:
            return
        now = min(self._now, float(self.motion.times[-1]))
        if self.play.active:
            self._show_ways(())
        else:
            self.chooser.ask((self.controller.state, self.motion, now))
        self.controller.send(picture(self.motion, now), {"words": said_at(self.motion, now)})
        self.canvas.mark(now)
        self._guarded(lambda: self.time.update(value=now))

    def _offer(self, order: tuple[State, Motion, float], found: Any) -> None:
        """Offer the modes to choose from at an instant, if it is still the one that is shown."""
        if order[0] == self.controller.state:
            self._show_ways(() if isinstance(found, BaseException) else found)
            self.controller.resend()

    def _show_ways(self, ways: tuple[str, ...]) -> None:
        self.ways, labels = ways, [WAYS[way] for way in ways]
        self._guarded(lambda: self.way.update(visible=bool(ways), labels=labels, active=None))
        self.controller.view.texts["choice"] = CHOICE if ways else ""

    def close(self) -> None:
        """End the threads."""
        self.worker.close()
        self.chooser.close()
