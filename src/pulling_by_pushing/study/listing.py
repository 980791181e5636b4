"""The datasets in a results folder, and the commands that build the others."""

from __future__ import annotations

from pathlib import Path

from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.netcdf import group_names, read_attributes
from planar_pushing.terms.replacing import PathLike
from pulling_by_pushing.study.catalog import FOLDERS, WHOLE, building, opened
from pulling_by_pushing.study.store import built_results


def built_datasets(results: PathLike, study: str | None = None) -> dict[str, str]:
    """Names that `open_dataset` accepts for the results of a study, and their titles.

    Errors as in `open_dataset`; for a damaged file, the error message replaces the title.
    """
    folder = built_results(results, study)
    found: dict[str, str] = {}
    for stem in WHOLE:
        found |= _named(folder / f"data/{stem}.nc", stem)
    for stem, place in FOLDERS.items():
        for path in sorted((folder / place).glob("*.nc")):
            found |= _named(path, f"{stem}/{path.stem}")
    return found


def _named(path: Path, name: str) -> dict[str, str]:
    """Title of a file by its name or those of its groups; empty if the file does not exist."""
    if not path.is_file():
        return {}
    try:
        title = str(read_attributes(path).get("title", ""))
        names = [f"{name}/{group}" for group in group_names(path)] or [name]
    except InvalidFile as error:
        return {name: str(error)}
    return dict.fromkeys(names, title[:1].lower() + title[1:])


def other_datasets(built: dict[str, str]) -> dict[str, str]:
    """Names of datasets that are not built, and the command for each; NAME is a placeholder."""
    stems = {name.partition("/")[0] for name in built}
    return {
        name: building(name)
        for name in opened()
        if name not in built and not (name.endswith("/NAME") and name[:-5] in stems)
    }
