"""The page's side of the server: shows markup, and tells of pointers, keys and sizes of pictures."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from panel.custom import JSComponent


class Screen(JSComponent):  # type: ignore[misc]
    """A component without a look of its own, on the elements of the template.

    Parameters
    ----------
    hear : callable
        Takes each message of the page: its kind, and the number of the last event.
    """

    _esm = Path(__file__).with_name("screen.js").read_text(encoding="utf-8")

    def __init__(self, hear: Callable[[dict[str, Any]], None]) -> None:
        super().__init__(width=0, height=0)
        self._hear = hear
        self._known: dict[str, str] = {}

    def _handle_msg(self, data: dict[str, Any]) -> None:
        self._hear(data)

    def tell(self, markup: dict[str, str], **rest: Any) -> None:
        """Set the elements that differ by their ids, and what else the script knows."""
        fresh = {name: text for name, text in markup.items() if self._known.get(name) != text}
        self._known |= fresh
        if fresh or rest:
            self._send_msg({"markup": fresh, **rest})

    def forget(self) -> None:
        """Send all markup again: the page is new."""
        self._known = {}
