"""The command `convert`."""

from __future__ import annotations

import argparse
import math
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Any

from planar_pushing.commands.words import (
    OUTLINE,
    Commands,
    add_output,
    command,
    missing_value,
    read_outline,
    require_ending,
)
from planar_pushing.terms.errors import InvalidFile, InvalidValue, require_number, suggestion

if TYPE_CHECKING:
    import xarray as xr

#: Formats of measured pushes: name and help.
FORMATS = {
    "csv": "your own table with a row for each push and the columns x_before, y_before, angle_before, "
    "x_after, y_after, angle_after (poses of the object), x_start, y_start, x_end, y_end (center of the "
    "finger) and, if measured, x_force, y_force (mean force), all in the world frame; needs --outline",
    "three-feet": "logs of a triangle on three feet, named after the positions of the feet",
    "mit": "MATLAB files of pushed polygons and ellipses, named after the shape",
}
ENDINGS = (".nc", ".h5")
#: The options of tables, with the values that stand for an option that is left out.
TABLE: dict[str, Any] = {
    "outline": None, "finger_radius": None, "angles": None, "units": None, "noise": None, "object": None,
    "tolerance": None, "skip_missed": False,
}  # fmt: skip


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = (
        "Convert files of measured pushes to one dataset, for identify and compare. The options other than "
        "--output are for tables in the format csv."
    )
    sub = command(
        commands,
        "convert",
        convert,
        about,
        "csv box.csv --outline box.yaml --finger-radius 5 -o pushes.nc",
    )
    sub.words = tuple(FORMATS)
    sub.values = {"--angles": ("degrees", "radians")}
    formats = "; ".join(f"{name}: {content}" for name, content in FORMATS.items())
    sub.add_argument("format", type=_format, metavar="FORMAT", help=formats)
    sub.add_argument("files", type=Path, nargs="+", metavar="FILE", help="files of this format")
    add_output(sub, "PUSHES.nc", f"output dataset; its name ends in {' or '.join(ENDINGS)}")
    sub.add_argument("--outline", type=Path, metavar="OUTLINE.yaml", help=OUTLINE)
    sub.add_argument(
        "--finger-radius", type=float, metavar="NUMBER",
        help="radius of the finger, in the table's unit of length, a finite number >= 0 (default: 0, for a "
        "point)",
    )  # fmt: skip
    sub.add_argument(
        "--angles", metavar="UNIT", help="degrees or radians: unit of the angles (default: degrees)"
    )
    sub.add_argument(
        "--units", nargs=2, metavar=("LENGTH", "FORCE"),
        help="names of the table's units of length and force (default: mm N)",
    )  # fmt: skip
    sub.add_argument(
        "--noise", nargs=3, type=float, metavar=("LENGTH", "DEGREES", "FORCE"),
        help="standard deviations of positions, angles and forces, in the table's units and in degrees, "
        "each a finite number >= 0 (default: unknown)",
    )  # fmt: skip
    sub.add_argument(
        "--object", metavar="NAME",
        help="name of the object that all files push (default: each file is an object of the file's name)",
    )  # fmt: skip
    sub.add_argument(
        "--tolerance", type=float, metavar="NUMBER",
        help="largest overlap of finger and object at the start of a push that is taken for noise, in the "
        "table's unit of length, a finite number >= 0 (default: 2 percent of the object's size)",
    )  # fmt: skip
    sub.add_argument(
        "--skip-missed", action="store_true",
        help="leave out pushes that do not touch the object or begin deep in it",
    )  # fmt: skip


def _format(word: str) -> str:
    """Name of a format; a file in its place probably lacks one."""
    if word in FORMATS:
        return word
    # Reading pushes takes a second to import.
    from planar_pushing.pushes.files import FORMATS as FORMATS_BY_ENDING

    kind = FORMATS_BY_ENDING.get(Path(word).suffix.lower())
    remedy = suggestion(word, FORMATS, "name one of these formats")
    if kind:
        remedy = f"type planar-pushing convert {kind} {shlex.quote(word)}"
    raise argparse.ArgumentTypeError(f"{word!r} given; allowed: {', '.join(FORMATS)}; {remedy}")


def convert(args: argparse.Namespace) -> dict[str, Any]:
    """Read the files, write the dataset, and report how many pushes it holds."""
    require_ending(args.output, ENDINGS)
    pushes = _table(args) if args.format == "csv" else _logs(args)
    from planar_pushing.pushes.files import save_pushes

    save_pushes(pushes, args.output)
    return {
        "written": str(args.output),
        "pushes": pushes.sizes["push"],
        "objects": [str(name) for name in pushes["object"].values],
        "left_out": int(pushes.attrs.get("left_out", 0)),
    }


def _logs(args: argparse.Namespace) -> xr.Dataset:
    """Pushes in published logs, which take no options."""
    for name, absent in TABLE.items():
        if (value := getattr(args, name)) != absent:
            written = str(value) if isinstance(value, Path) else value
            raise InvalidValue(
                name, written, "this option with the format csv only", "leave it out"
            )
    from planar_pushing.pushes.formats.mit import read_mit
    from planar_pushing.pushes.formats.three_feet import read_three_feet

    return {"three-feet": read_three_feet, "mit": read_mit}[args.format](*args.files)


def _table(args: argparse.Namespace) -> xr.Dataset:
    """Pushes in tables."""
    if args.outline is None:
        raise missing_value(
            "outline",
            OUTLINE,
            "write for example [[0, 0], [80, 0], [80, 50]] to a file, and give --outline",
        )
    for sigma in args.noise or ():
        allowed = "three finite numbers >= 0"
        require_number("noise", sigma, lambda x: 0.0 <= x < math.inf, allowed, "give 0 for none")
    from planar_pushing.mechanics.outline import require_outline
    from planar_pushing.pushes.formats.table import read_table

    try:
        outline = require_outline(read_outline(args.outline))
    except InvalidValue as error:
        raise InvalidFile(f"{args.outline}: {error}") from None
    names = ("finger_radius", "angles", "units", "noise", "tolerance", "skip_missed")
    options = {name: getattr(args, name) for name in names if getattr(args, name) is not None}
    return read_table(*args.files, outline=outline, name=args.object, **options)
