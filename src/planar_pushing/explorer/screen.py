"""Connection to the page: shows markup and reports pointers, keys and sizes of pictures."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from panel.custom import JSComponent


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
