"""Reader of logs of a triangle on three feet or its face (Zhou, Paolini, Bagnell and Mason, ICRA 2016).

A log is a text file with the number of pushes and, for each push, the poses before and after (x y z in mm,
quaternion w x y z), the number of force samples, the samples (time in s, f_x, f_y in N), the number of tool
poses, and the tool poses (time, x y z in mm, quaternion).
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.formats.lines import Lines
from planar_pushing.pushes.logs.combine import concat_pushes, require_file_names
from planar_pushing.pushes.logs.poses import pushes_from_poses, rotate
from planar_pushing.terms.errors import InvalidFile, InvalidValue, number_of
from planar_pushing.terms.replacing import PathLike

SOURCE = "Zhou, Paolini, Bagnell and Mason, ICRA 2016"
#: Right triangle with legs of 150 mm; the frame of its markers is at the right angle.
OUTLINE = ((0.0, 0.0), (150.0, 0.0), (0.0, 150.0))
CENTER_OF_MASS = (50.0, 50.0)
MASS = 1.518
#: Standard deviations of positions in mm, of angles in degrees and of forces in N.
NOISE = (0.5, 0.3, 0.05)
#: Reflection from the sensor's axes to the tool's; the sensor measures the reaction force.
SENSOR = np.array([[1.0, 1.0], [1.0, -1.0]]) / np.sqrt(2.0)
#: Initial fraction of the force samples, before the contact has settled.
SETTLING = 0.3
#: Rounding error of feet on a line, relative to their distance from the center of mass.
ON_LINE = 1e-12
#: Six coordinates in a file name.
NUMBERS = re.compile(r"(?<![\d.])(\d+(?:\.\d+)?(?:_\d+(?:\.\d+)?){5})(?![\d.])")
ALLOWED = "x1_x2_x3_y1_y2_y3 of the feet in mm, such as 30_90_30_30_30_90.txt, or patch.txt"
#: Count of numbers on each kind of line.
POSE, SAMPLE, TOOL = 7, 3, 8


class Record(NamedTuple):
    """One push of a log as written: poses before and after, force samples, and tool poses."""

    before: Array
    after: Array
    forces: Array
    tools: Array


def read_three_feet(*files: PathLike) -> xr.Dataset:
    """Read logs of the triangle on three feet or on its whole face.

    Parameters
    ----------
    *files : path
        Text files. The name of a file gives the positions of the feet as x1_x2_x3_y1_y2_y3 in mm, and
        `patch` in the name means that there are none. A log without the number of pushes on its first line
        is read to its end.

    Returns
    -------
    xarray.Dataset
        Dataset like that of `load_pushes`, in mm and N. Each file is an object with the file's name without
        its extension; it has feet, foot weights computed from the center of mass, center of mass, and mass.
        A force is the mean of those samples after the first 30 % that are not weaker than the samples'
        mean, each along the object's axes at its time. Pushes that do not touch the object, or begin
        deep in it, are omitted; their number is the attribute `left_out`.

    Raises
    ------
    InvalidFile
        If a file is missing, is not such a log, or is cut short; the message gives the push and the line.
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
    """Dataset of the pushes of a log."""
    before, after = (
        np.array([getattr(record, key) for record in records]) for key in ("before", "after")
    )
    tools = [record.tools[[0, -1], 1:] for record in records]
    return pushes_from_poses(
        outline=OUTLINE, poses_before=planar(before), poses_after=planar(after),
        finger_start=[tool[0, :2] for tool in tools], finger_end=[tool[1, :2] for tool in tools],
        force=[mean_force(record) for record in records], feet=feet,
        foot_weights=None if feet is None else loads(feet), center_of_mass=CENTER_OF_MASS, mass=MASS,
        units=("mm", "N"), name=name, source=SOURCE, noise=NOISE, skip_missed=True,
    )  # fmt: skip


