"""The command `solve`."""

from __future__ import annotations

import argparse
from math import radians
from typing import Any

from planar_pushing.commands.words.arguments import Commands, add_push, add_scene, command
from planar_pushing.commands.words.text import numbers


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Print every consistent solution of a pushing problem."
    sub = command(commands, "solve", solutions, about, "scene.yaml --pusher-angle 165")
    add_scene(sub)
    add_push(sub, required=True)


def solutions(args: argparse.Namespace) -> dict[str, Any]:
    """Outcome and solutions of the scene under the fence's motion."""
    from planar_pushing.mechanics.solve import solve
    from planar_pushing.study.files.scenes import load_scene

    found = solve(load_scene(args.scene), radians(args.pusher_angle), args.pusher_magnitude)
    return {
        "outcome": found.outcome.name,
        "solutions": [
            {
                "mode": each.mode.name,
                "force": numbers(each.force),
                "contact_motion": numbers(each.contact_motion),
                "twist": numbers(each.twist),
                "spin_ratio": each.spin_ratio,
                "center": numbers(each.center),
                "adhesive": each.adhesive,
            }
            for each in found
        ],
    }
