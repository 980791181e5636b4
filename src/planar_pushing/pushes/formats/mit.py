"""Reader of pushes of polygons and ellipses in MATLAB files (Yu, Bauza, Fazeli and Rodriguez, IROS 2016).

The files are those published by Zhou, Hou and Mason with the models that they fitted to the pushes.
`record_all[k]` contains `init_pose_gt` and `final_pose_gt` (x, y in m, angle in radians), and
`init_tip_pt` and `final_tip_pt` (m). The pushes are straight, with a round tip.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import scipy.io
import xarray as xr

from planar_pushing.mechanics.outline import Outline, require_outline, rounded
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.pushes.files import HDF5, refuse_raw
from planar_pushing.pushes.logs.combine import concat_pushes, require_file_names
from planar_pushing.pushes.logs.poses import pushes_from_poses
from planar_pushing.terms.errors import InvalidFile, InvalidValue, suggestion
from planar_pushing.terms.replacing import PathLike

SOURCE = "Yu, Bauza, Fazeli and Rodriguez, IROS 2016, as filtered by Zhou, Hou and Mason"
#: Radius of the tip in mm.
TIP = 4.75
#: Files are in m, and the dataset is in mm.
MILLIMETER = 1e3
#: Fields of a push with their numbers of values.
FIELDS = {"init_pose_gt": 3, "final_pose_gt": 3, "init_tip_pt": 2, "final_tip_pt": 2}
#: The only variable that is read.
RECORDS = "record_all"


def rectangle(width: float, height: float) -> Array:
    """Corners of a rectangle about the origin."""
    return np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * (width / 2.0, height / 2.0)


def triangle(a: float, b: float) -> Array:
    """Corners of a right triangle with its right angle at (45, 45)."""
    d = 45.0
    return np.array([(d, d), (d - b, d), (d, d - a)])


def hexagon(radius: float) -> Array:
    """Corners of a regular hexagon about the origin, with one corner at angle 0."""
    angles = np.arange(6) * np.pi / 3.0
    return radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def butter() -> Outline:
    """Outline of an object with a waist: arcs and their tangents, within 0.2 mm of the published mesh."""
    half = [(23.2, 0.0), (53.7, 49.4), (0.0, 102.2), (-53.7, 49.4)]
    radii = [24.4, 22.3, 58.4, 22.3]
    return rounded([*half, *((-x, -y) for x, y in half)], [*radii, *radii])


#: Number of arcs of an ellipse: its final poses are within a tenth of the errors of the poses.
ARCS = 64
#: Outlines in mm by the name of the shape. The ellipses and the last outline are those of the meshes of
#: the objects that their authors published (push-est-public and pdproc of MIT's MCube Lab).
OUTLINES: dict[str, Outline] = {
    name: require_outline(shape)
    for name, shape in {
        "rect1": rectangle(90.0, 90.0),
        "rect2": rectangle(89.91, 112.58),
        "rect3": rectangle(135.01, 89.94),
        "tri1": triangle(125.87, 125.90),
        "tri2": triangle(125.87, 151.00),
        "tri3": triangle(125.61, 176.5),
        "hex": hexagon(60.5),
        "ellip1": Disc(52.43),
        "ellip2": Outline.ellipse(52.43, 65.53, ARCS),
        "ellip3": Outline.ellipse(52.43, 78.64, ARCS),
        "butter": butter(),
    }.items()
}


def read_mit(*files: PathLike) -> xr.Dataset:
    """Read pushes of polygons and ellipses from the MIT push data, in MATLAB files of version 5.

    Parameters
    ----------
    *files : path
        MATLAB files. Each name must contain a shape: rect1, rect2, rect3, tri1, tri2, tri3, hex, ellip1,
        ellip2, ellip3 or butter. The half axes of the ellipses, 52.43 mm by 52.43, 65.53 and 78.64 mm, and
        the sides and arcs of butter are those of the meshes of the objects that the MCube Lab of MIT
        published (push-est-public, pdproc).

    Returns
    -------
    xarray.Dataset
        Dataset like that of `load_pushes`, in mm and without forces. Each file is an object with the file's
        name without its extension. Pushes that do not touch the object, or begin with the tip's center
        inside of it, are omitted; their number is the attribute `left_out`. A tip that overlaps the object
        at the start, with its center outside, touches immediately; this occurs in most of the pushes.

    Raises
    ------
    InvalidFile
        If a file is missing, is not a MATLAB file, lacks fields, or has no known shape in its name.
    """
    require_file_names(files)
    return concat_pushes([_read(Path(file)) for file in files])


def _read(file: Path) -> xr.Dataset:
    if file.is_file():
        refuse_raw(file)  # The names of raw logs have no shape.
    outline, fields = OUTLINES[_shape(file)], _fields(file)
    before, after = (fields[key] * (MILLIMETER, MILLIMETER, 1.0) for key in FIELDS if "pose" in key)
    start, end = (fields[key] * MILLIMETER for key in FIELDS if "tip" in key)
    try:
        return pushes_from_poses(
            outline=outline, poses_before=before, poses_after=after, finger_start=start, finger_end=end,
            finger_radius=TIP, units=("mm", "N"), name=file.stem, source=SOURCE, tolerance=TIP,
            skip_missed=True,
        )  # fmt: skip
    except InvalidValue as error:
        raise InvalidFile(f"{file}: {error}") from None


def _shape(file: Path) -> str:
    """Return the name of the shape in a file's name, or raise `InvalidFile`."""
    words: list[str] = re.findall(r"[a-z]+\d*", file.stem.lower())
    shapes = [word for word in words if word in OUTLINES]
    if len(shapes) != 1:
        remedy = suggestion(words[-1] if words else "", OUTLINES, "rename the file by its shape")
        allowed = ", ".join(OUTLINES)
        raise InvalidFile(
            f"{file}: a name without a known shape; allowed: one of {allowed}; {remedy}"
        )
    return shapes[0]


