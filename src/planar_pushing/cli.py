"""The command line, in the words of the Python interface."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.commands import motion
from planar_pushing.mechanics.cones import can_pull, friction_cone, motion_cone, slips_while_pushing
from planar_pushing.mechanics.errors import (
    InvalidValue,
    PlanarPushingError,
    require_number,
    require_positive,
)
from planar_pushing.mechanics.solve import solve
from planar_pushing.study.catalog import DATASETS
from planar_pushing.study.describe import plain
from planar_pushing.study.files import load_scene, load_scene_file
from planar_pushing.study.models import PushEntry
from planar_pushing.study.query import select
from planar_pushing.study.store import open_dataset


def _numbers(values: Any) -> list[float]:
    return [float(value) + 0.0 for value in np.atleast_1d(values)]


def _solve(args: argparse.Namespace) -> dict[str, Any]:
    scene = load_scene(args.scene)
    found = solve(scene, np.deg2rad(args.pusher_angle), args.pusher_magnitude)
    return {
        "outcome": found.outcome.name,
        "solutions": [
            {
                "mode": each.mode.name,
                "force": _numbers(each.force),
                "contact_motion": _numbers(each.contact_motion),
                "twist": _numbers(each.twist),
                "spin_ratio": each.spin_ratio,
                "center": _numbers(each.center),
                "adhesive": each.adhesive,
            }
            for each in found
        ],
    }


def _cone(args: argparse.Namespace) -> dict[str, Any]:
    scene = load_scene(args.scene)
    forces, motions = friction_cone(scene), motion_cone(scene)
    return {
        "friction_cone": _numbers(np.rad2deg([forces.right, forces.left])),
        "motion_cone": _numbers(np.rad2deg([motions.right, motions.left])),
        "closed": motions.closed,
        "pulls": can_pull(scene),
        "slips_while_pushing": slips_while_pushing(scene),
    }


def _pairs(words: Sequence[str]) -> dict[str, str]:
    """Axis names and values from ``--axis-name value`` or ``--axis-name=value``."""
    split = (word.split("=", 1) if word.startswith("--") else [word] for word in words)
    parts = [part for pair in split for part in pair]
    names = [part[2:].replace("-", "_") for part in parts[::2] if part.startswith("--")]
    if 2 * len(names) != len(parts) or len(set(names)) < len(names):
        raise InvalidValue(
            "query",
            " ".join(words),
            "pairs such as --rod-length 2, each axis once",
            "name an axis, then its value",
        )
    return dict(zip(names, parts[1::2], strict=True))


def _query(args: argparse.Namespace) -> dict[str, Any]:
    found = select(open_dataset(args.dataset, args.results), _pairs(args.where))
    if args.json:
        return dict(found.to_dict())
    return {"": _table(found)}


def _table(found: xr.Dataset) -> str:
    """Chosen values in one line, then single values in lines, and a table for each set of axes."""
    marks = {}
    for name, variable in found.variables.items():
        unit = variable.attrs.get("units", "1")
        marks[name] = str(name) if unit == "1" else f"{name} [{unit}]"
    chosen = [name for name, coord in found.coords.items() if not coord.ndim]
    rest = found.drop_vars(chosen)
    singles = [name for name, variable in rest.data_vars.items() if not variable.ndim]
    width = max((len(marks[name]) for name in singles), default=0)
    blocks = [", ".join(f"{name}={found[name].item()}" for name in chosen)] if chosen else []
    if singles:
        blocks.append("\n".join(f"{marks[n]:<{width}}  {rest[n].item()}" for n in singles))
    for dims in dict.fromkeys(
        variable.dims for variable in rest.data_vars.values() if variable.ndim
    ):
        names = [name for name, variable in rest.data_vars.items() if variable.dims == dims]
        frame = rest[names].to_dataframe()[names]
        frame.columns = [marks[name] for name in names]
        blocks.append(frame.to_string(max_rows=40))
    return "\n".join(blocks)


def _draw(args: argparse.Namespace) -> dict[str, Any]:
    from planar_pushing.figures.scene_picture import render_scene

    angles = args.pusher_angle, args.force_angle
    if angles == (None, None):
        args.pusher_angle = 90.0
    elif None not in angles:
        raise InvalidValue("pusher_angle, force_angle", angles, "one of them", "leave one out")
    push = PushEntry(
        file=str(args.scene),
        pusher_angle=args.pusher_angle,
        force_angle=args.force_angle,
        pusher_magnitude=args.pusher_magnitude,
    )
    render_scene(load_scene_file(args.scene), push, args.output)
    return {"written": str(args.output)}


def _text(value: Any, indent: int = 0) -> str:
    """Readable lines of nested results."""
    if isinstance(value, list) and value and isinstance(value[0], dict):
        blocks = (
            f"{' ' * indent}{i}:\n{_text(each, indent + 2)}" for i, each in enumerate(value, 1)
        )
        return "\n".join(blocks)
    if not isinstance(value, dict):
        return " ".join(
            f"{v:.12g}" if isinstance(v, float) else str(v) for v in np.atleast_1d(value)
        )
    lines = []
    for key, each in value.items():
        nested = isinstance(each, list) and each and isinstance(each[0], dict)
        lines.append(
            f"{' ' * indent}{key}:\n{_text(each, indent + 2)}" if nested
            else f"{' ' * indent}{key}: {_text(each)}" if key else str(each)
        )  # fmt: skip
    return "\n".join(lines)


def _check_push(args: argparse.Namespace) -> None:
    """Refuse angles and magnitudes that are no motion of the fence."""
    for name in ("pusher_angle", "force_angle"):
        if getattr(args, name, None) is not None:
            given = getattr(args, name)
            require_number(name, given, np.isfinite, "a finite number of degrees", "give one angle")
    magnitude = getattr(args, "pusher_magnitude", 1.0)
    require_positive("pusher_magnitude", magnitude, "turn the pusher around by its angle")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="planar-pushing", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True, metavar="command")

    def command(name: str, action: Any, text: str) -> argparse.ArgumentParser:
        sub = commands.add_parser(name, help=text, description=text, allow_abbrev=False)
        sub.set_defaults(action=action)
        sub.add_argument("--json", action="store_true", help="print JSON")
        return sub

    def scene(sub: argparse.ArgumentParser) -> None:
        sub.add_argument("scene", type=Path, metavar="SCENE.yaml")

    def push(sub: argparse.ArgumentParser, required: bool) -> None:
        sub.add_argument("--pusher-angle", type=float, required=required, metavar="DEGREES")
        sub.add_argument("--pusher-magnitude", type=float, default=1.0, metavar="NUMBER")

    solving = command("solve", _solve, "Print every consistent solution of a pushing problem.")
    scene(solving)
    push(solving, required=True)
    scene(command("cone", _cone, "Print the friction cone and the motion cone, in degrees."))
    query = command("query", _query, "Print a part of a dataset: --axis-name value picks a value.")
    query.usage = "planar-pushing query DATASET [--AXIS VALUE ...] [--results FOLDER] [--json]"
    query.add_argument("dataset", metavar="DATASET", help=", ".join(DATASETS))
    query.add_argument(
        "--results", type=Path, default=Path("results"), help="folder of the results"
    )
    drawing = command("draw", _draw, "Draw a pushing problem and one of its solutions.")
    scene(drawing)
    push(drawing, required=False)
    drawing.add_argument("--force-angle", type=float, metavar="DEGREES")
    drawing.add_argument("-o", "--output", type=Path, required=True, metavar="FILE.svg|pdf|png")
    motion.add_commands(command)
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; 0, or 2 with one message where the input is wrong."""
    parser = _parser()
    args, rest = parser.parse_known_args(arguments)
    if rest and args.command != "query":
        parser.error(f"unrecognized arguments: {' '.join(rest)}")
    args.where = rest
    try:
        _check_push(args)
        result = args.action(args)
    except PlanarPushingError as error:
        print(f"planar-pushing {args.command}: {error}", file=sys.stderr)
        return 2
    print(json.dumps(plain(result), indent=2) if args.json else _text(result))
    return 0


if __name__ == "__main__":
    sys.exit(main())
