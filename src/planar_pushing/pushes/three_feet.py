"""Logs of a triangle on three feet, or on its whole face (Zhou, Paolini, Bagnell and Mason, ICRA 2016).

Text: the number of pushes, and for each the pose before and after (x y z in mm, quaternion w x y z), the
number of force samples and the samples (time in s, f_x, f_y in N), the number of tool poses and the poses
(time, x y z in mm, quaternion).
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.combine import concat_pushes, require_file_names
from planar_pushing.pushes.lines import Lines
from planar_pushing.pushes.poses import pushes_from_poses, turned
from planar_pushing.study.files.replacing import PathLike
from planar_pushing.terms.errors import InvalidFile, InvalidValue

SOURCE = "Zhou, Paolini, Bagnell and Mason, ICRA 2016"
#: Right triangle of 150 mm legs; the frame of its markers is at the right corner.
OUTLINE = ((0.0, 0.0), (150.0, 0.0), (0.0, 150.0))
CENTER_OF_MASS = (50.0, 50.0)
MASS = 1.518
#: Standard deviations of positions in mm, angles in degrees and forces in N.
NOISE = (0.5, 0.3, 0.05)
#: The sensor measures the reaction, in axes that are those of the tool after this reflection.
SENSOR = np.array([[1.0, 1.0], [1.0, -1.0]]) / np.sqrt(2.0)
#: Fraction of the force samples at the start of a push, before the contact has settled.
SETTLING = 0.3
#: Six coordinates in a file's name.
NUMBERS = re.compile(r"(?<![\d.])(\d+(?:\.\d+)?(?:_\d+(?:\.\d+)?){5})(?![\d.])")
ALLOWED = "x1_x2_x3_y1_y2_y3 of the feet in mm, such as 30_90_30_30_30_90.txt, or patch.txt"
#: Numbers on a line of each kind.
POSE, SAMPLE, TOOL = 7, 3, 8


class Record(NamedTuple):
    """One push of a log: poses before and after, force samples and tool poses, as they are written."""

    before: Array
    after: Array
    forces: Array
    tools: Array


def read_three_feet(*files: PathLike) -> xr.Dataset:
    """Read logs of the triangle on three feet, or on its whole face.

    Parameters
    ----------
    *files : path
        Text files, whose names give the places of the feet, x1_x2_x3_y1_y2_y3 in mm; `patch` in a name says
        that there are none. A log without the number of pushes on its first line is read to its end.

    Returns
    -------
    xarray.Dataset
        As `load_pushes` returns it, in mm and N. Each file is an object, named by the file without its
        ending, with feet, their weights by the center of mass, center of mass and mass. Forces are means of
        the samples after the first 30 % that are not weaker than their mean, each along the object's axes
        at its time. Pushes that do not touch the
        object are left out, their number is the attribute `left_out`.

    Raises
    ------
    InvalidFile
        Where a file is missing, is no such log, or is cut short: the message says at which push and line.
    """
    require_file_names(files)
    return concat_pushes([_read(Path(file)) for file in files])


def _read(file: Path) -> xr.Dataset:
    records = read_records(file)
    feet = _feet(file)
    try:
        return _pushes(records, feet, file.stem)
    except InvalidValue as error:
        raise InvalidFile(f"{file}: {error}") from None


def _pushes(records: list[Record], feet: Array | None, name: str) -> xr.Dataset:
    """The pushes of a log in the schema."""
    before, after = (
        np.array([getattr(each, key) for each in records]) for key in ("before", "after")
    )
    tools = [each.tools[[0, -1], 1:] for each in records]
    return pushes_from_poses(
        outline=OUTLINE, poses_before=planar(before), poses_after=planar(after),
        finger_start=[each[0, :2] for each in tools], finger_end=[each[1, :2] for each in tools],
        force=[mean_force(each) for each in records], feet=feet,
        foot_weights=None if feet is None else loads(feet), center_of_mass=CENTER_OF_MASS, mass=MASS,
        units=("mm", "N"), name=name, source=SOURCE, noise=NOISE, skip_missed=True,
    )  # fmt: skip


def _feet(file: Path) -> Array | None:
    """Places of the feet that a file's name gives, shape (3, 2); None for a patch."""
    found = NUMBERS.search(file.stem)
    if found is None and "patch" not in file.stem.lower():
        raise InvalidFile(f"{file}: a name without feet; allowed: {ALLOWED}; rename the file")
    if found is None:
        return None
    feet = np.array(found[1].split("_"), dtype=float).reshape(2, 3).T
    if (loads(feet) <= 0.0).any():
        center = f"({CENTER_OF_MASS[0]:g}, {CENTER_OF_MASS[1]:g})"
        raise InvalidFile(
            f"{file}: feet that do not carry the center of mass {center}; allowed: {ALLOWED}; "
            "rename the file"
        )
    return feet


