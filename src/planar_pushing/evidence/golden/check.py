"""Check a results folder: every value of every dataset by its rule, the golden sample by enclosures."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import xarray as xr
from tqdm import tqdm

from planar_pushing.evidence.golden import derived, expected
from planar_pushing.evidence.golden.by_rule import check_dataset
from planar_pushing.evidence.golden.compare import Check, compare
from planar_pushing.evidence.golden.expected import Expectation, Groups
from planar_pushing.evidence.golden.rules import Rule
from planar_pushing.evidence.golden.tolerances import load_tolerances
from planar_pushing.study.catalog import AXES, SIMULATIONS, SLIDERS
from planar_pushing.study.figures import ALL, FIGURES, GALLERY, computes, shows
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.study.files.sliders_model import SlidersFile, Study
from planar_pushing.study.files.study_model import FigureEntry, StudyFile
from planar_pushing.study.provenance import Marks, provenance
from planar_pushing.study.store import group_names, read_dataset
from planar_pushing.study.study_file import load_study
from planar_pushing.terms.errors import InvalidFile

#: Name of a file, and what gives the expectations of its groups.
Named = tuple[str, Callable[[], Groups]]


def golden_names(golden: Path) -> list[str]:
    """Names of the golden files in a folder.

    Raises
    ------
    InvalidFile
        Where the folder holds none: a check of nothing must not pass.
    """
    names = sorted(path.stem for path in golden.glob("*.nc"))
    if not names:
        raise InvalidFile(f"{golden}: holds no golden data; name the folder that does")
    return names


class Unreadable(Exception):
    """A file of the results that cannot be read; the message says why, in one line."""


class Results:
    """The files of a results folder, each read once.

    Parameters
    ----------
    folder : Path
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._read: dict[str, xr.Dataset | Unreadable] = {}

    def path(self, name: str) -> Path:
        """File of a figure, a simulation or a dataset."""
        if name in FIGURES or name in GALLERY:
            return self.folder / "figures" / "data" / f"{name}.nc"
        return self.folder / "data" / f"{name}.nc"

    def groups(self, name: str) -> list[str]:
        """Names of the groups of a file."""
        found: list[str] = _safely(lambda: group_names(self.path(name)))
        return found

    def dataset(self, name: str, group: str = "") -> xr.Dataset:
        """A dataset, or a group of one."""
        key = f"{name}/{group}" if group else name
        if key not in self._read:
            try:
                self._read[key] = _safely(
                    lambda: read_dataset(self.path(name), group or None).load()
                )
            except Unreadable as error:
                self._read[key] = error
        found = self._read[key]
        if isinstance(found, Unreadable):
            raise found
        return found


def _safely(read: Callable[[], Any]) -> Any:
    try:
        return read()
    # A damaged file makes the libraries fail in any way: each is a line of the verdict.
    except Exception as error:
        message = str(error).strip().splitlines() or [""]
        raise Unreadable(f"{type(error).__name__}: {message[0][:200]}") from None


def check_results(folder: Path, file: PathLike) -> list[Check]:
    """Check every value of a study's results.

    Parameters
    ----------
    folder : Path
        The results.
    file : path
        The study: it says what they are to hold, and names the folder of golden data and tolerances.

    Returns
    -------
    list of Check
        One for each variable and rule; a file that cannot be read is a check that fails.

    Raises
    ------
    InvalidFile
        Where the results or the golden data are no folders with files.
    """
    study, results = load_study(file), Results(folder)
    if not any(folder.glob("data/*.nc")):
        raise InvalidFile(f"{folder}: holds no datasets; build them with make or snakemake")
    checks, files = [], list(expectations(study, provenance(study, file), results))
    for name, groups in tqdm(files, "checking", disable=None, leave=False):
        checks += check_file(name, groups, results)
    return checks + (check_enclosures(results, study) if study.golden else [])


