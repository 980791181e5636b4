"""The server without a page."""

import http.client
import subprocess
import sys
import threading

import pytest

from planar_pushing.explorer import server as module
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


@pytest.fixture(scope="module")
def explorer():
    """A server whose loop runs in a thread."""
    served, ready = [], threading.Event()

    def serve():
        served.append(module.Explorer())
        served[0].server.io_loop.add_callback(ready.set)
        served[0].run(False)

    thread = threading.Thread(target=serve)
    thread.start()
    assert ready.wait(30)
    yield served[0]
    served[0].server.io_loop.add_callback(served[0].stop)
    thread.join()


@pytest.mark.parametrize(("host", "status"), [
    ("127.0.0.1", 200), ("localhost", 200), ("LOCALHOST", 200), ("evil.example", 404),
    ("127.0.0.1.evil.example", 404), ("localhost.evil.example", 404), ("127x0x0x1", 404),
])  # fmt: skip
def test_only_this_machine_s_names_are_served(explorer, host, status):
    connection = http.client.HTTPConnection("127.0.0.1", explorer.server.port, timeout=60)
    connection.request("GET", "/", headers={"Host": f"{host}:{explorer.server.port}"})
    assert connection.getresponse().status == status
    connection.close()


@pytest.mark.parametrize("path", [
    "/components/../../../etc/passwd", "/components/%2e%2e/%2E%2e/etc/passwd", "/static/../x",
    "/static/js/..%5c..%5cx", "/static/js/%00", "/%00", "/nowhere",
])  # fmt: skip
def test_odd_paths_are_not_found(explorer, path, caplog):
    connection = http.client.HTTPConnection("127.0.0.1", explorer.server.port, timeout=60)
    connection.request("GET", path)
    assert connection.getresponse().status == 404
    connection.close()
    assert not [each for each in caplog.records if each.levelname == "ERROR"]


@pytest.mark.parametrize(("scheme", "status"), [("http", 200), ("https", 404)])
def test_no_page_in_https_is_ours(explorer, scheme, status):
    connection = http.client.HTTPConnection("127.0.0.1", explorer.server.port, timeout=60)
    connection.request(
        "GET", "/", headers={"Origin": f"{scheme}://127.0.0.1:{explorer.server.port}"}
    )
    assert connection.getresponse().status == status
    connection.close()


@pytest.mark.parametrize("query", ["effects=" + "[" * 3000, "title=%ff%fe"])
def test_a_hostile_address_gives_a_page(explorer, query, caplog):
    connection = http.client.HTTPConnection("127.0.0.1", explorer.server.port, timeout=60)
    connection.request("GET", f"/?{query}")
    answer = connection.getresponse()
    assert (answer.status, b"Planar pushing" in answer.read()) == (200, True)
    connection.close()
    assert not [each for each in caplog.records if each.levelname == "ERROR"]


def test_bytes_that_are_no_text_are_replaced():
    given = {"title": [b"\xff\xfe"], "angle": [b"90"], "bokeh-session-id": [b"x"]}
    assert module._decode(given) == {"title": "\ufffd\ufffd", "angle": "90"}


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
