"""The command `cone`."""

from __future__ import annotations

import argparse
from typing import Any

from planar_pushing.commands.words import Commands, add_scene, command, numbers


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Print the friction cone and the motion cone of a scene, in degrees."
    add_scene(command(commands, "cone", cones, about, "scene.yaml --json"))


def cones(args: argparse.Namespace) -> dict[str, Any]:
    """Edges of both cones of a scene, and quantities derived from them."""
    from planar_pushing.mechanics.force import cones as found
    from planar_pushing.scenes.files import load_scene

    scene = load_scene(args.scene)
    motions = found.motion_cone(scene)
    return {
        "friction_cone": numbers(found.friction_cone(scene).degrees),
        "motion_cone": numbers(motions.degrees),
        "closed": motions.closed,
        "pulls": found.can_pull(scene),
        "slips_while_pushing": found.slips_while_pushing(scene),
    }
