"""The command line in this process, and results that it queries."""

import pytest

from planar_pushing.commands import main
from planar_pushing.study.build import build_dataset
from planar_pushing.study.slices import study_slice
from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.study.study_file import load_study


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


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    study = load_study("workflow/config/smoke.yaml")
    for name in ("motion_cones", "contact_modes"):
        built = build_dataset(name, study_slice(study, name))
        write_dataset(built, folder / f"data/{name}.nc")
    return str(folder)


@pytest.fixture(scope="session")
def log(tmp_path_factory):
    path = tmp_path_factory.mktemp("log") / "log.nc"
    assert main(["simulate", "workflow/scenes/figure_14a.yaml", "-o", str(path)]) == 0
    return path
