"""Arguments that several commands take."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

from planar_pushing.terms.errors import require_number, require_positive

#: What `add_subparsers` returns, for which argparse has no public name.
Commands = Any
#: What a command does with its arguments: it returns what is printed.
Action = Callable[[argparse.Namespace], dict[str, Any]]


def command(commands: Commands, name: str, action: Action, about: str) -> argparse.ArgumentParser:
    """Add a command, whose results are printed as text or as JSON."""
    sub: argparse.ArgumentParser = commands.add_parser(
        name, help=about, description=about, allow_abbrev=False
    )
    sub.set_defaults(action=action)
    sub.add_argument("--json", action="store_true", help="print JSON")
    return sub


def add_scene(sub: argparse.ArgumentParser) -> None:
    """Add the path of a scene file."""
    sub.add_argument("scene", type=Path, metavar="SCENE.yaml")


def add_output(sub: argparse.ArgumentParser, example: str) -> None:
    """Add the path of the file that is written."""
    sub.add_argument("-o", "--output", type=Path, required=True, metavar=example)


def add_push(sub: argparse.ArgumentParser, required: bool) -> None:
    """Add the fence's motion."""
    sub.add_argument("--pusher-angle", type=float, required=required, metavar="DEGREES")
    sub.add_argument("--pusher-magnitude", type=float, default=1.0, metavar="NUMBER")


def check_push(args: argparse.Namespace) -> None:
    """Refuse angles and magnitudes that the fence cannot have."""
    for name in ("pusher_angle", "force_angle"):
        given = getattr(args, name, None)
        if given is not None:
            allowed = "a finite number of degrees"
            require_number(name, given, math.isfinite, allowed, "give one angle")
    magnitude = getattr(args, "pusher_magnitude", 1.0)
    require_positive("pusher_magnitude", magnitude, "turn the pusher around by its angle")
