"""The explorer in a process of its own, and Chromium on its page."""

import shutil
import signal
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

from signals import interruptible

FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--js-flags=--expose-gc",
)  # fmt: skip
#: What Debian and others call the browser.
NAMES = ("chromium", "chromium-browser", "google-chrome")


def browser_path():
    """Chromium on this machine; None where there is none."""
    return next(filter(None, map(shutil.which, NAMES)), None)


class Server:
    """`planar-pushing explore` without a browser of its own."""

    def __init__(self, *arguments):
        command = [sys.executable, "-m", "planar_pushing", "explore", "--no-browser"]
        self.process = subprocess.Popen(
            [*command, *map(str, arguments)],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            preexec_fn=interruptible,
        )
        self.url = self.process.stdout.readline().split(" ")[0]

    @property
    def memory(self):
        """Resident memory, bytes."""
        status = Path(f"/proc/{self.process.pid}/status").read_text(encoding="ascii")
        line = next(each for each in status.splitlines() if each.startswith("VmRSS"))
        return 1024 * int(line.split()[1])

    def ended(self, timeout=20):
        """Exit code, and what was said at the end."""
        out, err = self.process.communicate(timeout=timeout)
        return self.process.returncode, out, err

    def interrupt(self):
        """Press Ctrl-C."""
        self.process.send_signal(signal.SIGINT)
        return self.ended()

    def kill(self):
        """End a server that a test has left."""
        if self.process.poll() is None:
            self.process.kill()
            self.process.communicate()


@contextmanager
def serving(*arguments):
    """A server for the time of a test."""
    server = Server(*arguments)
    try:
        yield server
    finally:
        server.kill()


class Watch:
    """What a page asks for and what goes wrong on it."""

    def __init__(self, page):
        self.errors, self.requests = [], []
        page.on("console", lambda said: said.type == "error" and self.errors.append(said.text))
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.on("request", lambda request: self.requests.append(request.url))
        page.on("websocket", lambda socket: self.requests.append(socket.url))

    @property
    def outside(self):
        """Requests that left this machine."""
        own = ("http://127.0.0.1:", "ws://127.0.0.1:", "data:", "blob:http://127.0.0.1:")
        return [url for url in self.requests if not url.startswith(own)]


def words(page):
    """What the page says of the push."""
    return page.locator("h2").inner_text()


def ready(page):
    """Wait until the first picture, its map and its address are there."""
    page.wait_for_function(
        "document.querySelector('#areas path') && location.search.includes('slider.rod_length')"
        "&& document.querySelector('#scene .handle, #now path')"
    )


def on_screen(page, place, name="scene"):
    """Where a place of a picture is on the screen."""
    return page.evaluate(
        """([name, x, y]) => {
          const picture = document.getElementById(name)
          picture.scrollIntoView({block: "nearest"})
          const box = picture.getBoundingClientRect()
          const origin = picture.querySelector("[data-scale]").dataset
          return [box.x + +origin.x + x * origin.scale, box.y + +origin.y - y * origin.scale]
        }""",
        [name, *map(float, place)],
    )


def handle(page, name):
    """Place of a handle in the picture."""
    return page.evaluate(
        """(name) => {
          const origin = document.querySelector("#scene > g").dataset
          const at = document.querySelector(`#scene [data-handle="${name}"]`)
          return [(at.getAttribute("cx") - origin.x) / origin.scale,
                  (origin.y - at.getAttribute("cy")) / origin.scale]
        }""",
        name,
    )


def drag(page, start, end, steps=8):
    """Drag with the mouse from one place of the picture to another."""
    x, y = on_screen(page, start)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(*on_screen(page, end), steps=steps)
    page.mouse.up()


def settled(page):
    """Wait until a change has come to rest: until address and words stay as they are."""
    seen = []
    for _ in range(100):
        page.wait_for_timeout(150)
        seen.append((page.url, words(page)))
        if len(seen) > 7 and len(set(seen[-7:])) == 1:
            return
    raise TimeoutError("the page does not come to rest")
