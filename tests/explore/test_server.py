"""The server without a page."""

import subprocess
import sys

import pytest

from planar_pushing.explore import server as module
from planar_pushing.terms.errors import InvalidValue


def test_the_browser_is_given_the_address(monkeypatch):
    opened = []
    explorer = module.Explorer()
    monkeypatch.setattr(module.webbrowser, "open", opened.append)
    explorer.server.io_loop.call_later(0.2, explorer.stop)
    explorer.run(True)
    assert opened == [explorer.url]
    assert explorer.url.startswith("http://127.0.0.1:")


def test_a_port_is_served_on_once():
    explorer = module.Explorer()
    try:
        with pytest.raises(InvalidValue, match="port"):
            module.Explorer(port=explorer.server.port)
    finally:
        explorer.server.stop()
        explorer.server.unlisten()


def test_pages_name_nothing_outside_of_this_machine():
    for name in ("page.html", "page.css", "screen.js"):
        text = (module.FOLDER / name).read_text(encoding="utf-8")
        assert "http:" not in text
        assert "https:" not in text


def test_a_missing_extra_is_named():
    code = (
        "import sys; sys.modules['panel'] = None\n"
        "from planar_pushing.commands import main; sys.exit(main(['explore']))"
    )
    ended = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False
    )
    assert (ended.returncode, ended.stdout) == (2, "")
    assert ended.stderr == (
        "planar-pushing explore: panel: not installed; install the extra explore: "
        "pip install '.[explore]' in the project's folder\n"
    )
