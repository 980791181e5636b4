"""The server of the page: on this machine alone, with all that the page needs."""

from __future__ import annotations

import asyncio
import base64
import gc
import logging
import socket
import webbrowser
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from bokeh.application import Application
from bokeh.application.handlers.function import FunctionHandler
from bokeh.core.templates import FILE
from bokeh.models import InlineStyleSheet
from bokeh.server.server import Server
from jinja2 import Environment

from planar_pushing.explore.address import state_in
from planar_pushing.explore.downloads import written
from planar_pushing.explore.page.controller import Controller
from planar_pushing.explore.page.follower import Follower
from planar_pushing.explore.page.view import View
from planar_pushing.explore.page.workers import Worker
from planar_pushing.explore.presets import FIRST, preset
from planar_pushing.explore.state import State, state_of
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.terms.errors import InvalidValue, PlanarPushingError

HOST = "127.0.0.1"
PAGE = Path(__file__).parent / "page"


class Explorer:
    """A server with one page, which shows a first state unless its address says another."""

    def __init__(self, file: SceneFile | None = None, port: int = 0) -> None:
        self.first = preset(FIRST) if file is None else state_of(file)
        _require_free(port)
        # Tornado takes the current loop; some versions of Python warn where there is none.
        asyncio.set_event_loop(asyncio.new_event_loop())
        application = Application(FunctionHandler(self._page))
        self.server: Any = Server({"/": application}, address=HOST, port=port)
        for name in (HOST, "localhost"):
            self.server._tornado._websocket_origins.add(f"{name}:{self.server.port}")

    @property
    def url(self) -> str:
        """Address of the page."""
        return f"http://{HOST}:{self.server.port}/"

    def run(self, open_browser: bool) -> None:
        """Serve until Ctrl-C, or until the page's own button is pressed."""
        # That a page is gone while something is on its way to it is nothing to say.
        logging.getLogger("bokeh.server.views.ws").setLevel(logging.ERROR)
        gc.freeze()  # a full collection went through all modules, and stopped the server for 0.2 s
        self.server.start()
        if open_browser:
            self.server.io_loop.add_callback(webbrowser.open, self.url)
        try:
            self.server.io_loop.start()
        except KeyboardInterrupt:
            pass
        finally:
            self.server.stop()

    def stop(self) -> None:
        """End the server once what is going on is done."""
        self.server.io_loop.call_later(0.2, self.server.io_loop.stop)

    def _page(self, document: Any) -> None:
        """Make the page of a session."""
        state, said = self._state(document)
        view = View()
        controller = Controller(document, view, state)
        follower = Follower(controller)
        _add_files(document, controller)
        view.preset.on_change("value", partial(_start_from, controller))
        view.close.on_click(partial(self._close, controller))
        sheet = InlineStyleSheet(css=(PAGE / "texts.css").read_text(encoding="utf-8"))
        with document.models.freeze():  # else every root has the document look through all models
            for root in [*view.roots, *follower.roots]:
                if hasattr(root, "text"):
                    root.stylesheets = [sheet]
                document.add_root(root)
        document.on_event("document_ready", self._send_at_once)
        document.title = state.file.title or "Planar pushing"
        document.template = _template()
        document.template_variables["style"] = (PAGE / "page.css").read_text(encoding="utf-8")
        for part in (controller, follower):
            document.on_session_destroyed(lambda context, part=part: part.close())
        controller.start()
        view.say(said)

    def _send_at_once(self, event: Any) -> None:
        """Send small messages without delay.

        TCP holds one back until the page has acknowledged the one before, which takes up to 40 ms.
        """
        for client in self.server._tornado._clients:
            client._socket.set_nodelay(True)

    def _state(self, document: Any) -> tuple[State, str]:
        """The state in the address, and what is wrong with it."""
        request = document.session_context.request
        given = (
            {key: values[0].decode() for key, values in request.arguments.items()}
            if request
            else {}
        )
        given = {key: each for key, each in given.items() if not key.startswith("bokeh-")}
        try:
            return (state_in(given) if given else self.first), ""
        except PlanarPushingError as error:
            return self.first, " ".join(str(error).split())

    def _close(self, controller: Controller) -> None:
        words = "The explorer is closed. You can close this page."
        controller.send(controller.view.scene.columns, {"words": words})
        self.stop()


def _require_free(port: int) -> None:
    """Refuse a port that cannot be served on."""
    try:
        with socket.socket() as trial:
            trial.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            trial.bind((HOST, port))
    except (OSError, OverflowError):
        remedy = "leave it out: a free one is taken"
        raise InvalidValue("port", port, "a port from 1 to 65535 that is free", remedy) from None


def _template() -> Any:
    environment = Environment(loader=FILE.environment.loader, autoescape=False)
    return environment.from_string((PAGE / "page.html").read_text(encoding="utf-8"))


def _start_from(controller: Controller, name: str, old: str, new: str) -> None:
    """Show a preset."""
    if new:
        controller.view.preset.value = ""
        controller.put(preset(new))
        controller.fit()


def _add_files(document: Any, controller: Controller) -> None:
    """Let each button save its file, which is written in a thread."""

    def keep(order: tuple[str, State], content: Any) -> None:
        if isinstance(content, BaseException):
            controller.view.say(" ".join(str(content).split()))
        else:
            controller.view.save(order[0], base64.b64encode(content).decode())

    worker = Worker(document, lambda order: written(order[1], order[0]), keep)

    def saver(name: str) -> Callable[[], None]:
        return lambda: worker.ask((name, controller.state))

    for name, button in controller.view.saves.items():
        button.on_click(saver(name))
