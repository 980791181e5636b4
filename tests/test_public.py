"""The library as its users see it: names, version, types, and what its documentation says of angles."""

import dataclasses
import inspect
import re
import subprocess
import sys
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

import planar_pushing as pp

#: Parameters that are angles, or hold one.
ANGLES = re.compile(r".*angle$|right|left|twist")


def _is_exception(public):
    return inspect.isclass(public) and issubclass(public, Exception)


def documented():
    """Public functions, classes, and the public methods of classes."""
    for name in pp.__all__:
        public = getattr(pp, name)
        if callable(public) and not _is_exception(public):
            yield name, public
        if inspect.isclass(public):
            for method, function in inspect.getmembers(public, inspect.isfunction):
                if not method.startswith("_"):
                    yield f"{name}.{method}", function


def described(document):
    """First line of the description of each parameter or attribute in a numpydoc text."""
    found = {}
    for names, line in re.findall(r"^(\w[\w, ]*) : .*\n    (.*)", document, re.MULTILINE):
        found |= dict.fromkeys(names.split(", "), line.lower())
    return found


def parameters_that_are_angles():
    return [
        pytest.param(function, parameter, id=f"{name}({parameter})")
        for name, function in documented()
        for parameter in inspect.signature(function).parameters
        if ANGLES.fullmatch(parameter)
    ]


@pytest.mark.parametrize(("function", "parameter"), parameters_that_are_angles())
def test_an_angle_says_radians_in_its_first_line(function, parameter):
    assert "radians" in described(inspect.getdoc(function))[parameter]


@pytest.mark.parametrize(("name", "said"), [
    ("motioncone", "; did you mean motion_cone?"), ("Solve", "; did you mean solve?"),
    ("numpy", "; dir(planar_pushing) lists the names"),
])  # fmt: skip
def test_a_mistyped_name_of_the_package_is_answered_by_a_similar_one(name, said):
    with pytest.raises(AttributeError) as caught:
        getattr(pp, name)
    assert str(caught.value) == f"planar_pushing has no attribute {name}{said}"
    assert not hasattr(pp, name)


def test_a_name_that_its_module_lacks_is_not_called_mistyped(monkeypatch):
    monkeypatch.delitem(vars(pp), "Coulomb", raising=False)  # set when the name was first used
    monkeypatch.delattr("planar_pushing.mechanics.contact.Coulomb")
    with pytest.raises(AttributeError, match=r"mechanics\.contact' has no attribute 'Coulomb'$"):
        _ = pp.Coulomb


def test_windows_is_refused_in_one_line():
    code = "import sys; sys.platform = 'win32'; import planar_pushing"
    ended = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False
    )
    said = "ImportError: planar-pushing does not run on Windows; use it on Linux or macOS"
    assert ended.stderr.splitlines()[-1] == said


def test_the_angles_are_found():
    names = {each.id for each in parameters_that_are_angles()}
    assert names > {
        "Slider(rod_angle)", "solve(pusher_angle)", "limit_curve(force_angle)", "simulate(twist)",
        "motion_angle(force_angle)", "simulate_batch(twist)", "AngleInterval.contains(angle)",
        "motion_centers(force_angle)", "spin_ratio(force_angle)", "AngleInterval(right)", "wrench(twist)",
    }  # fmt: skip


#: Types of the fields that hold arrays in a result.
ARRAYS = re.compile(r"(Array|Index|npt\.NDArray\[.*\])( \| None)?")


def results_with_arrays():
    """Public dataclasses that hold arrays, each with the names of the fields that do."""
    for name in pp.__all__:
        public = getattr(pp, name)
        if inspect.isclass(public) and dataclasses.is_dataclass(public):
            fields = [
                each for each in dataclasses.fields(public) if ARRAYS.fullmatch(str(each.type))
            ]
            if fields:
                yield pytest.param(public, [each.name for each in fields], id=name)


@pytest.mark.parametrize(("result", "arrays"), list(results_with_arrays()))
def test_results_with_arrays_are_equal_or_not_as_a_whole(result, arrays):
    def made(**changes):
        found = object.__new__(result)
        for each in dataclasses.fields(result):
            given = np.array([1.0, np.nan]) if each.name in arrays else 2.0
            object.__setattr__(found, each.name, changes.get(each.name, given))
        return found

    assert made() == made()
    for each in dataclasses.fields(result):
        for other in (np.array([1.0, 3.0]), np.array([1.0]), 3.0):
            assert made() != made(**{each.name: other}), each.name
    assert made() != "another value"


def test_the_results_with_arrays_are_found():
    found = {each.id for each in results_with_arrays()}
    assert found >= {"EllipsoidFit", "Push", "WrenchSet", "Solution", "SolutionArrays", "Touch"}


def test_version():
    assert pp.__version__ == version("planar-pushing")


def test_the_types_are_for_users_too():
    assert files("planar_pushing").joinpath("py.typed").is_file()


USE = """
import planar_pushing as pp
scene = pp.load_scene("scene.yaml")
reveal_type(pp.__version__)
reveal_type(pp.solve)
reveal_type(pp.ContactMode.STICK)
reveal_type(pp.AngleInterval(0.0, 1.0).degrees)
pp.Slider(rod_length=1.0)
"""


def test_a_type_checker_knows_the_public_names(tmp_path):
    (tmp_path / "use.py").write_text(USE, encoding="utf-8")
    ended = subprocess.run(
        [sys.executable, "-m", "mypy", str(tmp_path / "use.py")],
        cwd=Path(__file__).parents[1], capture_output=True, text=True, check=False,
    )  # fmt: skip
    said = ended.stdout
    assert 'Revealed type is "str"' in said
    assert "planar_pushing.mechanics.scene.Scene" in said
    assert 'Missing named argument "rod_angle" for "Slider"' in said
    assert "untyped" not in said
