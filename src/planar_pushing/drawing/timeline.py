"""Data for pictures of motion over time: the plotted rows of a log, and runs of a mode."""

from __future__ import annotations

import json
import logging
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr
from pydantic import ValidationError

from planar_pushing.drawing.body import FLAT, Body, body_in
from planar_pushing.drawing.supports import Pose
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import LENGTH, RHO, sample_chain
from planar_pushing.mechanics.outline.entries import outline_of_entry
from planar_pushing.mechanics.outline.places import nearest_place
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.supports import Ring
from planar_pushing.terms.errors import InvalidFile, InvalidValue
from planar_pushing.terms.options import Shape
from planar_pushing.terms.quantities import describe, stop_text

LOG = logging.getLogger("planar_pushing")
#: Variables of a log that a picture shows, named path_* in the picture's data.
PATH = (
    "position",
    "pusher",
    "rod_angle",
    "slip",
    "gap",
    "force",
    "spin_ratio",
    "mode",
    "solutions",
)
#: Distance to which an endless side is drawn beyond the finger, in units of the slider's span.
BEYOND = 0.45
#: Points of a side on the fence differ in height by less, in units of the slider's size.
LEVEL = 1e-6
#: A longer step of the position of a force along a side between two rows, in units of the slider's size,
#: is a jump.
MOVES = 0.02
#: Speeds that differ by less count as equal.
ROUNDING = 1e-6
#: A pusher moves along the slider if the normal part of its velocity is a smaller part of its speed.
SIDEWAYS = 1e-9


class Run(NamedTuple):
    """Rows from `start` to `stop`, both included, with one chosen mode, with or without a flush side."""

    start: int
    stop: int
    mode: int
    several: bool
    flush: bool = False


def path_data(log: xr.Dataset) -> xr.Dataset:
    """Select the data that a picture of a log shows.

    Raises
    ------
    InvalidValue
        If the log is not a dataset.
    InvalidFile
        If the dataset is not a log, or is one of a scene that no scene file describes.
    """
    if not isinstance(log, xr.Dataset):
        raise InvalidValue("log", log, "a dataset returned by simulate", "call simulate first")
    missing = [name for name in (*PATH, "twist") if name not in log]
    try:
        slider, body = json.loads(log.attrs.get("scene", ""))["slider"], body_in(log)
    except ValidationError:
        raise InvalidFile(
            "the log is of a scene that no scene file describes, such as one with a support of your own "
            "class; allowed: the shapes of scene files; describe the support as a Composite of them"
        ) from None
    except (ValueError, TypeError, KeyError):
        missing.append("scene")
    if "contact" in log.dims:
        raise InvalidFile(
            "a log of several contacts; allowed: a log of one contact; plot its variables over time, or "
            "draw the scene file"
        )
    if missing:
        raise InvalidFile(
            f"the dataset lacks {', '.join(missing)}; allowed: a log of planar-pushing simulate; "
            "name another file"
        )
    data = log[list(PATH)].rename({name: f"path_{name}" for name in PATH})
    data["path_pusher_velocity"] = pusher_velocity(log)
    data["path_center"] = motion_center(log)
    for name in ("radius", "rod_length"):
        data[name] = ((), float(slider[name]), describe("length", name))
    data["radius"].attrs["long_name"] = "radius of the ring"
    data["rod_length"].attrs["long_name"] = "rod length, from the contact to the slider's center"
    if log.attrs.get("pusher_shape") == Shape.FINGER:
        if radius := float(log.attrs.get("pusher_radius", 0.0)):
            data["pusher_radius"] = ((), radius, describe("length", "radius of the finger"))
        entry = slider.get("outline")
        data["path_side"] = side_of(log, slider) if entry is None else touched_side(data, entry)
    elif "flush" in log:
        data["path_flush"], data["path_contact_position"] = log["flush"], log["contact_position"]
        data["corners"] = corners_of(slider)
    if "wall_point" in log:
        data["wall_point"], data["wall_normal"] = log["wall_point"], log["wall_normal"]
    data = data.drop_attrs(deep=False)
    if body != Body(support=Ring(float(slider["radius"]))):
        data["path_pivot"] = log["pivot"]
    return data.assign_attrs(scene=log.attrs["scene"], pusher=log.attrs.get("pusher", "[]"))


