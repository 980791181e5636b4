"""The command `solve`."""

from __future__ import annotations

import argparse
import math
from typing import TYPE_CHECKING, Any

from planar_pushing.commands import several
from planar_pushing.commands.words import (
    Commands,
    add_push,
    add_scene,
    command,
    missing_value,
    numbers,
    table,
)

if TYPE_CHECKING:
    from planar_pushing.mechanics.scene import Scene
    from planar_pushing.mechanics.solutions import Solutions

#: Columns of the table for a range of angles, by quantity of a solution.
COLUMNS = {
    "force": ("f_x", "f_y"),
    "contact_motion": ("u_x", "u_y"),
    "twist": ("v_x", "v_y", "omega"),
    "center": ("center_x", "center_y"),
    "force_end": ("f_end_x", "f_end_y"),
}
#: The forces at the ends of a side on the fence, and the columns of their normal components.
END_FORCES = {"force_at_start": "n_start", "force_at_end": "n_end"}


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Print all consistent solutions of a pushing problem, or a table for a range of angles."
    sub = command(commands, "solve", solutions, about, "scene.yaml --pusher-angle 165")
    add_scene(sub)
    add_push(sub, ranges=True)


def solutions(args: argparse.Namespace) -> dict[str, Any]:
    """Outcome and solutions of the scene under one motion of the pusher, or each of several."""
    from planar_pushing.scenes.contacts_files import load_any_file
    from planar_pushing.scenes.contacts_model import ContactsFile

    file, angles = load_any_file(args.scene), args.pusher_angle
    if isinstance(file, ContactsFile):
        return several.solutions(file, args)
    scene = file.build()
    if isinstance(angles, tuple):
        pushes = [push(scene, angle, args.pusher_magnitude) for angle in angles]
        return {"pushes": pushes} if args.json else {"": _table(pushes)}
    return push(scene, angles, args.pusher_magnitude)


def push(scene: Scene, degrees: float | None, magnitude: float | None) -> dict[str, Any]:
    """Solutions of one push, by default the push of the scene file."""
    import numpy as np

    from planar_pushing.mechanics.solve import solve
    from planar_pushing.terms.numbers import in_radians

    if degrees is None and scene.push is None:
        raise missing_value(
            "pusher_angle", "the option --pusher-angle, or a section simulate in the scene file",
            "type --pusher-angle 90 for a push into the slider",
        )  # fmt: skip
    angle, default = scene.push or (0.0, 1.0)
    if degrees is not None:
        angle, default = in_radians(degrees), 1.0
    magnitude = default if magnitude is None else magnitude
    result = solve(scene, angle, magnitude)
    return {
        "outcome": result.outcome.name,
        "status": result.status.name,
        "pusher_angle": float(np.rad2deg(angle)) if degrees is None else degrees,
        "pusher_magnitude": magnitude,
        "solutions": _solutions(result, _feet(scene)),
    }


def _feet(scene: Scene) -> tuple[str, ...]:
    """Names of the support points by number, if all friction acts on named points."""
    supports = [effect.support for effect in scene.friction]
    names = getattr(supports[0], "names", None) if len(supports) == 1 else None
    return names if names and len(set(supports[0].positions)) == len(names) else ()


def _solutions(result: Solutions, feet: tuple[str, ...]) -> list[dict[str, Any]]:
    """Solutions as plain values without rounding errors; a slider at rest has no center."""
    import numpy as np

    from planar_pushing.mechanics.solutions import printed_numbers

    listed = []
    for one, values in zip(result, printed_numbers(result), strict=True):
        ends = not np.array_equal(values["force"], values["force_end"])
        listed.append({
            "mode": one.mode.name,
            "force": numbers(values["force"]),
            **({"force_end": numbers(values["force_end"])} if ends else {}),
            "contact_motion": numbers(values["contact_motion"]),
            "twist": numbers(values["twist"]),
            "spin_ratio": float(values["spin_ratio"]),
            "center": None if np.isnan(values["center"]).any() else numbers(values["center"]),
            "pivot": None if one.pivot < 0 else one.pivot,
            **({"foot": feet[one.pivot]} if feet and one.pivot >= 0 else {}),
            "continuum": one.continuum,
            "adhesive": one.adhesive,
            **({} if one.end_forces is None else _on_side(one.flush, values)),
        })  # fmt: skip
    return listed


def _on_side(flush: bool, values: dict[str, Any]) -> dict[str, Any]:
    """Values of a solution of a side on the fence, with the upper bound of a force if it is another one."""
    position = float(values["force_position"])
    where = None if math.isnan(position) else position
    entries: dict[str, Any] = {"flush": flush, "force_position": where}
    for name, (low, high) in zip(END_FORCES, values["end_forces"], strict=True):
        entries[name] = numbers(low)
        if (low != high).any():
            entries[f"{name}_high"] = numbers(high)
    return entries


def _table(pushes: list[dict[str, Any]]) -> str:
    """Table with a line for each solution of each push, and one for a push without a solution."""
    return table([
        {"angle": f"{push['pusher_angle']:.10g}"} | _row(one)
        for push in pushes
        for one in push["solutions"] or [{"mode": push["outcome"]}]
    ])  # fmt: skip


def _row(one: dict[str, Any]) -> dict[str, Any]:
    """Columns of one solution."""
    row: dict[str, Any] = {"mode": one["mode"]}
    for name, columns in COLUMNS.items():
        values = one.get(name)
        words = ["none" if name == "center" and len(one) > 1 else None] * len(columns)
        row |= zip(columns, words if values is None else (f"{x:.6g}" for x in values), strict=True)
    continuum = "continuum" if one.get("continuum") else None
    pivot = one.get("foot", one.get("pivot"))
    row |= {"pivot": None if pivot is None else str(pivot), "continuum": continuum}
    position = one.get("force_position")
    row["flush"] = "flush" if one.get("flush") else None
    row["force_at"] = None if position is None else f"{position:.6g}"
    for name, column in END_FORCES.items():
        row[column] = f"{one[name][1]:.6g}" if name in one else None
    return row
