"""The command line, in the words of the Python interface."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence

from planar_pushing.commands import animate, compilation, cone, draw, init, query, simulate, solve
from planar_pushing.commands.arguments import check_push
from planar_pushing.commands.text import text
from planar_pushing.mechanics.entries import plain
from planar_pushing.terms.errors import PlanarPushingError

COMMANDS = (solve, cone, query, draw, simulate, animate, init, compilation)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="planar-pushing", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True, metavar="command")
    for command in COMMANDS:
        command.add(commands)
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; 0, or 2 with one message where the input is wrong."""
    parser = _parser()
    args, rest = parser.parse_known_args(arguments)
    if rest and args.command != "query":
        parser.error(f"unrecognized arguments: {' '.join(rest)}")
    args.where = rest
    try:
        check_push(args)
        result = args.action(args)
    except PlanarPushingError as error:
        print(f"planar-pushing {args.command}: {error}", file=sys.stderr)
        return 2
    print(json.dumps(plain(result), indent=2) if args.json else text(result))
    return 0
