"""The command `draw`."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from planar_pushing.commands import several
from planar_pushing.commands.words import (
    Commands,
    add_output,
    add_push,
    add_scene,
    command,
)
from planar_pushing.terms.errors import InvalidValue

if TYPE_CHECKING:
    from planar_pushing.mechanics.scene import Scene
    from planar_pushing.scenes.scene_model import SceneFile


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Draw a pushing problem and one of its solutions, the sticking one if it exists."
    sub = command(commands, "draw", draw_scene, about, "scene.yaml --pusher-angle 170 -o scene.svg")
    add_scene(sub)
    add_push(sub, ranges=False)
    sub.add_argument(
        "--force-angle", type=float, metavar="DEGREES",
        help="direction of the contact force, instead of --pusher-angle; the fence then follows the "
        "resulting motion; degrees counterclockwise from the fence, within the friction cone; for scenes "
        "with one effect",
    )  # fmt: skip
    sub.add_argument(
        "--limit-curve", action="store_true",
        help="also show the limit curve around the contact, with a thicker line where the slider pivots; "
        "for scenes with one effect",
    )  # fmt: skip
    add_output(sub, "FILE.svg|pdf|png", "output picture; its name ends in .svg, .pdf or .png")


def draw_scene(args: argparse.Namespace) -> dict[str, Any]:
    """Draw the scene under the given push, the push of its file, or a push straight ahead."""
    from planar_pushing.drawing.canvas.style import save_drawn
    from planar_pushing.drawing.draw import SCENE, draw_on
    from planar_pushing.drawing.files import surroundings
    from planar_pushing.drawing.sketch import Sketch, with_curve
    from planar_pushing.scenes.contacts_files import load_any_file
    from planar_pushing.scenes.contacts_model import ContactsFile
    from planar_pushing.terms.numbers import in_radians

    angles = args.pusher_angle, args.force_angle
    if None not in angles:
        raise InvalidValue("pusher_angle, force_angle", angles, "one of them", "leave one out")
    file = load_any_file(args.scene)
    if isinstance(file, ContactsFile):
        return several.draw(file, args)
    scene = file.build()
    if args.force_angle is not None:
        _require_force(scene, args.force_angle)
    angle, magnitude = _push(args, file, scene)
    sketch = Sketch.of(scene, float(in_radians(angle)), magnitude, **surroundings(file, scene))
    if args.limit_curve:
        sketch = with_curve(sketch, scene)
    save_drawn(lambda figure: draw_on(figure, sketch), SCENE, [args.output])
    return {"written": str(args.output)}


def _push(args: argparse.Namespace, file: SceneFile, scene: Scene) -> tuple[float, float]:
    """Angle in degrees and magnitude of the push."""
    from planar_pushing.mechanics.force.cones import angle_under_force

    piece = file.pieces[0] if file.simulate else None
    angle = args.pusher_angle
    if args.force_angle is not None:
        angle = angle_under_force(scene, args.force_angle)
    elif angle is None:
        angle = piece.angle if piece else 90.0
    # The file gives a velocity, but a scene with inertia is pushed from rest by an acceleration.
    speed = piece.speed if piece and piece.speed and not scene.stores_energy else 1.0
    magnitude = args.pusher_magnitude or speed
    return float(angle), float(magnitude)


def _require_force(scene: Scene, angle: float) -> None:
    """Reject a force that is not a solution for any push."""
    from planar_pushing.mechanics.force.cones import friction_cone, is_magnitude_open
    from planar_pushing.terms.numbers import in_radians

    if is_magnitude_open(scene):
        raise InvalidValue(
            "force_angle", angle, "a scene with one effect: with friction and inertia the force also "
            "depends on the magnitude of the push", "give --pusher-angle and --pusher-magnitude",
        )  # fmt: skip
    cone = friction_cone(scene)
    if in_radians(angle) not in cone:
        right, left = cone.degrees
        ends = "[]" if cone.closed else "()"
        allowed = f"degrees in the friction cone, {ends[0]}{right:.10g}, {left:.10g}{ends[1]}"
        raise InvalidValue("force_angle", angle, allowed, "give a force that the contact transmits")
