"""The command `draw`."""

from __future__ import annotations

import argparse
from typing import Any

from planar_pushing.commands.arguments import Commands, add_output, add_push, add_scene, command
from planar_pushing.study.files.models import PushEntry
from planar_pushing.study.files.scenes import load_scene_file
from planar_pushing.terms.errors import InvalidValue


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Draw a pushing problem and one of its solutions."
    sub = command(commands, "draw", drawn, about)
    add_scene(sub)
    add_push(sub, required=False)
    sub.add_argument("--force-angle", type=float, metavar="DEGREES")
    add_output(sub, "FILE.svg|pdf|png")


def drawn(args: argparse.Namespace) -> dict[str, Any]:
    """Draw the scene, pushed straight ahead where no angle is given."""
    from planar_pushing.figures.scene_picture import render_scene

    angles = args.pusher_angle, args.force_angle
    if None not in angles:
        raise InvalidValue("pusher_angle, force_angle", angles, "one of them", "leave one out")
    push = PushEntry(
        file=str(args.scene),
        pusher_angle=90.0 if angles == (None, None) else args.pusher_angle,
        force_angle=args.force_angle,
        pusher_magnitude=args.pusher_magnitude,
    )
    render_scene(load_scene_file(args.scene), push, args.output)
    return {"written": str(args.output)}
