"""The command `schema`: the JSON schema of a kind of file, for editors."""

from __future__ import annotations

import argparse
import json
from importlib.metadata import entry_points
from typing import Any

from planar_pushing.commands.words import Commands, command
from planar_pushing.terms.errors import require_name

#: Group of the entry points of other packages' kinds of files, each a model of the content.
GROUP = "planar_pushing.schemas"
SCENE = "scene"
#: Effects that can leave out their support.
RESTING = ("SupportFriction", "Viscous")


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    kinds = (SCENE, *sorted(entry.name for entry in entry_points(group=GROUP)))
    about = "Print the JSON schema of a kind of file, with which an editor completes and checks its keys."
    sub = command(commands, "schema", schema, about, "scene > scene.schema.json")
    sub.add_argument("kind", metavar="KIND", help=" or ".join(kinds))
    sub.words = kinds


def schema(args: argparse.Namespace) -> dict[str, Any]:
    """Schema of a kind of file."""
    from pydantic import TypeAdapter

    from planar_pushing.scenes.contacts_model import ContactsFile
    from planar_pushing.scenes.object_model import ObjectFile
    from planar_pushing.scenes.scene_model import SceneFile

    models = {entry.name: entry for entry in entry_points(group=GROUP)}
    require_name("kind", args.kind, (SCENE, *models), "name one of these kinds of files")
    # A scene file is in the body frame, or in the frame of an object with one contact or several.
    model: Any = (
        SceneFile | ObjectFile | ContactsFile if args.kind == SCENE else models[args.kind].load()
    )
    content = TypeAdapter(model).json_schema()
    if args.kind == SCENE:
        for name in RESTING:  # the support can be that of the object
            content["$defs"][name]["required"].remove("support")
    return content if args.json else {"": json.dumps(content, indent=2)}
