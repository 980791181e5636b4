"""Names of the units of a scene's numbers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Annotated, Any

from planar_pushing.terms.declared import Read, require_declared
from planar_pushing.terms.errors import InvalidValue


def _name(name: str, given: Any) -> str:
    """The name of a unit."""
    if not isinstance(given, str) or not given.strip() or not given.isprintable():
        raise InvalidValue(name, given, "the name of a unit", "give it as text, such as m")
    return given


UNIT = Read(_name, "the name of a unit", {"type": "string"})


@dataclass(frozen=True, slots=True, kw_only=True)
class Units:
    """Units of the numbers of a scene, for results and pictures.

    They are only names: nothing is converted.

    Parameters
    ----------
    length, force, time : str
        For instance "m", "N" and "s", the defaults, or "mm", "N" and "s".

    Raises
    ------
    InvalidValue
        If a name is not a nonempty string.
    """

    length: Annotated[str, UNIT] = "m"
    force: Annotated[str, UNIT] = "N"
    time: Annotated[str, UNIT] = "s"

    def __post_init__(self) -> None:
        require_declared(self)

    def of(self, quantity: str, *, inertia: bool = False) -> str:
        """Unit of a quantity of the tables in `quantities`, as a product of powers in UDUNITS syntax."""
        motion = f"{self.length} {self.time}-{2 if inertia else 1}"
        units = {
            "length": self.length,
            "force": self.force,
            "time": self.time,
            "motion": motion,
            "force length": f"{self.force} {self.length}",
            "length/time": f"{self.length} {self.time}-1",
            "force/radian": f"{self.force} radian-1",
            "radian/time": f"radian {self.time}-1",
            "radian motion/length": f"radian {self.time}-{2 if inertia else 1}",
        }
        return units.get(quantity, quantity)


def named_units(found: Any, units: Units | None, *, inertia: bool = False) -> Any:
    """A DataArray or a dataset with the units of a scene, from `with_units`."""
    if units is None:
        return found
    for each in (found, *getattr(found, "variables", {}).values()):
        each.attrs = with_units(dict(each.attrs), units, inertia=inertia)
    if "twist_unit" in found.coords:
        named = unit_names(found["twist_unit"].values.tolist(), units, inertia=inertia)
        found = found.assign_coords(twist_unit=("twist_component", named))
    return found


def unit_names(
    quantities: Iterable[str], units: Units | None, *, inertia: bool = False
) -> list[str]:
    """Units of quantities; without the units of a scene, the quantities."""
    return [each if units is None else units.of(each, inertia=inertia) for each in quantities]


def with_units(
    attributes: dict[str, Any], units: Units | None, *, inertia: bool = False
) -> dict[str, Any]:
    """Attributes of a variable, with the units of a scene instead of a scaled quantity."""
    if units is None or "quantity" not in attributes:
        return attributes
    found = {name: each for name, each in attributes.items() if name != "quantity"}
    return found | {"units": units.of(attributes["quantity"], inertia=inertia)}
