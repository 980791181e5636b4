"""The command `simulate`."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Any

from planar_pushing.commands import several
from planar_pushing.commands.words import (
    DIRECTION,
    PUSHER_ANGLE,
    Commands,
    add_output,
    add_scene,
    command,
    missing_value,
    with_unit,
)
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import SAMPLES, SPEED, TOLERANCE, Method, Policy, Shape

if TYPE_CHECKING:
    import xarray as xr
    from pydantic import ValidationError

    from planar_pushing.scenes.scene_model import SceneFile
    from planar_pushing.scenes.simulate_model import SimulateEntry

ENDINGS = (".nc", ".h5")
#: Options that override the section simulate of the scene file: type, placeholder and help.
OPTIONS: dict[str, tuple[type, str, str]] = {
    "pusher-angle": (
        float, "DEGREES",
        f"direction of the fence's velocity, {DIRECTION} (default: the scene file's motion)",
    ),
    "pusher-speed": (
        float, "NUMBER",
        f"speed of the fence, in the scene's units of length per time, {SPEED.allowed} (default: the scene "
        "file's, or 1)",
    ),
    "pusher-shape": (
        str, "NAME",
        f"{' or '.join(Shape)}: a line that touches a point of the slider, or a point or a disc that "
        f"touches a flat side of it (default: the scene file's, or {Shape.FENCE})",
    ),
    "pusher-radius": (
        float, "NUMBER",
        "radius of the finger, in the scene's unit of length, a finite number >= 0; 0 is a point "
        "(default: the scene file's, or 0)",
    ),
    "duration": (
        float, "NUMBER",
        "simulated time, in the unit of time of the speed, > 0 (default: the scene file's)",
    ),
    "rtol": (
        float, "NUMBER",
        f"relative tolerance of the event-driven method, {TOLERANCE.allowed} (default: the scene file's, "
        "or 1e-10)",
    ),
    "step": (
        float, "NUMBER",
        "maximum step of the time-stepping method, in the unit of the duration, > 0 (default: the scene "
        "file's, or 1/1000 of the duration)",
    ),
    "samples": (
        int, "NUMBER",
        f"number of evenly spaced instants in the log, {SAMPLES.allowed}; events are also logged "
        "(default: the scene file's, or 101)",
    ),
    "method": (
        str, "NAME",
        f"{' or '.join(Method)}: integration from event to event within the tolerance, or equal "
        f"first-order steps (default: the scene file's, or {Method.EVENT_DRIVEN})",
    ),
    "on-ambiguity": (
        str, "NAME",
        f"{', '.join(Policy)}: which contact mode is chosen if several are consistent "
        f"(default: the scene file's, or {Policy.KEEP_CONTACT})",
    ),
}  # fmt: skip


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Simulate a scene over time and write the log."
    example = "scene.yaml --pusher-angle 165 --duration 3 -o log.nc"
    sub = command(commands, "simulate", simulate_scene, about, example)
    add_scene(sub)
    add_output(
        sub, "LOG.nc",
        f"output log; its name ends in {' or '.join(ENDINGS)}; an older log of this name is replaced at "
        "the start, and an interrupted run leaves its log up to that time",
    )  # fmt: skip
    sub.number_option = PUSHER_ANGLE
    for name, (kind, metavar, about) in OPTIONS.items():
        sub.add_argument(f"--{name}", type=kind, metavar=metavar, help=about)
    sub.add_argument(
        "--progress", action=argparse.BooleanOptionalAction, default=sys.stderr.isatty(),
        help="show a progress bar (default: on a terminal only)",
    )  # fmt: skip


def simulate_scene(args: argparse.Namespace) -> dict[str, Any]:
    """Simulate the scene, and return a summary of the motion."""
    from planar_pushing.scenes.contacts_files import load_any_file
    from planar_pushing.scenes.contacts_model import ContactsFile
    from planar_pushing.scenes.simulate import simulate_file

    if args.output.suffix.lower() not in ENDINGS:
        allowed = f"a name ending in {' or '.join(ENDINGS)}"
        raise InvalidValue("output", str(args.output), allowed, "rename the file")
    file = load_any_file(args.scene)
    if isinstance(file, ContactsFile):
        return several.simulate(file, args, tuple(name.replace("-", "_") for name in OPTIONS))
    file = file.model_copy(update={"simulate": _section(file, args)})
    with simulate_file(file, path=args.output, progress=args.progress) as log:
        entries = {"written": str(args.output)} | summary(log)
        return entries if args.json else _in_words(entries, log)


def _section(file: SceneFile, args: argparse.Namespace) -> SimulateEntry:
    """Section simulate of the file, with values overridden by the options."""
    from pydantic import ValidationError

    from planar_pushing.scenes.simulate_model import SimulateEntry

    names = (name.replace("-", "_") for name in OPTIONS)
    options = {name: getattr(args, name) for name in names}
    section: dict[str, Any] = file.simulate.model_dump(exclude_none=True) if file.simulate else {}
    if options["pusher_shape"] == Shape.FENCE:
        section.pop("pusher_radius", None)
    if options["pusher_angle"] is not None:
        for other in ("pusher", "waypoints"):
            section.pop(other, None)
    section |= {name: value for name, value in options.items() if value is not None}
    _require_motion(section, args)
    try:
        return SimulateEntry.model_validate(section)
    except ValidationError as error:
        raise _invalid(error, section) from None


def _require_motion(section: dict[str, Any], args: argparse.Namespace) -> None:
    """Refuse a simulation without a motion of the pusher or a duration, and say what to type."""
    motions = {"pusher_angle", "pusher", "waypoints"}
    example = {"pusher_angle": 165, "duration": 3}
    names = [
        name for name in example if not (motions if name in motions else {name}) & set(section)
    ]
    if names:
        options = " ".join(f"--{name.replace('_', '-')} {example[name]}" for name in names)
        keys = ", ".join(f"{name}: {example[name]}" for name in names)
        raise missing_value(
            ", ".join(names), f"as options, or in a section simulate of {args.scene}",
            f"type for example {options}, or write simulate: {{{keys}}} into the file",
        )  # fmt: skip


def _invalid(error: ValidationError, section: dict[str, Any]) -> InvalidValue:
    """First of the errors, named after its option."""
    first = error.errors()[0]
    context = first.get("ctx", {})
    name = str(first["loc"][0]) if first["loc"] else str(context["name"])
    allowed, remedy = str(context.get("expected", first["msg"])), context.get("remedy")
    return InvalidValue(name, section.get(name), allowed, remedy or "change the value")


def _in_words(entries: dict[str, Any], log: xr.Dataset) -> dict[str, Any]:
    """Entries with units, and with the sentence on an early stop, if any, in place of its reason."""
    from planar_pushing.terms.quantities import stop_text

    stop = stop_text(log)
    replaced = {"": stop} if stop else {}
    first = {name: entries[name] for name in ("written", "time")}
    others = {name: value for name, value in entries.items() if name not in ("stopped", *first)}
    others["modes"] = [_with_units(change, log) for change in entries["modes"]]
    return _with_units(first, log) | replaced | _with_units(others, log)


def _with_units(entries: dict[str, Any], log: xr.Dataset) -> dict[str, Any]:
    """Entries whose names have the units of the log's variables."""
    from planar_pushing.terms.quantities import unit_of

    units = {name: unit_of(log[name].attrs) for name in entries if name in log}
    return {with_unit(name, units.get(name, "1")): value for name, value in entries.items()}


