"""The command `identify`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from planar_pushing.commands.words import (
    Commands,
    add_output,
    add_pushes,
    chosen_pushes,
    command,
    require_ending,
    require_seed,
    table,
    text,
)
from planar_pushing.terms.errors import InvalidFile, InvalidValue, require_positive, suggestion

if TYPE_CHECKING:
    import xarray as xr

    from planar_pushing.pushes.identified import Identified

#: Families of supports: name and help.
FAMILIES = {
    "points": "a weight at each point of a grid",
    "uniform_and_corners": "a uniform pressure, and a weight at each corner",
    "ellipse": "uniform pressures within ellipses",
    "map": "a pressure interpolated linearly between points of a grid",
}
ENDINGS = (".yaml", ".yml")
#: Merged feet that keep less than these fractions of spin torque and weight belong to a patch.
SPIN, WEIGHT = 0.9, 0.75


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = (
        "Identify the support of an object from measured pushes, and write it as a scene file. The 90 "
        "percent intervals come from resampled pushes."
    )
    sub = command(commands, "identify", identified, about, "pushes.nc -o support.yaml")
    sub.values = {"--family": tuple(FAMILIES)}
    add_pushes(sub, several=False)
    sub.add_argument(
        "--outline", type=Path, metavar="OUTLINE.yaml",
        help="YAML file of the object's corners, [[x, y], ...], or a scene file with object.outline "
        "(default: the outline of the dataset)",
    )  # fmt: skip
    sub.add_argument(
        "--spacing", type=float, metavar="NUMBER",
        help="distance between candidate points, in the dataset's unit of length, > 0 (default: 1/15 of "
        "the outline's extent with forces, 1/5 without, and larger if there are few pushes)",
    )  # fmt: skip
    listed = "; ".join(f"{name}: {each}" for name, each in FAMILIES.items())
    sub.add_argument(
        "--family", default="points", metavar="NAME", help=f"{listed} (default: points)"
    )
    add_output(sub, "SUPPORT.yaml", f"output scene file; its name ends in {' or '.join(ENDINGS)}")


def identified(args: argparse.Namespace) -> dict[str, Any]:
    """Identify the support, write the scene file, and report the results."""
    require_ending(args.output, ENDINGS)
    seed = require_seed(args.seed)
    if args.family not in FAMILIES:
        remedy = suggestion(args.family, FAMILIES, "name one of these families")
        raise InvalidValue("family", args.family, ", ".join(FAMILIES), remedy)
    if args.spacing is not None:
        require_positive("spacing", args.spacing, "give a distance in the dataset's unit of length")
    pushes = _pushes(args)
    from planar_pushing.pushes.identify import identify
    from planar_pushing.pushes.scene_file import save_support

    found = identify(
        pushes, spacing=args.spacing, family=args.family, seed=seed, progress=sys.stderr.isatty()
    )
    save_support(found, pushes, args.output)
    told = {"written": str(args.output)} | summary(found, pushes)
    return told if args.json else {"": lines(told)}


def _pushes(args: argparse.Namespace) -> xr.Dataset:
    """The pushes of one object, with the outline from the given file, if any."""
    pushes = chosen_pushes(args)
    names = [str(each) for each in pushes["object"].values]
    if len(names) > 1:
        raise InvalidValue("object", None, ", ".join(names), "name one of them with --object")
    return pushes if args.outline is None else _with_outline(pushes, args.outline)


def _with_outline(pushes: xr.Dataset, path: Path) -> xr.Dataset:
    """The pushes with the outline from a file; their contacts must lie on it."""
    from planar_pushing.pushes.logs.combine import with_outline
    from planar_pushing.scenes.yaml_text import read_yaml

    content = read_yaml(path)
    if isinstance(content, dict):
        held = content.get("object")
        content = held.get("outline") if isinstance(held, dict) else None
    if content is None:
        allowed = "a list of corners [x, y], or a scene file with object.outline"
        raise InvalidFile(f"{path}: holds no outline; allowed: {allowed}; choose another file")
    try:
        return with_outline(pushes, content)
    except InvalidValue as error:
        raise InvalidFile(f"{path}: {error}") from None


def summary(found: Identified, pushes: xr.Dataset) -> dict[str, Any]:
    """Numbers of a support as plain values; unknown numbers are None."""
    return {
        "object": str(pushes["object"].values[0]),
        "pushes": pushes.sizes["push"],
        "units": _units(pushes),
        "weight": _number(found.weight),
        "contact_friction": _number(found.contact_friction),
        "center_of_pressure": [float(each) for each in found.center_of_pressure],
        "spin_torque": float(found.spin_torque),
        "intervals": {
            name: [_number(end) for end in each] for name, each in found.intervals.items()
        },
        "points": len(found.support.positions),
        "feet": _feet(found),
        "optimality": float(found.optimality),
        "residual": (residuals := _residuals(found, pushes)),
        "in_a_facet": int((found.facet >= 0).sum()) if "wrench" in residuals else None,
        "undetermined": list(found.undetermined),
    }


def _units(pushes: xr.Dataset) -> dict[str, str]:
    length = str(pushes["contact"].attrs["units"])
    force = {"force": str(pushes["force"].attrs["units"])} if "force" in pushes else {}
    return {"length": length} | force


def _number(value: float) -> float | None:
    """A number, or None for NaN."""
    return float(value) if value == value else None


def _feet(found: Identified) -> list[list[float]] | None:
    """(x, y, fraction) of each merged foot; None if the points form a patch."""
    import numpy as np

    from planar_pushing.pushes.identified import moments_of

    places, shares = np.array(found.feet.positions), np.array(found.feet.weights)
    spins = moments_of(places, shares)[1] >= SPIN * found.spin_torque
    if not spins or shares.sum() < WEIGHT * sum(found.support.weights):
        return None
    shares = shares / shares.sum()
    return [[float(x), float(y), float(each)] for (x, y), each in zip(places, shares, strict=True)]


def _residuals(found: Identified, pushes: xr.Dataset) -> dict[str, float]:
    """Median residuals of the wrenches, in standard deviations, and of the final poses, as a length."""
    import numpy as np

    nothing = np.zeros(len(found.residuals), bool)
    forced = pushes["force"].notnull().all("xy").values if "force" in pushes else nothing
    used = np.isfinite(found.residuals)
    parts = {"wrench": forced & used, "pose": ~forced & used}
    return {
        name: float(np.median(found.residuals[rows])) for name, rows in parts.items() if rows.any()
    }


def lines(told: dict[str, Any]) -> str:
    """Format the numbers as lines and tables, with a line for each undetermined quantity."""
    length, force = told["units"]["length"], told["units"].get("force", "")
    units = {"wrench": "standard deviations", "pose": length}
    assumed = told["weight"] is None
    found: dict[str, Any] = {
        "written": told["written"],
        "object": told["object"],
        "pushes": told["pushes"],
        "points": told["points"],
        "optimality": f"{told['optimality']:.1e}",
        **{
            f"residual_of_{name} [{units[name]}]": f"{each:.4g}"
            for name, each in told["residual"].items()
        },
    }
    if told["in_a_facet"] is not None:
        found["in_a_facet"] = f"{told['in_a_facet']} of {told['pushes']} pushes"
    noted = [f"undetermined: {each}" for each in told["undetermined"]]
    noted += [f"weight: 1 in {told['written']}, since no force was measured"] if assumed else []
    return "\n".join([text(found), _table(told, length, force), *_footlines(told, length), *noted])


def _table(told: dict[str, Any], length: str, force: str) -> str:
    """Table with a row for each quantity: its value and the ends of its interval."""
    names = ("quantity", "value", "5 %", "95 %")
    x, y = told["center_of_pressure"]
    values = {
        "weight": (told["weight"], force),
        "contact_friction": (told["contact_friction"], ""),
        "center_of_pressure_x": (x, length),
        "center_of_pressure_y": (y, length),
        "spin_torque": (told["spin_torque"], length),
    }
    rows = [
        (f"{name} [{unit}]" if unit else name, *map(_word, (value, *told["intervals"][name])))
        for name, (value, unit) in values.items()
        if value is not None
    ]
    return table([dict(zip(names, row, strict=True)) for row in rows])


def _footlines(told: dict[str, Any], length: str) -> list[str]:
    """Table with a row for each foot, or one line if there are none."""
    if told["feet"] is None:
        return ["feet: none; neighboring points form a patch"]
    names = (f"foot_x [{length}]", f"foot_y [{length}]", "fraction")
    return [table([dict(zip(names, map(_word, foot), strict=True)) for foot in told["feet"]])]


def _word(value: float | None) -> str:
    return "none" if value is None else f"{value:.4g}"
