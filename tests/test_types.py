"""Types in a user's script: mypy --strict knows the results, and refuses wrong options and attributes."""

import re
import subprocess
import sys
from pathlib import Path

FOLDER = Path(__file__).parent


def checked(script):
    """The kind of each message of mypy about a script, and its text, by the number of the line.

    The project's cache of mypy, which `make lint` has filled, spares it the reading of the library.
    """
    ended = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--hide-error-context", script],
        cwd=FOLDER.parent, capture_output=True, text=True, check=False,
    )  # fmt: skip
    lines = re.findall(rf"{script.name}:(\d+): (error|note): (.*)", ended.stdout)
    assert lines or ended.returncode == 0, ended.stdout + ended.stderr
    return [(int(number), kind, text) for number, kind, text in lines]


def comments(script):
    """The comments behind code, by the number of the line."""
    lines = enumerate(script.read_text(encoding="utf-8").splitlines(), 1)
    return {number: line.split("  # ")[1] for number, line in lines if "  # " in line}


def plain(text):
    """A revealed type without the modules of its names; arrays of floats are `Array`."""
    found = re.fullmatch(r'Revealed type is "(.*)"', text)
    short = re.sub(r"\b(?:\w+\.)+(\w+)", r"\1", found[1]) if found else text
    return short.replace("ndarray[tuple[Any, ...], dtype[float64]]", "Array")


def test_the_types_of_results():
    script = FOLDER / "typed_right.py"
    found = checked(script)
    assert [each for each in found if each[1] == "error"] == []
    assert {number: plain(text) for number, _, text in found} == comments(script)


def test_each_wrong_line_is_refused():
    script = FOLDER / "typed_wrong.py"
    found = {
        number: text.rsplit("[", 1)[-1].rstrip("]")
        for number, kind, text in checked(script)
        if kind == "error"
    }
    assert found == comments(script)
