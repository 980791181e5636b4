"""The dataset of pushes: its variables, and `require_pushes`, which checks a dataset."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.mechanics.outline import (
    Outline,
    outline_of_corners,
    require_outline,
)
from planar_pushing.mechanics.outline.chains import Piece
from planar_pushing.mechanics.outline.drawing import Corners
from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.logs import checks
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import as_array

#: Labels of vector components.
XY = ["x", "y"]
#: Default units of the quantities of `Variable`; the unit of length has no default.
UNITS = {
    "degree": "degree", "force": "N", "time": "s", "1": "1", "mass": "kg",
    "piece": "that of outline, and radian",
}  # fmt: skip
#: Attributes of the dataset: standard deviations of the measurements, and the relative variation of
#: friction from one push to the next.
MEASURED_NOISE = ("position_noise", "angle_noise", "force_noise")
NOISE = (*MEASURED_NOISE, "friction_noise")
#: Attributes that a dataset of pushes keeps.
ATTRIBUTES = ("source", *NOISE, "left_out")


#: Variables that store outlines.
OUTLINE = ("outline", "outline_pieces")


class Variable(NamedTuple):
    """A variable of the schema.

    `quantity` is "length", "degree", "force", "time", "mass", "piece" or "1"; a `complete` variable has no
    missing values.
    """

    dims: tuple[str, ...]
    quantity: str
    long_name: str
    required: bool = True
    complete: bool = True


#: All variables except `pushed`, the name of the object of each push.
VARIABLES: dict[str, Variable] = {
    "outline": Variable(
        ("object", "corner", "xy"), "length", "corners of the object, counterclockwise", complete=False
    ),
    "outline_pieces": Variable(
        ("object", "piece", "column"), "piece",
        "sides, arcs and corners of an object with arcs or holes, as in Outline.pieces", False, False,
    ),
    "feet": Variable(("object", "foot", "xy"), "length", "positions of the feet", False, False),
    "foot_weight": Variable(("object", "foot"), "1", "fraction of the load on each foot", False, False),
    "center_of_mass": Variable(("object", "xy"), "length", "center of mass", False, False),
    "mass": Variable(("object",), "mass", "mass of the object", False, False),
    "contact": Variable(("push", "xy"), "length", "point of first touch"),
    "normal": Variable(("push", "xy"), "1", "unit normal at the first touch, into the object"),
    "finger_displacement": Variable(
        ("push", "xy"), "length", "displacement of the finger's center since the first touch"
    ),
    "finger_path": Variable(
        ("push", "sample", "xy"), "length",
        "displacement of the finger's center since the first touch, over time", False, False,
    ),
    "path_time": Variable(("push", "sample"), "time", "time since the first touch", False, False),
    "finger_radius": Variable(("push",), "length", "radius of the finger"),
    "displacement": Variable(("push", "xy"), "length", "displacement of the origin of the object's frame"),
    "rotation": Variable(("push",), "degree", "rotation of the object, counterclockwise"),
    "force": Variable(
        ("push", "xy"), "force",
        "mean force of the finger on the object, along the object's axes, which turn with it",
        False, False,
    ),
}  # fmt: skip


def require_pushes(dataset: Any, rows: Any = None) -> xr.Dataset:
    """Return a canonical copy of a dataset of pushes, or raise a one-line error.

    Parameters
    ----------
    dataset : xarray.Dataset
        Dataset with the variables of the schema; all vectors of a push are in the object's frame before
        the push.
    rows : array_like of int, shape (n,), optional
        Numbers of the pushes in messages; by default counted from 0.

    Returns
    -------
    xarray.Dataset
        Loaded into memory, with numbers in double precision, counterclockwise outlines, and units and long
        names for all variables. For an object with arcs, `outline` is a polygon on its outline. Additional
        variables over `push` or `object` are kept.

    Raises
    ------
    InvalidValue
        If a variable is missing or has other dimensions, a value is missing, or the pushes are impossible
        for their objects; see `planar_pushing.pushes.logs.checks`.
    """
    if not isinstance(dataset, xr.Dataset):
        raise InvalidValue(
            "pushes", type(dataset).__name__, "a dataset of pushes",
            "read one with load_pushes, or make one with pushes_from_poses",
        )  # fmt: skip
    _require_variables(dataset)
    units = _units(dataset)
    names = _object_names(dataset)
    coords: dict[str, Any] = {
        "object": ("object", names, {"long_name": "name of the object"}),
        "xy": ("xy", XY),
    }
    variables: dict[str, Any] = {
        "pushed": (
            "push",
            _object_of_push(dataset, names),
            {"long_name": "name of the object that is pushed"},
        )
    }
    for name, variable in VARIABLES.items():
        if name in dataset:
            attributes = {"units": units[variable.quantity], "long_name": variable.long_name}
            variables[name] = variable.dims, _numbers(dataset, name), attributes
    outlines = _outlines(variables, names)
    about = {name: variables.pop(name)[2] for name in OUTLINE if name in variables}
    variables |= {
        name: (VARIABLES[name].dims, array, about[name])
        for name, array in outline_arrays(outlines).items()
    }
    variables = {name: variables[name] for name in ("pushed", *VARIABLES) if name in variables}
    if "outline_pieces" in variables:
        coords["column"] = ("column", list(Piece._fields))
    others = {
        str(name): dataset[name].load()
        for name in dataset.data_vars
        if name not in (*variables, *OUTLINE) and {"push", "object"} & set(dataset[name].dims)
    }
    kept = {key: dataset.attrs[key] for key in ATTRIBUTES if key in dataset.attrs}
    pushes = xr.Dataset(variables | others, coords, {"source": ""} | kept)
    checks.require_consistent(pushes, dict(zip(names, outlines, strict=True)), rows)
    return pushes


def outline_of(pushes: xr.Dataset, name: str) -> Outline:
    """The outline of an object of checked pushes."""
    return _outline(
        *(
            without_padding(pushes[key].sel(object=name).values)
            if key in pushes
            else np.zeros((0, 2))
            for key in OUTLINE
        )
    )


def outline_arrays(outlines: list[Outline]) -> dict[str, Array]:
    """Variables that store outlines: polygons, and pieces of those that are not given by their corners."""
    arrays = {"outline": pad([outline.vertices() for outline in outlines])}
    none = np.zeros((0, len(Piece._fields)))
    pieces = [none if outline.corners else np.array(outline.pieces) for outline in outlines]
    return arrays | ({"outline_pieces": pad(pieces)} if any(map(len, pieces)) else {})


def _outline(corners: Array, pieces: Array) -> Outline:
    """The outline of pieces, or else of corners as they were read."""
    return Outline.from_pieces(pieces) if len(pieces) else outline_of_corners(Corners.of(corners))


def without_padding(places: Array) -> Array:
    """Positions of shape (n, 2) without rows of NaN at the end."""
    empty = np.asarray(np.isnan(places).all(axis=1))
    return places[: len(places) - int(empty[::-1].cumprod().sum())]


def pad(arrays: list[Array]) -> Array:
    """Arrays of different lengths as one array, with NaN after the shorter ones."""
    longest = max(map(len, arrays), default=0)
    array = np.full((len(arrays), longest, *np.shape(arrays[0])[1:]), np.nan)
    for row, part in zip(array, arrays, strict=True):
        row[: len(part)] = part
    return array


def _require_variables(dataset: xr.Dataset) -> None:
    """Refuse a dataset with missing variables or wrong dimensions."""
    missing = [name for name in ("pushed", *VARIABLES) if name not in dataset]
    missing = [name for name in missing if name == "pushed" or VARIABLES[name].required]
    if "finger_path" in dataset and "path_time" not in dataset:
        missing.append("path_time")
    if missing and {"time", "rod_angle", "twist"} <= set(dataset.variables):
        raise InvalidValue(
            "pushes", "a log of simulate, the motion in one push over time", "one entry for each push",
            "make them with simulate_pushes, pushes_from_poses or planar-pushing convert",
        )  # fmt: skip
    if missing:
        raise InvalidValue(
            "pushes", f"a dataset without {', '.join(missing)}", "one with every required variable",
            "make it with pushes_from_poses, or add the variable",
        )  # fmt: skip
    dims = {"pushed": ("push",)} | {name: variable.dims for name, variable in VARIABLES.items()}
    for name in dims.keys() & dataset.variables.keys():
        if set(dataset[name].dims) != set(dims[name]):
            shape = f"dimensions {tuple(map(str, dataset[name].dims))}"
            raise InvalidValue(name, shape, f"dimensions {dims[name]}", "rename the dimensions")
    if dataset.sizes["xy"] != 2 or ("xy" in dataset.coords and list(dataset["xy"].values) != XY):
        raise InvalidValue(
            "xy", dataset["xy"].values.tolist(), "x, y", "give both components of vectors"
        )
    if not dataset.sizes["push"]:
        raise InvalidValue("pushes", "no push", "at least one push", "add the measured pushes")


def _units(dataset: xr.Dataset) -> dict[str, str]:
    """Unit of each quantity, which must be the same for all its variables."""
    units: dict[str, tuple[str, str]] = {}
    for name, variable in VARIABLES.items():
        unit = dataset[name].attrs.get("units") if name in dataset else None
        if unit is None:
            continue
        first, known = units.setdefault(variable.quantity, (name, str(unit)))
        if str(unit) != known:
            raise InvalidValue(
                "units", f"{name} in {unit}, {first} in {known}", f"one unit of {variable.quantity}",
                "convert one of them",
            )  # fmt: skip
    if "length" not in units:
        raise InvalidValue(
            "units", None, "a name such as mm", "set the attribute units of the variable outline"
        )
    if units.get("degree", ("", "degree"))[1] not in ("degree", "degrees", "deg"):
        raise InvalidValue(
            "units", f"rotation in {units['degree'][1]}", "degree", "convert the angles"
        )
    return UNITS | {key: unit for key, (_, unit) in units.items()} | {"degree": "degree"}


def _object_names(dataset: xr.Dataset) -> list[str]:
    """Names of the objects, which must all be different."""
    names = [str(label) for label in dataset["object"].values] if "object" in dataset.coords else []
    if not names or len(set(names)) < len(names) or not all(names):
        raise InvalidValue("object", names, "a name for each object", "set the coordinate object")
    return names


def _object_of_push(dataset: xr.Dataset, names: list[str]) -> Array:
    """Name of the object of each push."""
    pushed = [str(label) for label in dataset["pushed"].values]
    unknown = sorted(set(pushed) - set(names))
    if unknown:
        raise InvalidValue("pushed", unknown[0], ", ".join(names), "name an object of the dataset")
    return np.array(pushed, dtype=object)


def _numbers(dataset: xr.Dataset, name: str) -> Array:
    """Values of a variable in double precision, in the order of its dimensions."""
    variable = VARIABLES[name]
    values = as_array(dataset[name].transpose(*variable.dims).values)
    if values is None:
        raise InvalidValue(name, str(dataset[name].dtype), "numbers", "give floats")
    bad = np.asarray(~np.isfinite(values) if variable.complete else np.isinf(values))
    # The radius of curvature of a side is infinite.
    bad &= name != "outline_pieces"
    if bad.any():
        where = f"{variable.dims[0]} {int(np.nonzero(bad)[0][0])}"
        raise InvalidValue(
            name,
            f"{values[np.nonzero(bad)][0]} of {where}",
            "finite numbers",
            "leave out pushes that were not measured",
        )
    return values + 0.0


def _outlines(variables: dict[str, Any], names: list[str]) -> list[Outline]:
    """Outlines of the objects, or the error for the first that is invalid."""
    corners = variables["outline"][1]
    pieces = variables["outline_pieces"][1] if "outline_pieces" in variables else [()] * len(names)
    outlines = []
    for name, vertices, rows in zip(names, corners, pieces, strict=True):
        rows = without_padding(np.reshape(rows, (-1, len(Piece._fields))))
        try:
            if len(rows):
                outlines.append(Outline.from_pieces(rows))
            else:
                outlines.append(require_outline(without_padding(vertices)))
        except InvalidValue as error:
            raise InvalidValue(
                f"outline of {name}", error.given, error.allowed, error.remedy
            ) from None
    return outlines
