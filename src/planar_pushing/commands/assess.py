"""The command `assess`."""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from planar_pushing.commands.words import Commands, add_scene, command, naming_file, require_ending
from planar_pushing.terms.errors import InvalidValue, require_name, require_number

if TYPE_CHECKING:
    import xarray as xr

    from planar_pushing.assessment.result import PushAssessment

ENDINGS = (".nc", ".h5")


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = (
        "Assess the push of a scene file: which effects it calls for, which method is cheapest, and how "
        "sure the answer is. The change of a pose is the largest displacement over the object's outline."
    )
    sub = command(commands, "assess", assess_scene, about, "scene.yaml --tolerance 0.001")
    add_scene(sub)
    sub.add_argument(
        "--tolerance", type=float, metavar="NUMBER",
        help="largest change of the pose that does not matter, in the scene's unit of length, > 0 "
        "(default: a hundredth of the object's diagonal)",
    )  # fmt: skip
    sub.add_argument(
        "--candidate", nargs="+", metavar="NAME",
        help="effects of the list candidates in the section simulate that are tried besides those of the "
        "scene (default: all of the list)",
    )  # fmt: skip
    sub.add_argument(
        "-o", "--output", type=Path, metavar="ASSESSMENT.nc",
        help="output file with the groups effects, methods and inputs; its name ends in "
        f"{' or '.join(ENDINGS)} (default: none)",
    )  # fmt: skip


def assess_scene(args: argparse.Namespace) -> dict[str, Any]:
    """Assess the push, write the file if requested, and report the table."""
    if args.output is not None:
        require_ending(args.output, ENDINGS)
    if args.tolerance is not None:
        allowed = "a finite number > 0"
        require_number(
            "tolerance", args.tolerance, lambda x: 0 < x < math.inf, allowed, "give a length"
        )
    from planar_pushing.assessment.assess_push import assess_push
    from planar_pushing.scenes.files import load_scene_file
    from planar_pushing.scenes.simulate import assessed_push

    file = load_scene_file(args.scene)
    with naming_file(args.scene):
        push = assessed_push(file)
    for name in args.candidate or ():
        remedy = "list it under candidates in the section simulate"
        if not push.candidates:
            raise InvalidValue("candidate", name, "none, as the file lists no candidates", remedy)
        require_name("candidate", name, push.candidates, remedy)
    names = args.candidate or push.candidates
    assessment = assess_push(
        push.scene, push.pusher, duration=push.duration, tolerance=args.tolerance,
        candidates=[push.candidates[name] for name in names],
    )  # fmt: skip
    written = {}
    if args.output is not None:
        assessment.to_netcdf(args.output)
        written = {"written": str(args.output)}
    return written | (summary(assessment) if args.json else {"": assessment.table()})


def summary(assessment: PushAssessment) -> dict[str, Any]:
    """The numbers of an assessment."""
    needed = assessment.effects["needed"].values
    return {
        "tolerance": assessment.tolerance,
        "needed": [str(name) for name in assessment.effects["effect"].values[needed]],
        "settings": assessment.settings,
        "effects": _rows(assessment.effects, "effect"),
        "methods": _rows(assessment.methods, "setting"),
        "inputs": _rows(assessment.inputs, "input"),
        "warnings": list(assessment.warnings),
    }


def _rows(data: xr.Dataset, dim: str) -> list[dict[str, Any]]:
    """The variables of a dataset at each place of a dimension."""
    rows = []
    for i in range(data.sizes[dim]):
        row = data.isel({dim: i})
        label = {dim: str(row[dim].item())} if dim in row.coords else {}
        rows.append(label | {str(name): variable.values.tolist() for name, variable in row.items()})
    return rows
