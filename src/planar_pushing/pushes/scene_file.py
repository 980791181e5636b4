"""Scene file of an object with a support identified from its pushes."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import BETA0, LENGTH, NEXT, RHO
from planar_pushing.mechanics.outline.entries import entry_of_outline
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.identified import Identified
from planar_pushing.pushes.logs.schema import outline_of
from planar_pushing.scenes.files import save_object_file
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.replacing import PathLike

#: Most points of a support in a file, limited by the size of file that can be read.
MOST = 3500


def save_support(support: Identified, pushes: xr.Dataset, path: PathLike) -> None:
    """Write a scene file of a pushed object on its identified support.

    Parameters
    ----------
    support : Identified
    pushes : xarray.Dataset
        Checked pushes of one object from which the support was identified.
    path : path

    Raises
    ------
    InvalidValue
        If the support has more points than a file can contain.
    InvalidFile
        If the support does not make a scene (a single point does not), or the file cannot be written.
    """
    count = len(support.support.positions)
    if count > MOST:
        allowed = f"at most {MOST} in a scene file"
        raise InvalidValue("support", f"{count} points", allowed, "give a larger spacing")
    save_object_file(object_entry(support, pushes), path)


def object_entry(support: Identified, pushes: xr.Dataset) -> dict[str, Any]:
    """Content of the file. If no force was measured, the weight is 1 and the title says so.

    The contact is in the middle of the side that the first push touches, or at the point of the arc.
    """
    (name,) = (str(label) for label in pushes["object"].values)
    outline = outline_of(pushes, name)
    weighed = bool(np.isfinite(support.weight))
    weight = _plain([support.weight])[0] if weighed else 1.0
    places = zip(support.support.positions, support.support.weights, strict=True)
    return {
        "title": f"{name} on the support identified from {pushes.sizes['push']} pushes"
        + ("" if weighed else "; the weight is unknown and set to 1"),
        "object": {
            "outline": [_plain(corner) for corner in outline.corners]
            if outline.corners
            else dict(entry_of_outline(outline)),
            "feet": [
                {"position": _plain(point), "weight": _plain([weight])[0]}
                for point, weight in places
            ],
            "contact": {"point": _plain(_middle(outline, pushes["contact"].values[:1]))},
        },
        "contact": {
            "law": "coulomb",
            "friction_coefficient": _plain([support.contact_friction])[0],
        },
        "effects": [{"type": "support_friction", "weight": weight}],
        "units": {
            "length": pushes["contact"].attrs["units"],
            "force": pushes["force"].attrs["units"] if "force" in pushes else "N",
        },
    }


def _plain(values: Any) -> list[float]:
    """Numbers rounded to nine digits, far more than a measurement has."""
    return [float(f"{value:.9g}") for value in values]


def _middle(outline: Outline, contact: Any) -> Array:
    """Middle of the side nearest a contact, or the point of an arc nearest to it."""
    places = nearest_place(outline, contact)
    row = outline.pieces[places.piece[0]]
    if row[RHO] == 0.0:  # the side after the corner
        row = outline.pieces[int(row[NEXT])]
    if not np.isinf(row[RHO]):
        return np.asarray(places.point[0])
    return np.asarray(
        row[:2] + row[LENGTH] / 2.0 * np.array([np.cos(row[BETA0]), np.sin(row[BETA0])])
    )