def summary(log: xr.Dataset) -> dict[str, Any]:
    """Summary of a simulation: its final state and the sequence of modes."""
    last = log.isel(time=-1)
    where = {"contact_position": float, "flush": bool, "parted": bool}
    return {
        "time": float(last["time"]),
        "stopped": log.attrs["stopped"],
        "rod_angle": float(last["rod_angle"]),
        "position": [float(coordinate) for coordinate in last["position"]],
        "slip": float(last["slip"]),
        "gap": float(last["gap"]),
        **{name: kind(last[name]) for name, kind in where.items() if name in log},
        "modes": _changes(log),
    }


def _changes(log: xr.Dataset) -> list[dict[str, Any]]:
    """Mode, number of consistent solutions, and whether a side is flush, where one of them changed."""
    import numpy as np

    from planar_pushing.mechanics.contact import ContactMode

    modes, counts = log["mode"].values.astype(int), log["solutions"].values
    changed = (np.diff(modes) != 0) | (np.diff(counts) != 0)
    flush = log["flush"].values if "flush" in log else None
    if flush is not None:
        changed |= np.diff(flush)
    rows = np.flatnonzero(np.concatenate([[True], changed]))
    names = {-1: "NONE"} | {int(mode): mode.name for mode in ContactMode}
    return [
        {
            "time": float(log["time"][row]),
            "mode": names[int(modes[row])],
            "consistent": int(counts[row]),
            **({} if flush is None else {"flush": bool(flush[row])}),
        }
        for row in rows
    ]