def announce_end(log: xr.Dataset) -> None:
    """Say where and why a log ends early: the run stopped, has been killed, or goes on."""
    if not log.attrs.get("finished", 1) and log.sizes["time"]:
        end, duration = float(log["time"][-1]), float(log.attrs["duration"])
        LOG.warning("the log is not finished: it ends at %.6g of %.6g", end, duration)
    if text := stop_text(log):
        LOG.warning(text)


def motion_center(log: xr.Dataset) -> xr.DataArray:
    """Position of the motion center; NaN for a slider that does not turn."""
    v_x, v_y, spin = np.moveaxis(log["twist"].values, -1, 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        offset = np.stack([-v_y, v_x], axis=-1) / spin[:, None]
    center = log["position"] + np.where(spin[:, None] == 0, np.nan, offset)
    center.attrs = describe("length", "motion center, from the contact at time 0")
    return center


def pusher_velocity(log: xr.Dataset) -> xr.DataArray:
    """Velocity of the pusher from each row to the next; at the last row, that from the row before."""
    steps, times = np.diff(log["pusher"].values, axis=0), np.diff(log["time"].values)
    with np.errstate(divide="ignore", invalid="ignore"):
        velocity = np.where(times[:, None] > 0, steps / times[:, None], 0.0)
    rows = np.minimum(np.arange(log.sizes["time"]), len(velocity) - 1)
    values = velocity[rows] if len(velocity) else np.zeros((log.sizes["time"], 2))
    attrs = describe("length/time", "velocity of the pusher")
    return xr.DataArray(values, dims=("time", "xy"), attrs=attrs)


def pusher_heading(data: xr.Dataset, row: int) -> int:
    """Sign of the pusher's velocity along the normal into the slider: 1 toward it, -1 away from it."""
    velocity = data["path_pusher_velocity"].values[row]
    into = normal(data)[row] if "path_side" in data else np.array([0.0, 1.0])
    along = float(velocity @ into)
    return 0 if abs(along) <= SIDEWAYS * float(np.hypot(*velocity)) else int(np.sign(along))


def pusher_action(data: xr.Dataset, row: int) -> str:
    """Words for the motion of the pusher at a row, and for the effect of a retreat on the slider."""
    mode, gap = int(data["path_mode"].values[row]), data["path_gap"].values
    if mode < 0:
        return "no consistent motion"
    if not np.any(data["path_pusher_velocity"].values[row]):
        return "stands still"
    noun = "ring" if body_in(data).is_ring else "slider"
    in_contact, after = mode != ContactMode.SEPARATE, min(row, len(gap) - 2) + 1
    heading = pusher_heading(data, row)
    if heading < 0:
        return f"retreats: the {noun} follows" if in_contact else "retreats: the contact parts"
    if heading == 0:
        return "moves along the fence" if "path_side" not in data else "moves along the side"
    if in_contact:
        return "pushes"
    return "approaches" if gap[after] < gap[after - 1] else "falls behind"


def impacts(log: xr.Dataset) -> list[int]:
    """Rows at which the slider's momentum jumps by more than the neighboring forces explain."""
    effects = {effect["type"]: effect for effect in json.loads(log.attrs["scene"])["effects"]}
    if "inertia" not in effects:
        return []
    mass = float(effects["inertia"]["mass"])
    weight = sum(float(effect.get("weight", 0.0)) for effect in effects.values())
    momentum = mass * np.hypot(*np.diff(_of_mass(log, effects["inertia"]), axis=0).T)
    force = np.hypot(*log["force"].values.T)
    largest = weight + np.maximum(force[1:], force[:-1])
    # A factor of two, for forces that change between two rows, and a margin for rounding.
    allowed = 2 * largest * np.diff(log["time"].values) + ROUNDING * mass
    return [int(row) + 1 for row in np.flatnonzero(momentum > allowed)]


def _of_mass(log: xr.Dataset, inertia: dict[str, Any]) -> Array:
    """Velocity of the center of mass."""
    arm = np.asarray(inertia.get("center", (0.0, 0.0)))
    angles = np.deg2rad(log["rod_angle"])
    turned = np.array([Pose((0.0, 0.0), angle).to_plane(arm) for angle in angles])
    v_x, v_y, spin = log["twist"].values.T
    return np.stack([v_x - spin * turned[:, 1], v_y + spin * turned[:, 0]], axis=-1)


def side_of(log: xr.Dataset, slider: dict[str, Any]) -> xr.DataArray:
    """Both ends of the side at every instant of a log: its real ends, or the drawn ends if it has none."""
    along = log["contact_position"].values
    beyond = BEYOND * (slider["rod_length"] + slider["radius"])
    first, last = map(float, slider.get("side", (-np.inf, np.inf)))
    ends = np.array([max(first, along.min() - beyond), min(last, along.max() + beyond)])
    if ends[0] == ends[1]:  # a corner, with the direction of the finger's tangent
        ends = ends + LEVEL * (slider["rod_length"] + slider["radius"]) * np.array([-1.0, 1.0])
    angle = np.deg2rad(log["rod_angle"].values)
    touched = log["position"].values - slider["rod_length"] * _unit(angle)
    tangent = _unit(angle - np.deg2rad(slider["rod_angle"]))
    positions = touched[:, None, :] + ends[None, :, None] * tangent[:, None, :]
    return xr.DataArray(
        positions, dims=("time", "end", "xy"), attrs=describe("length", "ends of the side")
    )


def touched_side(data: xr.Dataset, entry: Any) -> xr.DataArray:
    """Both ends of the side of an outline that is nearest to the finger at every row.

    On an arc and at a corner it is a short piece of the tangent.
    """
    outline = outline_of_entry(entry)
    x, y = (finger_center(data) - data["path_position"].values).T
    c, s = _unit(np.deg2rad(data["path_rod_angle"].values)).T
    places = nearest_place(outline, np.stack([c * x + s * y, c * y - s * x], axis=-1))
    rows, short = outline.pieces[places.piece], LEVEL * outline.size
    is_side = np.isinf(rows[:, RHO])
    start = np.where(is_side, -places.position, -short)
    end = np.where(is_side, rows[:, LENGTH] - places.position, short)
    on_body = (
        places.point[:, None]
        + np.stack([start, end], axis=-1)[..., None] * (places.tangent[:, None])
    )
    positions = _on_plane(data, on_body)
    return xr.DataArray(
        positions, dims=("time", "end", "xy"), attrs=describe("length", "ends of the side")
    )


def corners_of(slider: dict[str, Any]) -> xr.DataArray:
    """Points of a slider that can touch a fence, in the body frame: its contact, ends and corners.

    The points between two sides, which a fence reaches without a jump, have one number `wall`.
    """
    along = slider["side"] if slider.get("flush") else (0.0,)
    tangent = _unit(-np.deg2rad(slider["rod_angle"]))
    ends = np.multiply.outer(along, tangent) - (slider["rod_length"], 0.0)
    points, walls = ends, -2 - np.arange(len(ends))
    if (entry := slider.get("outline")) is not None:
        outline = outline_of_entry(entry).exterior
        drawn, numbers = _walls_of(outline)
        apart = np.hypot(*np.moveaxis(ends[:, None] - drawn, -1, 0))
        on_side = np.isinf(outline.pieces[nearest_place(outline, ends).piece, RHO])
        is_inner = on_side & (apart.min(axis=1) > LEVEL * outline.size)
        walls = np.where(is_inner, walls, numbers[apart.argmin(axis=1)])
        points, walls = np.concatenate([ends, drawn]), np.concatenate([walls, numbers])
    differ = np.hypot(*np.moveaxis(points[:, None] - points, -1, 0)) > LEVEL * np.ptp(points)
    is_new = np.triu(~differ, 1).sum(axis=0) == 0  # a point that is listed again is one point
    names = describe("length", "points that can touch the fence, in the body frame")
    return xr.DataArray(
        points[is_new], dims=("corner", "xy"), attrs=names,
        coords={"wall": ("corner", walls[is_new])},
    )  # fmt: skip


def _walls_of(outline: Outline) -> tuple[Array, npt.NDArray[np.intp]]:
    """Vertices of the exterior, shape (n, 2), and the numbers of their walls between two sides."""
    is_side = np.isinf(outline.pieces[:, RHO])
    walls = (np.cumsum(is_side) - is_side) % max(int(is_side.sum()), 1)
    parts = [
        (sample_chain(piece[None], FLAT * outline.size), wall)
        for piece, wall in zip(outline.pieces, walls, strict=True)
        if piece[RHO]
    ]
    counts = [len(points) for points, _ in parts]
    return np.concatenate([points for points, _ in parts]), np.repeat(
        [wall for _, wall in parts], counts
    )


def _unit(angle: Array) -> Array:
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def contact(data: xr.Dataset) -> Array:
    """Position of the contact at every row.

    It is the finger's point nearest the side, or the point of the fence at which its force acts; without a
    force, the slider's point nearest the fence. Without an outline this is always the rod's end.
    """
    if "path_flush" in data:
        return _contact_on_fence(data)
    if "path_side" not in data:
        return rod_end(data)
    return finger_center(data) + finger_radius(data) * normal(data)


def _contact_on_fence(data: xr.Dataset) -> Array:
    """Point of the fence at which the force acts at every row, or the slider's nearest point."""
    along, positions = data["path_contact_position"].values, corner_positions(data)
    nearest = positions[np.arange(len(positions)), np.argmin(positions[..., 1], axis=1)]
    on_fence = data["path_pusher"].values + np.stack([along, np.zeros(len(along))], axis=-1)
    return np.asarray(np.where(np.isnan(along)[:, None], nearest, on_fence))


def corner_positions(data: xr.Dataset) -> Array:
    """Points of the slider that can touch the fence at every row, shape (time, corner, 2)."""
    return _on_plane(data, data["corners"].values)


def _on_plane(data: xr.Dataset, points: Array) -> Array:
    """Points of the body, shape (count, 2) or (time, count, 2), in the plane at every row."""
    angle = np.deg2rad(data["path_rod_angle"].values)
    ahead, across = _unit(angle)[:, None], _unit(angle + np.pi / 2)[:, None]
    turned = points[..., :1] * ahead + points[..., 1:] * across
    return np.asarray(data["path_position"].values[:, None] + turned)


def touching_wall(data: xr.Dataset) -> Array:
    """Number of the slider's wall that is the contact at every row; -1 for a side on the fence."""
    if "path_flush" not in data:
        return np.zeros(data.sizes["time"], dtype=int)
    from_contact = corner_positions(data) - contact(data)[:, None]
    nearest = np.argmin(np.hypot(*np.moveaxis(from_contact, -1, 0)), axis=1)
    return np.where(data["path_flush"].values, -1, data["wall"].values[nearest])


def is_at_first_contact(data: xr.Dataset, row: int) -> bool:
    """Whether the fence touches the slider at the rod's end, or along the side, as at the start."""
    if "path_flush" not in data:
        return True
    flush = data["path_flush"].values
    size = float(np.ptp(data["corners"].values, axis=0).max())
    away = contact(data)[row] - rod_end(data)[row]
    return bool(flush[row] if flush[0] else not flush[row] and np.hypot(*away) <= LEVEL * size)


def contact_jumps(data: xr.Dataset) -> Any:
    """Rows at which the contact is not where it was in the slider: at another point, or along a side."""
    if "path_flush" not in data:
        return np.empty(0, dtype=int)
    point, arm = touching_wall(data), contact(data) - data["path_position"].values
    size = float(np.ptp(corner_positions(data)[0], axis=0).max())
    along = (point[1:] == -1) & (np.hypot(*np.diff(arm, axis=0).T) > MOVES * size)
    return np.asarray(np.flatnonzero((np.diff(point) != 0) | along) + 1)


def side_on_fence(data: xr.Dataset, row: int) -> Array | None:
    """Ends of the side that lies on the fence at a row, shape (2, 2); None without one."""
    if "path_flush" not in data or not data["path_flush"].values[row]:
        return None
    positions = corner_positions(data.isel(time=[row]))[0]
    height = positions[:, 1] - positions[:, 1].min()
    on_fence = positions[height <= LEVEL * float(np.ptp(positions, axis=0).max())]
    return np.asarray(on_fence[[np.argmin(on_fence[:, 0]), np.argmax(on_fence[:, 0])]])


def finger_radius(data: xr.Dataset) -> float:
    """Radius of the finger; 0 for a point."""
    return float(data["pusher_radius"]) if "pusher_radius" in data else 0.0


def finger_center(data: xr.Dataset) -> Array:
    """Position of the finger's center at every row."""
    return np.asarray(data["path_pusher"].values - (0.0, finger_radius(data)))


def normal(data: xr.Dataset) -> Array:
    """Normal of the side into the slider at every row."""
    along = np.diff(data["path_side"].values, axis=-2)[..., 0, :]
    x, y = np.moveaxis(along / np.hypot(along[..., :1], along[..., 1:]), -1, 0)
    return np.stack([-y, x], axis=-1)


def rod_end(data: xr.Dataset) -> Array:
    """Position of the rod's free end at every row; a finger touches it at time 0."""
    angle = np.deg2rad(data["path_rod_angle"].values)
    toward = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    return np.asarray(data["path_position"].values - float(data["rod_length"]) * toward)


def runs(data: xr.Dataset) -> Iterator[Run]:
    """Time intervals with one chosen mode, split where a choice begins or ends."""
    modes, several = data["path_mode"].values, data["path_solutions"].values > 1
    flush = data["path_flush"].values if "path_flush" in data else np.zeros(len(modes), dtype=bool)
    key = 4 * modes.astype(int) + 2 * several + flush
    starts = np.flatnonzero(np.diff(key, prepend=key[0] - 1))
    stops = [*starts[1:], len(key) - 1]
    for start, stop in zip(starts, stops, strict=True):
        yield Run(
            int(start), int(stop), int(modes[start]), bool(several[start]), bool(flush[start])
        )


def is_pivot(data: xr.Dataset, row: int) -> bool:
    """Whether the slider pivots about a support point at a row."""
    return "path_pivot" in data and bool(data["path_pivot"].values[row] >= 0)


def pivots(data: xr.Dataset) -> Iterator[Run]:
    """Time intervals, longer than an instant, in which the slider pivots about one support point."""
    if "path_pivot" not in data:
        return
    points = data["path_pivot"].values
    starts = np.flatnonzero(np.diff(points, prepend=points[0] - 1))
    stops = [*(starts[1:] - 1), len(points) - 1]
    for start, stop in zip(starts, stops, strict=True):
        if points[start] >= 0 and stop > start:
            yield Run(int(start), int(stop), int(data["path_mode"].values[start]), False)


def rows(data: xr.Dataset, count: int) -> list[int]:
    """Rows nearest to evenly spaced instants, both ends included."""
    time = data["time"].values
    return rows_at(data, np.linspace(time[0], time[-1], count))


def rows_at(data: xr.Dataset, instants: Iterable[float]) -> list[int]:
    """Rows nearest to instants, in the order of time."""
    time = data["time"].values
    return sorted({int(np.argmin(np.abs(time - instant))) for instant in instants})


def key_rows(data: xr.Dataset, impact_rows: Sequence[int] = ()) -> list[int]:
    """Three rows that tell the motion: the first, the first impact or else the middle, and the last."""
    ends = {0, data.sizes["time"] - 1}
    inner = next(
        (row for row in impact_rows if row not in ends), rows(data, 3)[len(rows(data, 3)) // 2]
    )
    return sorted({*ends, inner})