def _fields(file: Path) -> dict[str, Array]:
    """Values of each field over the pushes of a file, shape (n, 3) or (n, 2), or raise `InvalidFile`."""
    records = _records(file)
    return {
        name: np.array(
            [_field(file, k, record, name, width) for k, record in enumerate(records, 1)]
        )
        for name, width in FIELDS.items()
    }


def _field(file: Path, number: int, record: Any, name: str, width: int) -> Array:
    try:
        values = np.asarray(getattr(record, name, np.nan), dtype=float)
    except (TypeError, ValueError):
        values = np.full(1, np.nan)
    if not hasattr(record, name):
        fault = f"has no field {name}; allowed: {', '.join(FIELDS)}"
    elif values.shape != (width,) or not np.isfinite(values).all():
        fault = f"holds no {width} finite numbers in {name}"
    else:
        return values
    raise InvalidFile(f"{file}: push {number} {fault}; export the file again")


def _records(file: Path) -> list[Any]:
    """Return the pushes of a file, or raise `InvalidFile`."""
    if not file.is_file():
        raise InvalidFile(f"{file}: no such file; name a MATLAB file")
    with file.open("rb") as stream:
        if stream.read(len(HDF5)) == HDF5:
            raise InvalidFile(
                f"{file}: is an HDF5 file; allowed: MATLAB files of version 5; a dataset of pushes needs "
                "no conversion"
            )
    try:
        # Damaged files make scipy raise many kinds of errors.
        content = scipy.io.loadmat(
            file, squeeze_me=True, struct_as_record=False, variable_names=[RECORDS]
        )
    except Exception:
        raise InvalidFile(
            f"{file}: is not a MATLAB file of version 5; save it with -v6 or -v7"
        ) from None
    if RECORDS not in content:
        raise InvalidFile(
            f"{file}: has no variable {RECORDS}; allowed: the pushes in {RECORDS}; export them"
        )
    return list(np.atleast_1d(content[RECORDS]))
