"""Server of the page, for this machine only, with everything that the page needs."""

from __future__ import annotations

import asyncio
import gc
import logging
import re
import socket
import warnings
import webbrowser
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import panel as pn
from panel.io.server import get_server
from tornado.routing import HostMatches, Rule

from planar_pushing.explorer.address import state_in
from planar_pushing.explorer.page import Page
from planar_pushing.explorer.presets import FIRST, preset
from planar_pushing.explorer.several import open_state
from planar_pushing.explorer.state import State
from planar_pushing.scenes.contacts_model import ContactsFile
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.terms.errors import (
    EarlyEndWarning,
    InvalidValue,
    PlanarPushingError,
    SceneWarning,
)

HOST = "127.0.0.1"
#: Names of this machine by which the page can be requested.
HOSTS = (HOST, "localhost")
FOLDER = Path(__file__).parent


class Explorer:
    """A server with one page, which shows a first state unless its address gives another."""

    def __init__(self, file: SceneFile | ContactsFile | None = None, port: int = 0) -> None:
        self.first = preset(FIRST) if file is None else open_state(file)
        port = _free(port)
        # Tornado uses the current loop; some versions of Python warn if there is none.
        asyncio.set_event_loop(asyncio.new_event_loop())
        origins = [f"{name}:{port}" for name in HOSTS]
        self.server: Any = get_server(
            {"/": self._page}, port, HOST, websocket_origin=origins, title="Planar pushing"
        )
        _refuse_other_requests(self.server._tornado)
        for listener in self.server._http._sockets.values():
            # Otherwise TCP delays a small message by up to 40 ms, until the previous one is acknowledged.
            listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    @property
    def url(self) -> str:
        """Address of the page."""
        return f"http://{HOST}:{self.server.port}/"

    def run(self, open_browser: bool) -> None:
        """Serve until Ctrl-C, or until the page's own button is pressed."""
        # A page that closes while a message is in transit is not an error.
        logging.getLogger("bokeh.server.views.ws").setLevel(logging.ERROR)
        gc.freeze()  # a full garbage collection of all modules would stop the server for 0.2 s
        self.server.start()
        if open_browser:
            self.server.io_loop.add_callback(webbrowser.open, self.url)
        try:
            with warnings.catch_warnings():
                # A dragged object passes through many doubtful scenes, and its page shows what happens.
                for category in (SceneWarning, EarlyEndWarning):
                    warnings.simplefilter("ignore", category)
                self.server.io_loop.start()
        except KeyboardInterrupt:
            pass
        finally:
            self.server.stop()

    def stop(self) -> None:
        """Stop the server after 0.2 s, so that the last message arrives."""
        self.server.io_loop.call_later(0.2, self.server.io_loop.stop)

    def _page(self) -> Any:
        """Create the page of a session."""
        state, message = self._state(_decode(pn.state.session_args))
        page = Page(pn.state.curdoc, state, message, self.stop)
        template = pn.Template((FOLDER / "page.html").read_text(encoding="utf-8"))
        template.add_variable("style", (FOLDER / "page.css").read_text(encoding="utf-8"))
        for name, root in page.roots.items():
            template.add_panel(name, root)
        pn.state.on_session_destroyed(lambda context: page.end())
        return template

    def _state(self, arguments: dict[str, str]) -> tuple[State, str]:
        """State in the address, and the message about an error in it."""
        try:
            return (state_in(arguments) if arguments else self.first), ""
        except PlanarPushingError as error:
            return preset(FIRST), " ".join(str(error).split())


def _decode(arguments: Mapping[str, list[bytes]]) -> dict[str, str]:
    """Arguments of an address as text, without those of the protocol; other bytes are replaced."""
    return {
        key: values[0].decode(errors="replace")
        for key, values in arguments.items()
        if not key.startswith("bokeh-")
    }


class _OwnRequests(HostMatches):
    """Requests to this machine's own names, so that no other site can name this server.

    A path that leaves a folder or has a null character names no file of the page, and a page with an
    address in https cannot come from this server. All of these are answered by 404.
    """

    def match(self, request: Any) -> dict[str, Any] | None:
        path = unquote(request.path)
        is_odd = ".." in re.split(r"[/\\]", path) or "\0" in path
        if is_odd or request.headers.get("Origin", "").startswith("https:"):
            return None
        return super().match(request)


def _refuse_other_requests(application: Any) -> None:
    """Answer only the requests that this server is for."""
    names = "|".join(map(re.escape, HOSTS))
    application.default_router.rules[:] = [
        Rule(_OwnRequests(f"({names})"), application.wildcard_router)
    ]


def _free(port: int) -> int:
    """Return the given port, or a free port for 0.

    Raises
    ------
    InvalidValue
        If the port cannot be used.
    """
    try:
        with socket.socket() as trial:
            trial.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            trial.bind((HOST, port))
            return int(trial.getsockname()[1])
    except (OSError, OverflowError):
        remedy = "leave it out to use a free port"
        raise InvalidValue("port", port, "a port from 1 to 65535 that is free", remedy) from None
