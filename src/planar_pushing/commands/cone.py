"""The command `cone`."""

from __future__ import annotations

import argparse
from typing import Any

import numpy as np

from planar_pushing.commands.arguments import Commands, add_scene, command
from planar_pushing.commands.text import numbers
from planar_pushing.study.files.scenes import load_scene


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Print the friction cone and the motion cone, in degrees."
    add_scene(command(commands, "cone", cones, about))


def cones(args: argparse.Namespace) -> dict[str, Any]:
    """Edges of both cones of a scene, and what follows from them."""
    from planar_pushing.mechanics.cones import (
        can_pull,
        friction_cone,
        motion_cone,
        slips_while_pushing,
    )

    scene = load_scene(args.scene)
    forces, motions = friction_cone(scene), motion_cone(scene)
    return {
        "friction_cone": numbers(np.rad2deg([forces.right, forces.left])),
        "motion_cone": numbers(np.rad2deg([motions.right, motions.left])),
        "closed": motions.closed,
        "pulls": can_pull(scene),
        "slips_while_pushing": slips_while_pushing(scene),
    }
