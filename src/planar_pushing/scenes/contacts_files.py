"""Read and write scene files with several contacts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from planar_pushing.mechanics.effects import Effect
from planar_pushing.mechanics.entries import TAGS, entry
from planar_pushing.mechanics.outline import Outline, read_drawing, require_outline
from planar_pushing.mechanics.outline.entries import OUTLINE
from planar_pushing.mechanics.supports import Disc
from planar_pushing.objects.several.contact import Contact, components, place_contacts
from planar_pushing.objects.several.solve_contacts import scene_about_center
from planar_pushing.scenes.contacts_model import ContactsFile
from planar_pushing.scenes.files import (
    explain,
    has_contacts,
    load_model,
    load_scene_file,
    require_in_files,
    require_title,
    write_plain,
)
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.terms.domain import ROTATION
from planar_pushing.terms.errors import (
    InvalidFile,
    InvalidValue,
    require_kind,
    require_number,
    require_path,
)
from planar_pushing.terms.replacing import PathLike
from planar_pushing.terms.units import Units


def load_contacts(path: PathLike) -> dict[str, Any]:
    """Read a scene file with several contacts.

    Returns
    -------
    dict
        The arguments of `solve_contacts`: `contacts`, `effects` and `outline`. If the file has a section
        `simulate`, they are those of its first instant: the contacts have the velocities of their pushers,
        and those with walls follow.

    Raises
    ------
    InvalidFile
        If the file is invalid; the message names the file, key, value, allowed values and remedy.
    """
    return load_contacts_file(path).build()


def load_contacts_file(path: PathLike) -> ContactsFile:
    """Read a scene file with several contacts; errors as in `load_contacts`."""
    path = require_path("path", path)
    if not has_contacts(path):
        load_scene_file(path)  # or what is wrong with the file
        raise InvalidFile(
            f"{path}: contacts: missing; allowed: a list of one to four contacts; load a scene with one "
            "contact by load_scene"
        )
    return load_model(path, ContactsFile)


def load_any_file(path: PathLike) -> SceneFile | ContactsFile:
    """Read a scene file with one contact or with several."""
    return load_contacts_file(path) if has_contacts(path) else load_scene_file(path)


def save_contacts(
    contacts: Sequence[Contact],
    path: PathLike,
    title: str = "",
    *,
    effects: Sequence[Effect],
    outline: Any = None,
    units: Units | None = None,
) -> None:
    """Write a scene file with several contacts, which `load_contacts` reads back.

    Parameters
    ----------
    contacts, effects, outline
        As of `solve_contacts`, of one problem.
    path : str or path
    title : str
    units : Units, optional
        Names of the units.

    Raises
    ------
    InvalidValue
        If `solve_contacts` refuses the arguments, a velocity or a law is an array, or scene files cannot
        represent a law, an effect or a support.
    """
    require_title(title)
    shape = None if outline is None else require_outline(outline)
    place_contacts(contacts, shape, outline)
    scene_about_center(effects, shape)
    require_in_files(effects)
    content: dict[str, Any] = {"title": title}
    if units is not None:
        content["units"] = entry(
            require_kind("units", units, Units, "name them, as in pp.Units(length='mm')")
        )
    if outline is not None:
        content["object"] = {"outline": _drawing(outline)}
    content["contacts"] = [_entry_of_contact(contact) for contact in contacts]
    content["effects"] = [entry(effect) for effect in effects]
    try:
        file = ContactsFile.model_validate(content)
    except ValidationError as error:
        line = explain(Path(str(path)), error.errors()[0])
        raise InvalidValue(
            "contacts", line, "what scene files can represent", "change it"
        ) from None
    save_contacts_file(file, require_path("path", path))


def save_contacts_file(file: ContactsFile, path: PathLike) -> None:
    """Write a scene file, including its simulation, that `load_contacts_file` reads back unchanged."""
    write_plain(file.model_dump(mode="json", exclude_none=True), path)


def _drawing(outline: Any) -> Any:
    """The outline in a file; of a drawing every vertex, because its sides are numbered."""
    holes: Any = getattr(outline, "holes", None) or getattr(outline, "interiors", ())
    if isinstance(outline, (Outline, Disc)) or len(holes):
        return OUTLINE.to_file(require_outline(outline))
    return [[float(x), float(y)] for x, y in read_drawing(outline).vertices]


def _entry_of_contact(contact: Contact) -> dict[str, Any]:
    """A contact in the form of files."""
    if type(contact.law) not in TAGS:
        raise InvalidValue(
            "law", contact.law, "one law Coulomb, InfiniteFriction or PerfectlyRough",
            "save one problem at a time",
        )  # fmt: skip
    content: dict[str, Any] = {}
    for name in ("point", "normal", "velocity"):
        if (value := getattr(contact, name)) is not None:
            content[name] = _numbers(name, value)
    if contact.side is not None:
        content["side"] = int(contact.side)
    if contact.grip_force is not None:
        content["grip_force"] = require_number(
            "grip_force", contact.grip_force, math.isfinite, "a single number",
            "save one problem at a time",
        )  # fmt: skip
    if contact.twist is not None:
        v_x, v_y, omega = _numbers("twist", contact.twist)
        content["twist"] = {"v_x": v_x, "v_y": v_y, "omega": ROTATION.to_file(omega)}
    return content | entry(contact.law)


def _numbers(name: str, value: Any) -> list[float]:
    """Components of a vector of single numbers."""
    parts = components(name, value, 3 if name == "twist" else 2)
    if any(map(np.ndim, parts)):
        raise InvalidValue(name, value, "single numbers", "save one problem at a time")
    return [float(part) for part in parts]
