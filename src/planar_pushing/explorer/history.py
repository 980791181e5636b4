"""The states before and after the one that is shown, for undo and redo."""

from __future__ import annotations

from dataclasses import replace

from planar_pushing.explorer.state import State, without_display

#: Number of states that can be undone.
KEPT = 200
#: Seconds within which changes by one widget are one step, such as those of a slider that is dragged.
JOINED = 1.0


class History:
    """Steps of the user, each a state; a drag is one step, and so are quick changes by one widget."""

    def __init__(self) -> None:
        self.past: list[State] = []
        self.future: list[State] = []
        self._source, self._noted_at = "", -JOINED

    def note(self, before: State, after: State, source: str, seconds: float) -> None:
        """Note a change of the state at a time in seconds, made by the drag or the widget of this name."""
        if without_display(before) == without_display(after):
            return
        joins = source != "" and source == self._source and seconds - self._noted_at < JOINED
        if not (joins and self.past):
            self.past = [*self.past, before][-KEPT:]
        self._source, self._noted_at, self.future = source, seconds, []

    def rest(self) -> None:
        """End the step, so that the next change is one of its own."""
        self._source = ""

    def undo(self, current: State) -> State | None:
        """The state before the last step; None if there is none."""
        return self._move(self.past, self.future, current)

    def redo(self, current: State) -> State | None:
        """The state before the last undo; None if there is none."""
        return self._move(self.future, self.past, current)

    def _move(self, source: list[State], target: list[State], current: State) -> State | None:
        self.rest()
        if not source:
            return None
        target.append(current)
        state = source.pop()
        # The map and the unit stay as they are now.
        return replace(state, time=None, across=current.across, unit=current.unit)
