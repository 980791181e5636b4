"""Pictures are files: a backend that the environment names, and that is not there, is no hindrance."""

import os
import subprocess
import sys

import matplotlib as mpl
import pytest

from planar_pushing.drawing.canvas.style import paper_style

PROGRAM = """
import os
import planar_pushing.drawing.draw
import matplotlib
print(os.environ.get("MPLBACKEND"), matplotlib.rcParams._get_backend_or_none())
"""


@pytest.mark.parametrize(("named", "left"), [
    ("module://ipympl.backend_nbagg", "None None"),
    pytest.param("module://matplotlib_inline.backend_inline", None, marks=pytest.mark.slow),
    ("svg", "svg svg"),
])  # fmt: skip
def test_a_backend_that_is_not_there_is_forgotten(named, left):
    environment = os.environ | {"MPLBACKEND": named}
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert left in (None, done.stdout.strip())


@pytest.mark.slow
def test_a_command_draws_from_a_notebook(tmp_path):
    words = ["draw", "workflow/scenes/figure_03.yaml", "-o", str(tmp_path / "scene.svg")]
    environment = os.environ | {"MPLBACKEND": "module://ipympl.backend_nbagg"}
    subprocess.run(
        [sys.executable, "-m", "planar_pushing", *words], env=environment, check=True,
        capture_output=True,
    )  # fmt: skip
    assert (tmp_path / "scene.svg").stat().st_size > 1000


def test_the_interactive_mode_that_a_backend_turns_on_outlives_the_style():
    with mpl.rc_context():
        with paper_style():
            mpl.interactive(True)
        assert mpl.is_interactive()
