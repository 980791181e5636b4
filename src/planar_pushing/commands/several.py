"""The commands `solve`, `draw` and `simulate` for a scene file with several contacts."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from planar_pushing.commands.words import naming_file, numbers, table, with_unit
from planar_pushing.terms.errors import InvalidValue

if TYPE_CHECKING:
    import xarray as xr

    from planar_pushing.objects.several.solutions import ContactsSolution, ContactsSolutions
    from planar_pushing.scenes.contacts_model import ContactsFile

#: Options of a simulation that a section with several pushers has, too.
SHARED = ("duration", "rtol", "step", "samples", "on_ambiguity")
#: Remedies for options that are of one pusher only.
REMEDIES = {
    "method": "leave it out; --step takes steps of this length",
    "force_angle": "leave it out: the velocities determine the forces",
    "limit_curve": "leave it out: each contact has its own",
}


def refuse_options(args: argparse.Namespace, names: tuple[str, ...]) -> None:
    """Refuse options of one pusher together with a file of several contacts."""
    for name in names:
        value = getattr(args, name)
        if value is not None and value is not False:
            remedy = REMEDIES.get(name, "write the motion into contacts or simulate.pushers")
            raise InvalidValue(name, value, "none with contacts in the scene file", remedy)


def solutions(file: ContactsFile, args: argparse.Namespace) -> dict[str, Any]:
    """Outcome and solutions of a file with several contacts."""
    from planar_pushing.objects.several.solve_contacts import solve_contacts

    refuse_options(args, ("pusher_angle", "pusher_magnitude"))
    with naming_file(args.scene):
        answer: ContactsSolutions = solve_contacts(**file.build())
    entries: dict[str, Any] = {"outcome": answer.outcome.name, "status": answer.status.name}
    if answer.reason is not None:
        entries["reason"] = answer.reason.name
    listed = [_solution(solution) for solution in answer]
    if args.json:
        return entries | {"solutions": listed}
    return entries | {"solutions": [_in_words(solution) for solution in listed]}


def _solution(solution: ContactsSolution) -> dict[str, Any]:
    """A solution as plain values; of each contact the force, or both ends of its range."""
    import numpy as np

    has_range = bool(np.any(solution.forces != solution.forces_end))
    contacts = [
        {
            "mode": mode.name,
            "force": _round_vector(solution.forces, k),
            **({"force_end": _round_vector(solution.forces_end, k)} if has_range else {}),
            "contact_motion": _round_vector(solution.contact_motions, k),
            "gap_rate": float(solution.gap_rates[k]) + 0.0,
        }
        for k, mode in enumerate(solution.modes)
    ]
    v_x, v_y, omega = numbers(solution.twist)
    return {
        "twist": [v_x, v_y, omega],
        "center": [-v_y / omega + 0.0, v_x / omega + 0.0] if omega else None,
        **({"inner_force": numbers(solution.inner_force)} if has_range else {}),
        "condition": solution.condition,
        "pivot": None if solution.pivot < 0 else solution.pivot,
        "continuum": solution.continuum,
        "contacts": contacts,
    }


def _round_vector(vectors: Any, number: int) -> list[float]:
    """One of several vectors, with 0 for components that are rounding errors beside the largest."""
    import numpy as np

    from planar_pushing.mechanics.solutions import ROUNDING

    size = np.abs(vectors[np.isfinite(vectors)]).max(initial=0.0)
    vector = vectors[number]
    return numbers(np.where(np.abs(vector) <= ROUNDING * size, 0.0, vector))


def _in_words(solution: dict[str, Any]) -> dict[str, Any]:
    """A solution with its contacts as the lines of a table."""
    columns = {
        "force": ("f_x", "f_y"),
        "force_end": ("f_end_x", "f_end_y"),
        "contact_motion": ("u_x", "u_y"),
    }
    rows = []
    for number, contact in enumerate(solution["contacts"], 1):
        row: dict[str, str | None] = {"contact": str(number), "mode": contact["mode"]}
        for name, names in columns.items():
            for column, value in zip(names, contact.get(name, ()), strict=False):
                row[column] = f"{value:.6g}"
        row["gap_rate"] = f"{contact['gap_rate']:.6g}"
        rows.append(row)
    lines = table(rows).replace("\n", "\n      ")
    others = {name: value for name, value in solution.items() if name != "contacts"}
    return others | {"": f"    contacts:\n      {lines}"}


def draw(file: ContactsFile, args: argparse.Namespace) -> dict[str, Any]:
    """Draw the contacts of a file."""
    from planar_pushing.drawing.canvas.style import save_drawn
    from planar_pushing.drawing.draw import SCENE, draw_contacts_on
    from planar_pushing.drawing.files import contacts_picture

    refuse_options(args, ("pusher_angle", "pusher_magnitude", "force_angle", "limit_curve"))
    with naming_file(args.scene):
        sketch = contacts_picture(file)
    unit = "" if file.units is None else file.units.length
    save_drawn(lambda figure: draw_contacts_on(figure, sketch, unit), SCENE, [args.output])
    return {"written": str(args.output)}


def simulate(
    file: ContactsFile, args: argparse.Namespace, options: tuple[str, ...]
) -> dict[str, Any]:
    """Simulate the contacts of a file, write the log, and return a summary of the motion."""
    from pydantic import ValidationError

    from planar_pushing.scenes.contacts_model import SimulateContactsEntry
    from planar_pushing.scenes.simulate import simulate_contacts_file

    refuse_options(args, tuple(name for name in options if name not in SHARED))
    if file.simulate is not None:
        section = file.simulate.model_dump(exclude_none=True)
        given = {name: getattr(args, name) for name in SHARED if getattr(args, name) is not None}
        try:
            changed = SimulateContactsEntry.model_validate(section | given)
        except ValidationError as error:
            raise _invalid(error, given) from None
        file = file.model_copy(update={"simulate": changed})
    with naming_file(args.scene):
        log = simulate_contacts_file(file, args.output)
    entries = {"written": str(args.output)} | _summary(log)
    return entries if args.json else _with_units(entries, log)


def _invalid(error: Any, given: dict[str, Any]) -> InvalidValue:
    """The first error, named after its option."""
    first = error.errors()[0]
    context = first.get("ctx", {})
    name = str(first["loc"][0]) if first["loc"] else str(context["name"])
    allowed, remedy = str(context.get("allowed", first["msg"])), context.get("remedy")
    return InvalidValue(name, given.get(name), allowed, remedy or "change the value")


def _summary(log: xr.Dataset) -> dict[str, Any]:
    """The final state, and the modes of all contacts whenever one of them changed."""
    import numpy as np

    from planar_pushing.mechanics.contact import ContactMode

    last, modes = log.isel(time=-1), log["mode"].values.astype(int)
    changed = np.flatnonzero([True, *(np.diff(modes, axis=0) != 0).any(axis=1)])
    names = {-1: "NONE"} | {int(mode): mode.name for mode in ContactMode}
    return {
        "time": float(last["time"]),
        "stopped": log.attrs["stopped"],
        "object_position": numbers(last["object_position"]),
        "object_angle": float(last["object_angle"]) + 0.0,
        "contact": [str(name) for name in log["contact"].values],
        "slip": numbers(last["slip"]),
        "gap": numbers(last["gap"]),
        "modes": [
            {
                "time": float(log["time"][row]),
                "mode": [names[mode] for mode in modes[row].tolist()],
                "consistent": int(log["solutions"][row]),
            }
            for row in changed
        ],
    }


def _with_units(entries: dict[str, Any], log: xr.Dataset) -> dict[str, Any]:
    """Entries with units, and the sentence on an early stop in place of its reason."""
    from planar_pushing.terms.quantities import stop_text, unit_of

    units = {name: unit_of(log[name].attrs) for name in entries if name in log}
    worded = {with_unit(name, units.get(name, "1")): value for name, value in entries.items()}
    stop = stop_text(log)
    modes = worded.pop("modes")
    del worded["stopped"]
    time = with_unit("time", unit_of(log["time"].attrs))
    return (
        worded
        | ({"": stop} if stop else {})
        | {
            "modes": [
                {time: row["time"], **{k: v for k, v in row.items() if k != "time"}}
                for row in modes
            ]
        }
    )
