"""Scenes with several contacts on the page: a picture, a table and files; their fields are fixed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from planar_pushing.drawing.canvas.colors import MODES
from planar_pushing.drawing.canvas.svg import to_svg
from planar_pushing.drawing.contacts import ContactsPicture
from planar_pushing.drawing.files import contacts_picture
from planar_pushing.explorer.pictures.pictures import chip
from planar_pushing.explorer.python_lines import code, outline_code
from planar_pushing.explorer.state import State, state_of
from planar_pushing.mechanics.entries import scene_entry
from planar_pushing.mechanics.plane import Frame
from planar_pushing.objects.scene_at import place_object
from planar_pushing.objects.several.solutions import ContactsSolution
from planar_pushing.scenes.contacts_files import save_contacts_file
from planar_pushing.scenes.contacts_model import ContactsFile
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.scenes.simulate import simulate_contacts_file
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.terms.netcdf import write_dataset

#: What the page says of the fields.
FIXED = (
    "A scene with several contacts: all fields are fixed, and show contact 1 alone; change the scene file, "
    "or start from another scene"
)
#: Columns of the table of contacts.
HEAD = ("Contact", "Mode", "Force", "Other end of its range", "Motion", "Gap opens at")


def open_state(file: SceneFile | ContactsFile) -> State:
    """Initial state of a scene file; that of several contacts has the fields of the first one."""
    if isinstance(file, SceneFile):
        return state_of(file)
    problem = file.build()
    first = problem["contacts"][0]
    scene, _ = place_object(
        first.point, first.normal, first.side, problem["effects"], first.law, problem["outline"],
        None if file.units is None else file.units.build(),
    )  # fmt: skip
    angle, speed = 90.0, 1.0
    if first.velocity is not None and any(first.velocity) and scene.placement is not None:
        fence: Frame = scene.placement.fence
        x, y = fence.vector_in(first.velocity).tolist()
        angle, speed = float(np.rad2deg(np.arctan2(y, x))), float(np.hypot(x, y))
    alone = SceneFile.model_validate(scene_entry(scene, file.title))
    return replace(state_of(alone, angle, speed), several=file)


@lru_cache(maxsize=4)
def sketch(file: ContactsFile) -> ContactsPicture:
    """The picture of the first solution."""
    return contacts_picture(file)


def table(picture: ContactsPicture) -> str:
    """Table of all solutions, with a line for each contact; the first solution is drawn."""
    if not len(picture.answer):
        return "<p>No consistent solution.</p>"
    head = "".join(f"<th>{name}</th>" for name in HEAD)
    rows = ""
    for number, solution in enumerate(picture.answer):
        emphasis = ' class="shown"' if number == 0 else ""
        twist = escape(f"Solution {number + 1}: twist ({_words(solution.twist)})")
        rows += f'<tr{emphasis}><th colspan="{len(HEAD)}">{twist}</th></tr>'
        rows += "".join(f"<tr{emphasis}>{cells}</tr>" for cells in _lines(solution))
    return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"


def _lines(solution: ContactsSolution) -> Iterator[str]:
    """Cells of the contacts of a solution."""
    for k, mode in enumerate(solution.modes):
        look = MODES[int(mode)]
        name = mode.name.replace("_", " ").capitalize()
        low, high = _words(solution.forces[k]), _words(solution.forces_end[k])
        motion, rate = _words(solution.contact_motions[k]), _words(solution.gap_rates[[k]])
        cells = [f"({low})", "" if high == low else f"({high})", f"({motion})", rate]
        words = "".join(f"<td>{escape(cell)}</td>" for cell in cells)
        yield f"<th>{k + 1}</th><th>{chip(name, look.fill, look.hatch, look.ink)}</th>{words}"


def _words(vector: Any) -> str:
    """Components with four digits, without rounding errors and negative zeros."""
    size = np.abs(vector[np.isfinite(vector)]).max(initial=0.0)
    return ", ".join(f"{0.0 if abs(x) < 1e-9 * size else x:.4g}" for x in np.asarray(vector) + 0.0)


def lines(file: ContactsFile) -> str:
    """Program for the contacts, their solutions and, if the file describes it, the motion over time."""
    return "\n".join([*_solve(file), *_simulate(file)]) + "\n"


def _solve(file: ContactsFile) -> Iterator[str]:
    problem = file.build()
    yield "import numpy as np"
    yield "import planar_pushing as pp"
    yield ""
    yield f"outline = {outline_code(file.object.outline)}"
    yield f"effects = {code(problem['effects'])}"
    yield from _lines_of_list("contacts", problem["contacts"])
    yield "print(pp.solve_contacts(contacts, effects=effects, outline=outline))"


def _simulate(file: ContactsFile) -> Iterator[str]:
    if file.simulate is None:
        return
    settings = file.arguments(file.simulate)
    yield ""
    yield from _lines_of_list("contacts", settings.pop("contacts"))
    yield "pushers = ["
    yield from (f"    {_pusher(pusher)}," for pusher in settings.pop("pushers"))
    yield "]"
    yield "log = pp.simulate_contacts("
    yield "    contacts, pushers, effects=effects, outline=outline,"
    others = {name: value for name, value in settings.items() if name not in ("effects", "outline")}
    yield from (f"    {name}={code(value)}," for name, value in others.items() if value is not None)
    yield ")"


def _lines_of_list(name: str, values: list[Any]) -> Iterator[str]:
    """An assignment of a list, with a line for each entry."""
    yield f"{name} = ["
    yield from (f"    {code(value)}," for value in values)
    yield "]"


def _pusher(pusher: Pusher) -> str:
    radius = f", radius={pusher.radius!r}" if pusher.radius else ""
    kind = f"shape={str(pusher.shape)!r}{radius}, frame={str(pusher.frame)!r}"
    return f"pp.Pusher(velocity={code(list(pusher.pieces))}, {kind})"


def write(
    file: ContactsFile, name: str, path: Path, size: tuple[float, float], point: float
) -> None:
    """Write a file for download: the scene, its picture, the log, or the lines of Python."""
    if name == "scene.yaml":
        save_contacts_file(file, path)
    elif name == "log.nc":
        write_dataset(simulate_contacts_file(file), path)
    elif name == "scene.py":
        path.write_text(lines(file), encoding="utf-8")
    else:
        picture = sketch(file)
        text = to_svg(picture.draw(), picture.box(), size, point=point)
        path.write_text(text, encoding="utf-8")
