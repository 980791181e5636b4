"""The command `animate`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from planar_pushing.commands.words import Commands, add_output, command
from planar_pushing.terms.errors import InvalidFile

#: What to give instead of another file.
LOG = "give a log that planar-pushing simulate has written"


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Turn the log of a simulation into an animation."
    sub = command(commands, "animate", write_animation, about, "log.nc -o motion.gif --frames 50")
    sub.add_argument("log", type=Path, metavar="LOG.nc", help="log written by simulate")
    add_output(
        sub, "MOTION.gif", "output file; its name ends in .gif or, with the program ffmpeg, in .mp4"
    )
    sub.add_argument(
        "--frames", type=int, default=75, metavar="NUMBER",
        help="number of frames, evenly spaced in time, a whole number from 2 to 1000 (default: 75)",
    )  # fmt: skip
    sub.add_argument(
        "--frames-per-second", type=float, default=25.0, metavar="NUMBER",
        help="frames per second, a number in (0, 50] (default: 25)",
    )  # fmt: skip


def write_animation(args: argparse.Namespace) -> dict[str, Any]:
    """Draw the log as an animation in one file."""
    from planar_pushing.drawing.animate import animate
    from planar_pushing.drawing.timeline import path_data
    from planar_pushing.terms.netcdf import read_dataset

    if not args.log.exists():
        raise InvalidFile(f"{args.log}: no such file; {LOG}")
    log = read_dataset(args.log, remedy=LOG)
    try:
        path_data(log)
    except InvalidFile as error:
        raise InvalidFile(f"{args.log}: {error}") from None
    animation = animate(
        log, args.output, frames=args.frames, frames_per_second=args.frames_per_second
    )
    return {
        "written": str(args.output),
        "frames": animation.frames,
        "bytes": args.output.stat().st_size,
    }
