"""The command line as a whole."""

import subprocess
import sys

import pytest

from planar_pushing.commands import main

SCENE = "workflow/scenes/figure_03.yaml"


def test_unknown_option(capsys):
    with pytest.raises(SystemExit) as caught:
        main(["cone", SCENE, "--rod-length", "2"])
    assert caught.value.code == 2
    assert "unrecognized arguments: --rod-length 2" in capsys.readouterr().err


def test_installed_command():
    done = subprocess.run(
        [sys.executable, "-m", "planar_pushing.commands", "--help"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert "solve" in done.stdout
