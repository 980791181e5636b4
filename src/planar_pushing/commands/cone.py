"""The command `cone`."""

from __future__ import annotations

import argparse
from typing import Any

from planar_pushing.commands.words import Commands, add_scene, command, numbers, with_unit


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Print the friction cone and the motion cone of a scene, in degrees."
    add_scene(command(commands, "cone", cones, about, "scene.yaml --json"))


def cones(args: argparse.Namespace) -> dict[str, Any]:
    """Edges of both cones of a scene, and quantities derived from them."""
    from planar_pushing.mechanics.force import cones as of_scene
    from planar_pushing.mechanics.scene import require_one_point
    from planar_pushing.scenes.files import load_scene

    remedy = "use planar-pushing solve, or give contact: {point: [x, y]} in the file"
    scene = require_one_point(load_scene(args.scene), "scene", remedy)
    motions = of_scene.motion_cone(scene)
    entries = {
        "friction_cone": numbers(of_scene.friction_cone(scene).degrees),
        "motion_cone": numbers(motions.degrees),
        "closed": motions.closed,
        "pulls": of_scene.can_pull(scene),
        "slips_while_pushing": of_scene.slips_while_pushing(scene),
    }
    return entries if args.json else _in_words(entries)


def _in_words(entries: dict[str, Any]) -> dict[str, Any]:
    """Entries with units, and with what it means that the cone is closed."""
    units = dict.fromkeys(("friction_cone", "motion_cone"), "degree")
    belong = "belong" if entries["closed"] else "do not belong"
    meaning = {"closed": f"{entries['closed']} (the edges {belong} to the motion cone)"}
    return {
        with_unit(name, units.get(name, "1")): meaning.get(name, value)
        for name, value in entries.items()
    }