def expectations(study: Study, marks: Marks, results: Results) -> Iterator[Named]:
    """Name of every file of a study, and what gives the expectations of its groups.

    `marks` gives the attributes that name the study, as `provenance` does.
    """
    every = _of_sliders if isinstance(study, SlidersFile) else _of_paper
    for name, groups in every(study, results):
        yield name, partial(_in_study, name, groups, marks(name))


def _in_study(name: str, groups: Callable[[], Groups], marks: Mapping[str, str]) -> Groups:
    return expected.in_study(groups(), name.rpartition("/")[2], marks)


def _of_paper(study: Any, results: Results) -> Iterator[Named]:
    """Files of the paper's study and of those like it."""
    yield "scenes", partial(expected.scene_expectations, study)
    for name in (name for name in AXES if computes(study, name)):
        yield name, partial(_single, expected.grid_expectation, name, study)
    yield from _simulations(study)
    for name in (name for name in FIGURES if computes(study, name)):
        settings = study.figures.get(name, FigureEntry())
        yield name, partial(_figure, name, settings, results)
    if study.golden:
        yield from _costs(study)


def _of_sliders(study: Any, results: Results) -> Iterator[Named]:
    """Files of a study of sliders."""
    for name in SLIDERS:
        yield name, partial(_single, expected.grid_expectation, name, study)
    yield from _simulations(study)
    for name in (name for name in GALLERY if shows(study, name)):
        yield name, partial(_figure, name, study.slider, results)


def _simulations(study: Study) -> Iterator[Named]:
    for name in study.simulations:
        single = partial(_single, expected.simulation_expectation, name, study)
        yield f"{SIMULATIONS}/{name}", single


def _single(expectation: Callable[[str, Any], Expectation], name: str, study: Study) -> Groups:
    return {"": expectation(name, study)}


def _figure(name: str, settings: Any, results: Results) -> Groups:
    sources = {source: results.dataset(*_place(source)) for source in ALL[name].datasets}
    return _groups(derived.figure(name, settings, sources))


def _place(source: str) -> tuple[str, str]:
    """File and group of a dataset that a figure is drawn from."""
    stem, _, group = source.partition("/")
    return (stem, group) if stem == "scenes" else (source, "")


def _costs(study: StudyFile) -> Iterator[Named]:
    """Hard cases and costs, which are built with the study that the golden data certify."""
    yield "hard_cases", lambda: _groups(derived.hard_cases())
    yield "accuracy_errors", lambda: _groups(derived.accuracy_errors())
    yield "evaluations", lambda: _groups(derived.evaluations(study))


def _groups(built: xr.Dataset | dict[str, xr.Dataset]) -> Groups:
    every = {"": built} if isinstance(built, xr.Dataset) else built
    return {name: expected.derived_expectation(each) for name, each in every.items()}


def check_file(name: str, groups: Callable[[], Groups], results: Results) -> list[Check]:
    """Check every group of a file."""
    try:
        wanted = groups()
        found = results.groups(name)
    except Unreadable as error:
        return [Check(file=name, rule=Rule.EXACT, problem=f"cannot be read: {error}")]
    checks = [
        Check(file=f"{name}.{group}", rule=Rule.EXACT, problem="is no group of this dataset")
        for group in found
        if group not in wanted
    ]
    for group, expectation in wanted.items():
        label = f"{name}.{group}" if group else name.replace("/", ".")
        try:
            checks += check_dataset(label, results.dataset(name, group), expectation)
        except Unreadable as error:
            checks.append(Check(file=label, rule=Rule.EXACT, problem=f"cannot be read: {error}"))
    return checks


def check_enclosures(results: Results, study: Study) -> list[Check]:
    """Compare every golden file with what it certifies."""
    golden, checks = Path(study.golden or ""), []
    tolerances = load_tolerances(golden)
    for name in golden_names(golden):
        stem, _, group = name.partition(".")
        try:
            result = results.dataset(stem, group)
        except Unreadable as error:
            checks.append(Check(file=name, problem=f"cannot be compared: {error}"))
            continue
        checks += compare(name, result, read_dataset(golden / f"{name}.nc"), tolerances)
    return checks
