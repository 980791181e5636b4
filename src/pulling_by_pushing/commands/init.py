"""The command `init`."""

from __future__ import annotations

import argparse
import shlex
from importlib.resources import files
from pathlib import Path
from typing import Any

from planar_pushing.commands.words import Commands, command
from planar_pushing.terms.errors import InvalidFile, MissingExtra
from planar_pushing.terms.extras import pip_install, require_extra

#: The template files, in planar_pushing/study/templates.
STUDY, SCENE = "my_study.yaml", "scene.yaml"


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Write a small study and a scene with comments as a starting point."
    sub = command(commands, "init", start, about, "my_folder")
    sub.add_argument(
        "folder",
        type=Path,
        metavar="FOLDER",
        help="output folder; created if it does not exist",
    )


def start(args: argparse.Namespace) -> dict[str, Any]:
    """Write the files, or none if one of them already exists."""
    from planar_pushing.terms.replacing import replacing

    folder = args.folder.resolve()
    for path in (folder / STUDY, folder / SCENE):
        if path.exists():
            raise InvalidFile(f"{path}: already exists; choose another folder")
    for name in (STUDY, SCENE):
        text = (files("pulling_by_pushing.study") / "templates" / name).read_text(encoding="utf-8")
        with replacing(folder / name) as temporary:
            temporary.write_text(text, encoding="utf-8")
    written = {"study": str(folder / STUDY), "scene": str(folder / SCENE)}
    return written | _next(shlex.join(["planar-pushing", "run", str(args.folder / STUDY)]))


def _next(build: str) -> dict[str, str]:
    """How to build the study, which needs extras that may not be installed."""
    try:
        for extra in ("workflow", "figures"):
            require_extra(extra)
    except MissingExtra:
        install = f"{pip_install('workflow,figures')} in the project's folder"
        return {"to build it": f"{install}, then {build}"}
    return {"to build it": build}
