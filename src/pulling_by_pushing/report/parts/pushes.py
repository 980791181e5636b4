"""The numbers of the part on measured pushes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pulling_by_pushing.report.quantities import Numbers, Quantity
from pulling_by_pushing.report.results import Results

#: Sections of the file and comparisons in them, by their names in keys.
GROUPS = {
    "feet": ("three_feet", "comparison"),
    "face": ("patch", "comparison"),
    "sides": ("polygons", "comparison"),
}
IDENTIFIED, FITTED, QUARTIC = "identified", "fitted_ellipsoid", "fitted_quartic"
#: Models with which the identified pressure is compared, by their names in keys.
RIVALS = {"": FITTED, "quartic-": QUARTIC}


def _read(
    compute: Callable[[dict[str, Any]], float], what: str, digits: int = 0, unit: str = "1"
) -> Quantity:
    """A number of the file."""

    def read(results: Results) -> float:
        return float(compute(results.pushes))

    return Quantity(
        read=read, digits=digits, unit=unit, source=f"paper/measured_pushes.json: {what}"
    )


def _at(content: dict[str, Any], path: tuple[str, ...]) -> Any:
    """The value in the file at a path of keys."""
    node: Any = content
    for key in path:
        node = node[key]
    return node


def _value(*path: str, digits: int = 0, unit: str = "1", factor: float = 1.0) -> Quantity:
    """A number in the file at a path of keys, multiplied by a factor."""
    return _read(
        lambda content: factor * float(_at(content, path)), ".".join(path), digits, unit
    )  # fmt: skip


def _median(group: str, quantity: str, model: str) -> Quantity:
    """Median error of a model, in degrees or mm."""
    part, key = GROUPS[group]
    unit = "mm" if quantity == "pose" else "degree"
    return _value(part, key, quantity, model, "median", digits=1, unit=unit)


def _ratio(group: str, quantity: str) -> Numbers:
    """Ratio of the median of the identified pressure to that of the fitted ellipsoid, with its interval."""
    path = (*GROUPS[group], quantity, IDENTIFIED)
    return _with_ends(f"pushes-{group}-{quantity}-ratio", lambda x: _at(x, path), ".".join(path))


def _against(group: str, quantity: str, rival: str) -> Numbers:
    """Ratio of the median of the identified pressure to that of a rival, with its interval."""
    path, name = (GROUPS[group][0], "against", RIVALS[rival], quantity), f"{quantity}-{rival}ratio"
    return _with_ends(f"pushes-{group}-{name}", lambda x: _at(x, path), ".".join(path))


def _of_polygon(name: str, choose: Callable[..., dict[str, Any]]) -> Numbers:
    """The ratio of one of the polygons, with its interval."""

    def entry(content: dict[str, Any]) -> dict[str, Any]:
        polygons = content["polygons"]["objects"].values()
        return choose([models[IDENTIFIED] for models in polygons], key=lambda x: x["ratio"])

    return _with_ends(f"pushes-objects-{name}", entry, f"polygons: the {name}")


def _tail_ratio(group: str, quantity: str, rival: str) -> Quantity:
    """Ratio of the 90th percentile of the error of the identified pressure to that of a rival."""
    return _value(GROUPS[group][0], "against", RIVALS[rival], quantity, "ratio_90", digits=2)


def _with_ends(name: str, find: Callable[[dict[str, Any]], dict[str, Any]], what: str) -> Numbers:
    """A ratio and the ends of its interval, of an entry that is found in the file."""

    def end(index: int) -> Quantity:
        return _read(
            lambda content: find(content)["ratio_interval"][index], f"{what}.ratio_interval", 2
        )

    ratio = _read(lambda content: find(content)["ratio"], f"{what}.ratio", 2)
    return {name: ratio, f"{name}-low": end(0), f"{name}-high": end(1)}


def _medians(group: str, quantity: str, *models: str) -> Numbers:
    return {
        f"pushes-{group}-{quantity}-{model.replace('_', '-')}": _median(group, quantity, model)
        for model in models
    }


def _sides(content: dict[str, Any]) -> int:
    """Number of polygon pushes that first touch a side."""
    return int(content["polygons"]["pushes"] - content["polygons"]["corner_pushes"])


def _for_a_polygon(content: dict[str, Any]) -> float:
    """Mean number of pushes of a polygon in the half to which a model is fitted."""
    return _sides(content) / len(content["polygons"]["objects"]) / 2


def _for_a_triangle(content: dict[str, Any]) -> float:
    """Mean number of pushes of a triangle in the half to which a model is fitted."""
    logs = [*content["three_feet"]["logs"].values(), *content["patch"]["logs"].values()]
    return sum(int(log["pushes"]) for log in logs) / len(logs) / 2


MEASURED: Numbers = {
    "pushes-feet-logs": _read(
        lambda content: len(content["three_feet"]["logs"]), "logs on three feet"
    ),
    "pushes-feet": _value("three_feet", "pushes"),
    "pushes-face": _value("patch", "pushes"),
    "pushes-objects": _read(lambda content: len(content["polygons"]["objects"]), "polygons"),
    "pushes-sides": _read(_sides, "polygons: pushes less corner_pushes"),
    "pushes-corners": _value("polygons", "corner_pushes"),
    "pushes-fit-triangle": _read(_for_a_triangle, "half of the mean number of pushes in a log"),
    "pushes-fit-polygon": _read(_for_a_polygon, "half of the mean number of pushes at sides"),
    "pushes-seed": _value("seed"),
    "pushes-splits": _value("splits"),
    **_medians("feet", "motion", "known_feet", "known_feet_ellipsoid", IDENTIFIED),
    "pushes-near-foot": _value("about_a_foot", "pushes"),
    "pushes-foot-distance": _value("about_a_foot", "distance", unit="mm"),
    "pushes-load-set-tolerance": _value("about_a_foot", "tolerance", unit="percent", factor=100.0),
    "pushes-in-load-set": _value("about_a_foot", "in_load_set", unit="percent", factor=100.0),
    "pushes-random-in-load-set": _value(
        "about_a_foot", "of_random_pushes", unit="percent", factor=100.0
    ),
    **_against("feet", "motion", ""),
    **_against("feet", "motion", "quartic-"),
    **_against("face", "motion", ""),
    **_against("face", "motion", "quartic-"),
    "pushes-feet-motion-ratio-90": _tail_ratio("feet", "motion", ""),
    "pushes-feet-motion-quartic-ratio-90": _tail_ratio("feet", "motion", "quartic-"),
    **_ratio("sides", "pose"),
    **_of_polygon("lowest", min),
    **_of_polygon("highest", max),
    **_medians("face", "motion", IDENTIFIED, "uniform", FITTED, QUARTIC),
}
