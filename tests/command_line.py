"""Fixtures that call the command line in this process."""

import pytest

from planar_pushing.commands import main


@pytest.fixture
def run(capsys):
    """Run a command; its code, and what it printed to both streams."""

    def call(*arguments):
        code = main(list(arguments))
        said = capsys.readouterr()
        return code, said.out, said.err

    return call


@pytest.fixture
def refused(run):
    """Run a command that refuses its input: two exits with one line, which begins as `said`."""

    def call(arguments, said):
        code, out, err = run(*arguments)
        assert (code, out) == (2, "")
        assert err.startswith(f"planar-pushing {arguments[0]}: {said}"), err
        assert err.count("\n") == 1

    return call