def _feet(file: Path) -> Array | None:
    """Positions of the feet from a file name, shape (3, 2); None for a patch."""
    match = NUMBERS.search(file.stem)
    if match is None and "patch" not in file.stem.lower():
        raise InvalidFile(f"{file}: a name without feet; allowed: {ALLOWED}; rename the file")
    if match is None:
        return None
    feet = np.array(match[1].split("_"), dtype=float).reshape(2, 3).T
    if not _stand(feet):
        center = f"({CENTER_OF_MASS[0]:g}, {CENTER_OF_MASS[1]:g})"
        raise InvalidFile(
            f"{file}: feet that do not carry the center of mass {center}; allowed: {ALLOWED}; "
            "rename the file"
        )
    return feet


def _stand(feet: Array) -> bool:
    """Whether every foot of three carries weight, or the center of mass is between feet on a line."""
    shares = loads(feet)
    if not np.isnan(shares).any():
        return bool((shares > 0.0).all())
    away = feet - CENTER_OF_MASS
    x, y = away[np.hypot(*away.T).argmax()]
    along, across = away @ (x, y), away @ (-y, x)
    return bool(along.min() < 0.0 and np.abs(across).max() <= ON_LINE * along.max())


def loads(feet: Array) -> Array:
    """Fractions of the weight on three feet, by balance about the center of mass; NaN if collinear."""
    balance = np.vstack([np.ones(3), feet.T])
    if np.linalg.matrix_rank(balance) < 3:
        return np.full(3, np.nan)
    return np.asarray(np.linalg.solve(balance, [1.0, *CENTER_OF_MASS]))


def yaw(quaternion: Array) -> Array:
    """Angles about the vertical of quaternions (w, x, y, z), shape S + (4,), in radians."""
    return np.asarray(2.0 * np.arctan2(quaternion[..., 3], quaternion[..., 0]))


def planar(poses: Array) -> Array:
    """Planar poses (x, y, angle) from poses of shape (n, 7)."""
    return np.column_stack([poses[:, :2], yaw(poses[:, 3:])])


def mean_force(record: Record) -> Array:
    """Mean force of the finger on the object in the world's axes; NaN without samples.

    The samples are averaged along the object's axes at their times, assuming a uniform rotation from the
    pose before to the pose after. The mean is then converted with the object's orientation halfway through.
    """
    forces = record.forces[:, 1:] - record.forces[:1, 1:]
    kept = np.arange(len(forces)) >= int(SETTLING * len(forces))
    if not kept.any():
        return np.full(2, np.nan)
    strength = np.hypot(*forces.T)
    kept &= strength >= strength[kept].mean()
    before, after = (yaw(pose[3:]) for pose in (record.before, record.after))
    turn = np.remainder(after - before + np.pi, 2.0 * np.pi) - np.pi
    times = record.forces[:, 0] - record.forces[0, 0]
    passed = times / times[-1] if times[-1] > 0.0 else np.full(len(times), 0.5)
    # The tool does not rotate; halfway through, the object has made half its rotation.
    measured = rotate(-(forces[kept] @ SENSOR.T), turn * (0.5 - passed[kept])).mean(axis=0)
    return rotate(measured, yaw(record.tools[0, 4:]))


def read_records(file: Path) -> list[Record]:
    """Return the pushes of a log as written, or raise `InvalidFile`."""
    lines = Lines(file)
    if len(lines.next_numbers()) == 1:
        lines.back()
        count = lines.count("the number of pushes")
        records = [_record(lines.of_push(k + 1, count)) for k in range(count)]
        if lines.left:
            raise lines.wrong(
                f"is followed by more lines, but the first line announces {number_of(count, 'push')}"
            )
    else:
        lines.back()
        records = []
        while lines.left:
            records.append(_record(lines.of_push(len(records) + 1)))
    if not records:
        raise InvalidFile(f"{file}: holds no push; allowed: at least one; name another file")
    return records


def _record(lines: Lines) -> Record:
    before, after = lines.rows(1, POSE, "the pose before"), lines.rows(1, POSE, "the pose after")
    forces = lines.rows(lines.count("the number of force samples"), SAMPLE, "a force sample")
    tools = lines.rows(lines.count("the number of tool poses", 1), TOOL, "a tool pose")
    return Record(before[0], after[0], forces, tools)
