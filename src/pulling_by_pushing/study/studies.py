"""Choice of a study, its name, and the folder of its results."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from planar_pushing.terms.errors import InvalidFile, InvalidValue, suggestion
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.catalog import NAME

#: The study of the paper: its file and its name. Its results are at the top of the results folder.
PAPER_FILE, PAPER = "workflow/config/paper.yaml", "paper"
#: The study of sliders, which is built together with it.
SLIDERS_FILE = "workflow/config/sliders.yaml"
#: The project's own studies, each with its file.
FILES = {PAPER: PAPER_FILE, "sliders": SLIDERS_FILE}
#: The keys of the workflow's configuration: the study's file, the folder of all results, and the folder of
#: published logs of pushes.
KEY, RESULTS, DATA = "study", "results", "data"
KEYS = (KEY, RESULTS, DATA)


def chosen_studies(config: Mapping[str, object]) -> tuple[str, ...]:
    """Study files that the workflow builds: the configured one, or both of our own for the paper's study.

    Errors as in `chosen_study`.
    """
    chosen = chosen_study(config)
    # The report of the paper's study also covers the study of sliders.
    return (chosen, SLIDERS_FILE) if _is_papers(chosen) else (chosen,)


def chosen_study(config: Mapping[str, object]) -> str:
    """Study file that the workflow's configuration selects, by default the paper's.

    Raises
    ------
    InvalidValue
        If the configuration has an unknown key or its study is not a path.
    """
    for key in config:
        if key not in KEYS:
            remedy = suggestion(key, KEYS, "leave it out")
            allowed = f"the keys {', '.join(KEYS[:-1])} and {KEYS[-1]}"
            raise InvalidValue("config", key, allowed, remedy)
    return _path(config, KEY, PAPER_FILE, "a study file")


def chosen_results(config: Mapping[str, object]) -> str:
    """Folder of all results that the workflow's configuration selects; errors as in `chosen_study`."""
    return _path(config, RESULTS, RESULTS, "a folder")


def chosen_data(config: Mapping[str, object]) -> str | None:
    """Folder of published logs that the configuration selects, if any; errors as in `chosen_study`."""
    return _path(config, DATA, "", "a folder") if DATA in config else None


def _path(config: Mapping[str, object], key: str, default: str, kind: str) -> str:
    """Path under a key of the configuration, without braces, which Snakemake reads as wildcards."""
    path = config.get(key, default)
    if not isinstance(path, str) or not path.isprintable() or set(path) & {"{", "}"} or not path:
        allowed = f"the path of {kind}, without braces"
        raise InvalidValue(key, path, allowed, "give another path")
    return path


def study_name(file: PathLike) -> str:
    """Name of a study for building, taken from its file.

    Raises
    ------
    InvalidFile
        If the name cannot be that of a folder, or is reserved for the paper's study.
    """
    name = file_name(file)
    if name == PAPER and not _is_papers(file):
        remedy = "go there to build it, or rename the file to build your own study"
        raise InvalidFile(
            f"{file}: {PAPER!r} names the paper's study, {PAPER_FILE} in the project's folder; {remedy}"
        )
    return name


def file_name(file: PathLike) -> str:
    """Name of a study from its file anywhere; raises `InvalidFile` if it cannot name a folder."""
    name = Path(file).stem
    if not NAME.fullmatch(name):
        allowed = "names of letters, digits and underscores, which become a folder's name"
        raise InvalidFile(f"{file}: {name!r} names the study; allowed: {allowed}; rename the file")
    return name


def _is_papers(file: PathLike) -> bool:
    return Path(file).resolve() == Path(PAPER_FILE).resolve()


def project_file(name: str) -> Path | None:
    """File of a study of the project, in the current folder or in the checkout that holds this package."""
    checkout = Path(__file__).parents[3]
    candidates = (folder / FILES[name] for folder in (Path(), checkout) if name in FILES)
    return next((file for file in candidates if file.is_file()), None)


def study_file(study: str, results: PathLike = RESULTS) -> Path:
    """File of a study that is given by its path, or by its name if it is one of the project's.

    Raises
    ------
    InvalidValue
        If a name is that of another study, whose file only the user knows, or of none.
    """
    path = Path(study)
    if path.is_file() or not NAME.fullmatch(study):
        return path
    if (file := project_file(study)) is not None:
        return file
    built = built_studies(results)
    remedy = suggestion(study, {*FILES, *built}, "give the path of its file")
    if study in built:
        remedy = f"give the file from which {study_folder(study, results)} was built"
    elif study in FILES:
        remedy = (
            f"go to the project's folder, which has {FILES[study]}, or give the path of its file"
        )
    allowed = f"the path of a study file, or of the project's studies the name {' or '.join(FILES)}"
    raise InvalidValue("study", study, allowed, remedy)


def built_studies(results: PathLike = RESULTS) -> list[str]:
    """Names of the studies other than the paper's in a results folder."""
    return sorted(path.name for path in (Path(results) / "studies").glob("*") if path.is_dir())


def study_folder(name: str | None, results: PathLike = "results") -> Path:
    """Folder of a study's results: the results folder itself for the paper's, otherwise one within it.

    Raises
    ------
    InvalidValue
        If the name cannot be that of a study.
    """
    if name is None or name == PAPER:
        return Path(results)
    if not isinstance(name, str) or not NAME.fullmatch(name):
        raise _unknown(name, results)
    return Path(results) / "studies" / name


def built_folder(name: str | None, results: PathLike = "results") -> Path:
    """Results folder of a study that was built.

    Raises
    ------
    InvalidValue
        If the results contain no such study.
    """
    folder = study_folder(name, results)
    if Path(results).is_dir() and not folder.is_dir():
        raise _unknown(name, results)
    return folder


def _unknown(name: object, results: PathLike) -> InvalidValue:
    """Error that lists the studies that were built."""
    names = [PAPER, *built_studies(results)]
    remedy = suggestion(name, names, "name a study that was built")
    return InvalidValue("study", name, ", ".join(names), remedy)