def loads(feet: Array) -> Array:
    """Fractions of the weight on three feet that balance it about the center of mass; NaN on one line."""
    balance = np.vstack([np.ones(3), feet.T])
    if np.linalg.matrix_rank(balance) < 3:
        return np.full(3, np.nan)
    return np.asarray(np.linalg.solve(balance, [1.0, *CENTER_OF_MASS]))


def yaw(quaternion: Array) -> Array:
    """Angle about the vertical of quaternions (w, x, y, z), shape S + (4,), radians."""
    return np.asarray(2.0 * np.arctan2(quaternion[..., 3], quaternion[..., 0]))


def planar(poses: Array) -> Array:
    """(x, y, angle) of poses of shape (n, 7)."""
    return np.column_stack([poses[:, :2], yaw(poses[:, 3:])])


def mean_force(record: Record) -> Array:
    """Mean force of the finger on the object along the axes that the object has midway; NaN without any.

    Each sample counts along the object's axes at its time, as the object turns evenly from the pose before
    to the pose after; the mean is turned back into the world's axes.
    """
    forces = record.forces[:, 1:] - record.forces[:1, 1:]
    kept = np.arange(len(forces)) >= int(SETTLING * len(forces))
    if not kept.any():
        return np.full(2, np.nan)
    strength = np.hypot(*forces.T)
    kept &= strength >= strength[kept].mean()
    before, after = (yaw(each[3:]) for each in (record.before, record.after))
    turn = np.remainder(after - before + np.pi, 2.0 * np.pi) - np.pi
    times = record.forces[:, 0] - record.forces[0, 0]
    passed = times / times[-1] if times[-1] > 0.0 else np.full(len(times), 0.5)
    # The tool does not turn; the object has turned by half midway.
    measured = turned(-(forces[kept] @ SENSOR.T), turn * (0.5 - passed[kept])).mean(axis=0)
    return turned(measured, yaw(record.tools[0, 4:]))


def read_records(file: Path) -> list[Record]:
    """The pushes of a log as they are written, or `InvalidFile`."""
    lines = Lines(file)
    if len(lines.next_numbers()) == 1:
        lines.back()
        count = lines.count("the number of pushes")
        found = [_record(lines.of_push(k + 1, count)) for k in range(count)]
        if lines.left:
            raise lines.wrong(f"goes on after the {count} pushes that its first line says")
    else:
        lines.back()
        found = []
        while lines.left:
            found.append(_record(lines.of_push(len(found) + 1)))
    if not found:
        raise InvalidFile(f"{file}: holds no push; allowed: at least one; name another file")
    return found


def _record(lines: Lines) -> Record:
    before, after = lines.rows(1, POSE, "the pose before"), lines.rows(1, POSE, "the pose after")
    forces = lines.rows(lines.count("the number of force samples"), SAMPLE, "a force sample")
    tools = lines.rows(lines.count("the number of tool poses", 1), TOOL, "a tool pose")
    return Record(before[0], after[0], forces, tools)
