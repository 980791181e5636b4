"""The command `draw`."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from planar_pushing.commands.words.arguments import (
    Commands,
    add_output,
    add_push,
    add_scene,
    command,
)
from planar_pushing.terms.errors import InvalidValue

if TYPE_CHECKING:
    from planar_pushing.mechanics.scene import Scene


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Draw a pushing problem and one of its solutions, the one that sticks if there is one."
    sub = command(commands, "draw", drawn, about, "scene.yaml --pusher-angle 170 -o scene.svg")
    add_scene(sub)
    add_push(sub, required=False)
    sub.add_argument(
        "--force-angle", type=float, metavar="DEGREES",
        help="instead of --pusher-angle: direction of the force, whose motion the fence then follows; "
        "degrees counter-clockwise from the fence, within the friction cone; for scenes with one effect",
    )  # fmt: skip
    sub.add_argument(
        "--limit-curve", action="store_true",
        help="show the limit curve around the contact too, heavier where the slider pivots; "
        "for scenes with one effect",
    )  # fmt: skip
    add_output(sub, "FILE.svg|pdf|png", "picture to write; its name ends in .svg, .pdf or .png")


def drawn(args: argparse.Namespace) -> dict[str, Any]:
    """Draw the scene, pushed straight ahead where no angle is given."""
    from planar_pushing.figures.scene_picture import render_curve, render_scene
    from planar_pushing.study.files.scenes import load_scene_file
    from planar_pushing.study.files.study_model import PushEntry

    angles = args.pusher_angle, args.force_angle
    if None not in angles:
        raise InvalidValue("pusher_angle, force_angle", angles, "one of them", "leave one out")
    file = load_scene_file(args.scene)
    if args.force_angle is not None:
        _require_force(file.build(), args.force_angle)
    push = PushEntry(
        file=str(args.scene),
        pusher_angle=90.0 if angles == (None, None) else args.pusher_angle,
        force_angle=args.force_angle,
        pusher_magnitude=args.pusher_magnitude,
    )
    render = render_curve if args.limit_curve else render_scene
    render(file, push, args.output)
    return {"written": str(args.output)}


def _require_force(scene: Scene, angle: float) -> None:
    """Refuse a force that no push of the fence has for its solution."""
    from math import radians

    from planar_pushing.mechanics.cones import friction_cone, is_magnitude_open

    if is_magnitude_open(scene):
        raise InvalidValue(
            "force_angle", angle, "a scene with one effect: with friction and inertia the force depends "
            "on the fence's magnitude too", "give --pusher-angle and --pusher-magnitude",
        )  # fmt: skip
    cone = friction_cone(scene)
    if radians(angle) not in cone:
        right, left = cone.degrees
        ends = "[]" if cone.closed else "()"
        allowed = f"degrees in the friction cone, {ends[0]}{right:.10g}, {left:.10g}{ends[1]}"
        raise InvalidValue("force_angle", angle, allowed, "give a force that the contact transmits")
