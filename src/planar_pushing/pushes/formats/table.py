"""Reader of tables of pushes of one object, in CSV files with a row for each push.

The columns are named in the first line. Lines that begin with # are comments.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.mechanics.outline import Outline, require_outline
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs.arguments import not_negative
from planar_pushing.pushes.logs.checks import ON_OUTLINE
from planar_pushing.pushes.logs.combine import concat_pushes, require_file_names
from planar_pushing.pushes.logs.poses import ambiguous_turns, pushes_from_poses, rotate
from planar_pushing.terms.domain import TURNS
from planar_pushing.terms.errors import (
    InvalidFile,
    InvalidValue,
    format_value,
    number_of,
    require_name,
    suggestion,
)
from planar_pushing.terms.replacing import PathLike

#: Columns of a table, by what they give; the force can be left out.
COLUMNS = {
    "before": ("x_before", "y_before", "angle_before"),
    "after": ("x_after", "y_after", "angle_after"),
    "start": ("x_start", "y_start"),
    "end": ("x_end", "y_end"),
}
FORCE = ("x_force", "y_force")
REQUIRED = tuple(name for names in COLUMNS.values() for name in names)
#: Units of the angles in a table, each with its size in radians.
ANGLES = {"degrees": math.pi / 180.0, "radians": 1.0}
#: Bytes that begin a file of another kind, such as netCDF4, a spreadsheet, a PDF and UTF-16 text.
BINARY = (b"\x89HDF", b"PK", b"%PDF", b"\xff\xfe", b"\xfe\xff")
#: Angles are in the other unit if the finger ends a push this many times nearer to the object with it.
NEARER = 4.0


class PushTable(NamedTuple):
    """The numbers of a file: a row for each push, by column, and the line of each row."""

    columns: dict[str, Array]
    lines: list[int]

    def of(self, names: Sequence[str]) -> Array:
        """Some of the columns, shape (n, len(names))."""
        return np.column_stack([self.columns[name] for name in names])


def read_table(
    *files: PathLike,
    outline: Any,
    angles: str = "degrees",
    name: str | None = None,
    finger_radius: float = 0.0,
    units: tuple[str, str] = ("mm", "N"),
    noise: tuple[float, float, float] | None = None,
    tolerance: float | None = None,
    skip_missed: bool = False,
) -> xr.Dataset:
    """Read tables of pushes.

    Parameters
    ----------
    *files : path
        CSV files in UTF-8 with the columns x_before, y_before, angle_before, x_after, y_after and
        angle_after (poses of the object), x_start, y_start, x_end and y_end (center of the finger), and
        x_force and y_force (mean force of the finger; both can be missing, and their cells empty where the
        force was not measured), all in the world frame and in any order.
    angles : {"degrees", "radians"}
        Unit of the angles.
    name : str, optional
        Name of the object; by default each file is an object with the file's name without its extension.
    outline, finger_radius, units, noise, tolerance, skip_missed
        As in `pushes_from_poses`.

    Returns
    -------
    xarray.Dataset
        Dataset like that of `load_pushes`.

    Raises
    ------
    InvalidFile
        If a file is missing, is not such a table, or its pushes are impossible, also because angles are in
        the other unit; the message gives the line, the column or the pushes.
    """
    require_file_names(files)
    require_name("angles", angles, ANGLES, "name one of these units")
    whole = require_outline(outline)
    radius = not_negative("finger_radius", finger_radius, "give 0 for a point")
    parts = []
    for file in map(Path, files):
        table = _read(file)
        _require_unit(file, table, angles, whole, radius)
        scale = (1.0, 1.0, ANGLES[angles])
        try:
            parts.append(pushes_from_poses(
                outline=whole, poses_before=table.of(COLUMNS["before"]) * scale,
                poses_after=table.of(COLUMNS["after"]) * scale, finger_start=table.of(COLUMNS["start"]),
                finger_end=table.of(COLUMNS["end"]), finger_radius=radius,
                force=table.of(FORCE) if FORCE[0] in table.columns else None, units=units, noise=noise,
                name=file.stem if name is None else name, source=file.name, tolerance=tolerance,
                skip_missed=skip_missed,
            ))  # fmt: skip
        except InvalidValue as error:
            raise InvalidFile(f"{file}: {error} (push 0 is the first row)") from None
    return concat_pushes(parts)


def _read(file: Path) -> PushTable:
    """The numbers of a table, or `InvalidFile`."""
    rows = _rows(file)
    line, names = next(rows, (0, []))
    if not names:
        raise InvalidFile(f"{file}: is empty; allowed: {_allowed_columns()}; add rows")
    names = [name.strip() for name in names]
    _require_columns(file, names)
    values, lines = [], []
    for line, cells in rows:
        if len(cells) != len(names):
            count = number_of(len(cells), "value")
            raise InvalidFile(
                f"{file}: line {line} holds {count}; allowed: {len(names)}, one for each column; "
                "correct the line"
            )
        values.append([_number(file, line, *pair) for pair in zip(names, cells, strict=True)])
        lines.append(line)
    if not values:
        raise InvalidFile(f"{file}: holds no push below the names of its columns; add rows")
    return PushTable(dict(zip(names, np.array(values).T, strict=True)), lines)


def _rows(file: Path) -> Iterator[tuple[int, list[str]]]:
    """Line number and cells of each line that is neither empty nor a comment."""
    try:
        content = file.read_bytes()
    except OSError as error:
        remedy = "name a table in a CSV file"
        raise InvalidFile(f"{file}: cannot be read ({error.strerror}); {remedy}") from None
    kind = "a CSV file in UTF-8; save the table as one"
    if content.startswith(BINARY) or b"\0" in content:
        raise InvalidFile(f"{file}: is not text; allowed: {kind}")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InvalidFile(f"{file}: is not text in UTF-8; allowed: {kind}") from None
    lines = [(k, line) for k, line in enumerate(text.splitlines(), 1) if not line.startswith("#")]
    for line, cells in lines:
        if cells.strip(" ,;\t"):
            try:
                yield line, next(csv.reader([cells]))
            except csv.Error:
                raise InvalidFile(f"{file}: line {line} is no row of a table; correct it") from None


def _require_columns(file: Path, names: list[str]) -> None:
    """Refuse a header with missing, unknown or repeated columns."""
    known = (*REQUIRED, *FORCE)
    if len(names) == 1 and any(mark in names[0] for mark in ";\t"):
        raise InvalidFile(
            f"{file}: columns separated by semicolons or tabs; allowed: commas, and numbers with a "
            "decimal point; export the table again"
        )
    for name in names:
        if name not in known:
            others = sorted(set(known) - set(names))
            remedy = suggestion(name, others, "rename or remove it")
            raise InvalidFile(
                f"{file}: unknown column {format_value(name)}; allowed: {_allowed_columns()}; {remedy}"
            )
        if names.count(name) > 1:
            raise InvalidFile(f"{file}: two columns {name}; allowed: one; remove the other")
    needed = REQUIRED if not set(FORCE) & set(names) else known
    if missing := [name for name in needed if name not in names]:
        raise InvalidFile(
            f"{file}: no column {', '.join(missing)}; allowed: {_allowed_columns()}; add what is missing"
        )


def _allowed_columns() -> str:
    return f"the columns {', '.join(REQUIRED)}, and {' and '.join(FORCE)} if measured"


def _number(file: Path, line: int, column: str, cell: str) -> float:
    """The number of a cell; NaN for a force that was not measured."""
    unmeasured = column in FORCE and cell.strip().lower() in ("", "nan")
    try:
        number = math.nan if unmeasured else float(cell)
    except ValueError:
        number = math.nan
    if not math.isfinite(number) and not unmeasured:
        allowed = "a finite number" + (", or nothing if unmeasured" if column in FORCE else "")
        raise InvalidFile(
            f"{file}: line {line}: {column}: {format_value(cell.strip())} given; allowed: {allowed}; "
            "correct it, or remove the line"
        )
    return number


def _require_unit(
    file: Path, table: PushTable, angles: str, outline: Outline, radius: float
) -> None:
    """Refuse angles that are in the other unit: too large, or at odds with where the finger ends."""
    (other,) = (unit for unit in ANGLES if unit != angles)
    remedy = f"give --angles {other}"
    for name in ("angle_before", "angle_after"):
        large = np.abs(table.columns[name] * ANGLES[angles]) > TURNS
        if large.any():
            row = int(large.argmax())
            value = f"{table.columns[name][row]:.6g}"
            raise InvalidFile(
                f"{file}: line {table.lines[row]}: {name}: {value} given; allowed: {angles} of at most two "
                f"turns; {remedy}"
            )
    gap, instead = (_gap(table, unit, outline, radius) for unit in (angles, other))
    if gap > max(NEARER * instead, ON_OUTLINE * outline.size):
        raise InvalidFile(
            f"{file}: the angles seem to be in {other}: the median gap between finger and object after a "
            f"push is {instead:.4g} with angles in {other} and {gap:.4g} with angles in {angles}; {remedy}"
        )
    _require_alike(file, table, angles, remedy)


def _require_alike(file: Path, table: PushTable, angles: str, remedy: str) -> None:
    """Refuse two angles of a push that are more than 180 degrees apart, because only one is wrapped."""
    before, after = (table.columns[name] for name in ("angle_before", "angle_after"))
    far = ambiguous_turns(before * ANGLES[angles], after * ANGLES[angles])
    if len(far):
        row, turn = int(far[0]), 2.0 * math.pi / ANGLES[angles]
        likely = before[row] + math.remainder(after[row] - before[row], turn)
        ranges = " or ".join(f"from {low:.6g} to {low + turn:.6g}" for low in (-turn / 2.0, 0.0))
        raise InvalidFile(
            f"{file}: line {table.lines[row]}: angle_after: {after[row]:.6g} given, which differs from "
            f"angle_before by {after[row] - before[row]:.6g} {angles}; allowed: at most half a turn; write "
            f"{likely:.6g}, or wrap all angles to the range {ranges}; if they are in the other unit, "
            f"{remedy}"
        )


def _gap(table: PushTable, unit: str, outline: Outline, radius: float) -> float:
    """Median distance or overlap of finger and object after the pushes."""
    poses = table.of(COLUMNS["after"])
    places = rotate(table.of(COLUMNS["end"]) - poses[:, :2], -poses[:, 2] * ANGLES[unit])
    return float(np.median(np.abs(nearest_place(outline, places).gap - radius)))
