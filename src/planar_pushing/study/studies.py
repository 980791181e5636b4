"""Studies side by side: which one is chosen, its name, and the folder that its results fill."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from pathlib import Path

from planar_pushing.study.catalog import NAME
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.terms.errors import InvalidFile, InvalidValue

#: The study of the paper: its file, and its name, whose results are not in a folder of their own.
PAPER_FILE, PAPER = "workflow/config/paper.yaml", "paper"
#: The study of sliders that is built beside it.
SLIDERS_FILE = "workflow/config/sliders.yaml"
#: The one key of the workflow's configuration.
KEY = "study"


def chosen_studies(config: Mapping[str, object]) -> tuple[str, ...]:
    """Files of the studies that the workflow builds: the one that its configuration chooses, or ours both.

    Errors as in `chosen_study`.
    """
    chosen = chosen_study(config)
    # The report of the paper's study shows that of sliders as well.
    paper = Path(chosen).resolve() == Path(PAPER_FILE).resolve()
    return (chosen, SLIDERS_FILE) if paper else (chosen,)


def chosen_study(config: Mapping[str, object]) -> str:
    """File of the study that the workflow's configuration chooses, the paper's where it says nothing.

    Raises
    ------
    InvalidValue
        Where the configuration has another key, or no path as study.
    """
    for key in config:
        if key != KEY:
            near = difflib.get_close_matches(str(key), [KEY], n=1)
            remedy = f"did you mean {KEY}?" if near else "leave it out"
            raise InvalidValue("config", key, f"the key {KEY}", remedy)
    file = config.get(KEY, PAPER_FILE)
    if not isinstance(file, str) or not file.isprintable() or set(file) & {"{", "}"} or not file:
        allowed = "the path of a study file, without braces"
        raise InvalidValue(KEY, file, allowed, f"give it as --config {KEY}=PATH")
    return file


def study_name(file: PathLike) -> str:
    """Name of a study, that of its file.

    Raises
    ------
    InvalidFile
        Where it cannot name a folder, or is the name of the paper's study.
    """
    name = Path(file).stem
    if not NAME.fullmatch(name):
        allowed = "names of letters, digits and underscores, which become a folder's name"
        raise InvalidFile(f"{file}: {name!r} names the study; allowed: {allowed}; rename the file")
    if name == PAPER and Path(file).resolve() != Path(PAPER_FILE).resolve():
        raise InvalidFile(f"{file}: {PAPER!r} is the paper's own study; rename the file")
    return name


def study_folder(name: str | None, results: PathLike = "results") -> Path:
    """Folder that a study's results fill: that of all results for the paper's, else one within it.

    Raises
    ------
    InvalidValue
        Where the name cannot be one of a study.
    """
    if name is None or name == PAPER:
        return Path(results)
    if not isinstance(name, str) or not NAME.fullmatch(name):
        raise _unknown(name, results)
    return Path(results) / "studies" / name


def built_folder(name: str | None, results: PathLike = "results") -> Path:
    """Folder of results of a study that was built.

    Raises
    ------
    InvalidValue
        Where the results hold no such study.
    """
    folder = study_folder(name, results)
    if Path(results).is_dir() and not folder.is_dir():
        raise _unknown(name, results)
    return folder


def _unknown(name: object, results: PathLike) -> InvalidValue:
    """The error that lists the studies that were built."""
    built = sorted(path.name for path in (Path(results) / "studies").glob("*"))
    allowed = ", ".join([PAPER, *built])
    return InvalidValue("study", name, allowed, "name a study that was built")
