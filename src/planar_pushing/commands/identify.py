"""The command `identify`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from planar_pushing.commands.words import (
    OUTLINE,
    Commands,
    add_output,
    add_pushes,
    chosen_pushes,
    command,
    missing_value,
    read_outline,
    require_ending,
    require_seed,
    table,
    text,
)
from planar_pushing.terms.errors import InvalidFile, InvalidValue, require_name, require_positive

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
    sub = command(commands, "identify", write_support, about, "pushes.nc -o support.yaml")
    sub.values = {"--family": tuple(FAMILIES)}
    add_pushes(sub, several=False)
    sub.add_argument(
        "--outline", type=Path, metavar="OUTLINE.yaml",
        help=f"{OUTLINE} (default: the outline of the dataset)",
    )  # fmt: skip
    sub.add_argument(
        "--spacing", type=float, metavar="NUMBER",
        help="distance between candidate points, in the dataset's unit of length, > 0 (default: 1/15 of "
        "the outline's extent with forces, 1/5 without, and larger if there are few pushes)",
    )  # fmt: skip
    listed = "; ".join(f"{name}: {about}" for name, about in FAMILIES.items())
    sub.add_argument(
        "--family", default="points", metavar="NAME", help=f"{listed} (default: points)"
    )
    add_output(sub, "SUPPORT.yaml", f"output scene file; its name ends in {' or '.join(ENDINGS)}")


def write_support(args: argparse.Namespace) -> dict[str, Any]:
    """Identify the support, write the scene file, and report the results."""
    require_ending(args.output, ENDINGS)
    seed = require_seed(args.seed)
    require_name("family", args.family, FAMILIES, "name one of these families")
    if args.spacing is not None:
        require_positive("spacing", args.spacing, "give a distance in the dataset's unit of length")
    pushes = _pushes(args)
    from planar_pushing.pushes.identify import identify
    from planar_pushing.pushes.scene_file import save_support

    support = identify(
        pushes, spacing=args.spacing, family=args.family, seed=seed, progress=sys.stderr.isatty()
    )
    save_support(support, pushes, args.output)
    entries = {"written": str(args.output)} | summary(support, pushes)
    return entries if args.json else {"": lines(entries)}


def _pushes(args: argparse.Namespace) -> xr.Dataset:
    """The pushes of one object, with the outline from the given file, if any."""
    pushes = chosen_pushes(args)
    names = [str(label) for label in pushes["object"].values]
    if len(names) > 1:
        raise missing_value("object", ", ".join(names), "name one of them with --object")
    return pushes if args.outline is None else _with_outline(pushes, args.outline)


def _with_outline(pushes: xr.Dataset, path: Path) -> xr.Dataset:
    """The pushes with the outline from a file; their contacts must lie on it."""
    from planar_pushing.pushes.logs.combine import with_outline

    try:
        return with_outline(pushes, read_outline(path))
    except InvalidValue as error:
        raise InvalidFile(f"{path}: {error}") from None


def summary(support: Identified, pushes: xr.Dataset) -> dict[str, Any]:
    """Numbers of a support as plain values; unknown numbers are None."""
    return {
        "object": str(pushes["object"].values[0]),
        "pushes": pushes.sizes["push"],
        "units": _units(pushes),
        "weight": _number(support.weight),
        "contact_friction": _number(support.contact_friction),
        "center_of_pressure": [float(coordinate) for coordinate in support.center_of_pressure],
        "spin_torque": float(support.spin_torque),
        "intervals": {
            name: [_number(end) for end in ends] for name, ends in support.intervals.items()
        },
        "points": len(support.support.positions),
        "feet": _feet(support),
        "optimality": float(support.optimality),
        "residual": (residuals := _residuals(support, pushes)),
        "in_a_facet": int((support.facet >= 0).sum()) if "wrench" in residuals else None,
        "undetermined": list(support.undetermined),
    }


def _units(pushes: xr.Dataset) -> dict[str, str]:
    length = str(pushes["contact"].attrs["units"])
    force = {"force": str(pushes["force"].attrs["units"])} if "force" in pushes else {}
    return {"length": length} | force


def _number(value: float) -> float | None:
    """A number, or None for NaN."""
    return float(value) if value == value else None


def _feet(support: Identified) -> list[list[float]] | None:
    """(x, y, fraction) of each merged foot; None if the points form a patch."""
    import numpy as np

    from planar_pushing.pushes.identified import moments_of

    places, shares = np.array(support.feet.positions), np.array(support.feet.weights)
    spins = moments_of(places, shares)[1] >= SPIN * support.spin_torque
    if not spins or shares.sum() < WEIGHT * sum(support.support.weights):
        return None
    shares = shares / shares.sum()
    return [
        [float(x), float(y), float(share)] for (x, y), share in zip(places, shares, strict=True)
    ]


def _residuals(support: Identified, pushes: xr.Dataset) -> dict[str, float]:
    """Median residuals of the wrenches, in standard deviations, and of the final poses, as a length."""
    import numpy as np

    nothing = np.zeros(len(support.residuals), bool)
    forced = pushes["force"].notnull().all("xy").values if "force" in pushes else nothing
    used = np.isfinite(support.residuals)
    parts = {"wrench": forced & used, "pose": ~forced & used}
    return {
        name: float(np.median(support.residuals[rows]))
        for name, rows in parts.items()
        if rows.any()
    }


def lines(entries: dict[str, Any]) -> str:
    """Format the numbers as lines and tables, with a line for each undetermined quantity."""
    length, force = entries["units"]["length"], entries["units"].get("force", "")
    units = {"wrench": "standard deviations", "pose": length}
    assumed = entries["weight"] is None
    numbers: dict[str, Any] = {
        "written": entries["written"],
        "object": entries["object"],
        "pushes": entries["pushes"],
        "points": entries["points"],
        "optimality": f"{entries['optimality']:.1e}",
        **{
            f"residual_of_{name} [{units[name]}]": f"{residual:.4g}"
            for name, residual in entries["residual"].items()
        },
    }
    if entries["in_a_facet"] is not None:
        numbers["in_a_facet"] = f"{entries['in_a_facet']} of {entries['pushes']} pushes"
    noted = [f"undetermined: {sentence}" for sentence in entries["undetermined"]]
    noted += [f"weight: 1 in {entries['written']}, since no force was measured"] if assumed else []
    return "\n".join(
        [text(numbers), _table(entries, length, force), *_footlines(entries, length), *noted]
    )


def _table(entries: dict[str, Any], length: str, force: str) -> str:
    """Table with a row for each quantity: its value and the ends of its interval."""
    names = ("quantity", "value", "5 %", "95 %")
    x, y = entries["center_of_pressure"]
    values = {
        "weight": (entries["weight"], force),
        "contact_friction": (entries["contact_friction"], ""),
        "center_of_pressure_x": (x, length),
        "center_of_pressure_y": (y, length),
        "spin_torque": (entries["spin_torque"], length),
    }
    rows = [
        (f"{name} [{unit}]" if unit else name, *map(_word, (value, *entries["intervals"][name])))
        for name, (value, unit) in values.items()
        if value is not None
    ]
    return table([dict(zip(names, row, strict=True)) for row in rows])


def _footlines(entries: dict[str, Any], length: str) -> list[str]:
    """Table with a row for each foot, or one line if there are none."""
    if entries["feet"] is None:
        return ["feet: none; neighboring points form a patch"]
    names = (f"foot_x [{length}]", f"foot_y [{length}]", "fraction")
    return [table([dict(zip(names, map(_word, foot), strict=True)) for foot in entries["feet"]])]


def _word(value: float | None) -> str:
    return "none" if value is None else f"{value:.4g}"
