"""The command `convert`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from planar_pushing.commands.words import Commands, add_output, command
from planar_pushing.terms.errors import InvalidValue, suggestion

#: Formats of measured pushes: name and help.
FORMATS = {
    "three-feet": "logs of a triangle on three feet, named after the positions of the feet",
    "mit": "MATLAB files of pushed polygons, named after the shape",
}
ENDINGS = (".nc", ".h5")


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Convert files of measured pushes to one dataset."
    sub = command(
        commands, "convert", converted, about, "three-feet 30_90_30_30_30_90.txt -o pushes.nc"
    )
    sub.words = tuple(FORMATS)
    listed = "; ".join(f"{name}: {each}" for name, each in FORMATS.items())
    sub.add_argument("format", metavar="FORMAT", help=listed)
    sub.add_argument("files", type=Path, nargs="+", metavar="FILE", help="files of this format")
    add_output(sub, "PUSHES.nc", f"output dataset; its name ends in {' or '.join(ENDINGS)}")


def converted(args: argparse.Namespace) -> dict[str, Any]:
    """Read the files, write the dataset, and report how many pushes it holds."""
    if args.format not in FORMATS:
        remedy = suggestion(args.format, FORMATS, "name one of these formats")
        raise InvalidValue("format", args.format, ", ".join(FORMATS), remedy)
    if args.output.suffix.lower() not in ENDINGS:
        allowed = f"a name ending in {' or '.join(ENDINGS)}"
        raise InvalidValue("output", str(args.output), allowed, "rename the file")
    from planar_pushing.pushes.files import save_pushes
    from planar_pushing.pushes.logs.mit import read_mit
    from planar_pushing.pushes.logs.three_feet import read_three_feet

    reader = {"three-feet": read_three_feet, "mit": read_mit}[args.format]
    pushes = reader(*args.files)
    save_pushes(pushes, args.output)
    return {
        "written": str(args.output),
        "pushes": pushes.sizes["push"],
        "objects": [str(each) for each in pushes["object"].values],
        "left_out": int(pushes.attrs["left_out"]),
    }
