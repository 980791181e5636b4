"""Names of the units of a scene's numbers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Annotated, Any

from planar_pushing.terms.declared import Read, require_declared
from planar_pushing.terms.errors import InvalidValue


def _name(name: str, value: Any) -> str:
    """The name of a unit."""
    if not isinstance(value, str) or not value.strip() or not value.isprintable():
        raise InvalidValue(name, value, "the name of a unit", "give it as text, such as m")
    return value


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
            "force time": f"{self.force} {self.time}",
            "force length": f"{self.force} {self.length}",
            "length/time": f"{self.length} {self.time}-1",
            "force/radian": f"{self.force} radian-1",
            "radian/time": f"radian {self.time}-1",
            "radian motion/length": f"radian {self.time}-{2 if inertia else 1}",
        }
        return units.get(quantity, quantity)


def named_units(data: Any, units: Units | None, *, inertia: bool = False) -> Any:
    """A DataArray or a dataset with the units of a scene, from `with_units`."""
    if units is None:
        return data
    for variable in (data, *getattr(data, "variables", {}).values()):
        variable.attrs = with_units(dict(variable.attrs), units, inertia=inertia)
    if "twist_unit" in data.coords:
        names = unit_names(data["twist_unit"].values.tolist(), units, inertia=inertia)
        data = data.assign_coords(twist_unit=("twist_component", names))
    return data


def unit_names(
    quantities: Iterable[str], units: Units | None, *, inertia: bool = False
) -> list[str]:
    """Units of quantities; without the units of a scene, the quantities."""
    return [
        quantity if units is None else units.of(quantity, inertia=inertia)
        for quantity in quantities
    ]


def with_units(
    attributes: dict[str, Any], units: Units | None, *, inertia: bool = False
) -> dict[str, Any]:
    """Attributes of a variable, with the units of a scene instead of a scaled quantity."""
    if units is None or "quantity" not in attributes:
        return attributes
    rest = {name: attribute for name, attribute in attributes.items() if name != "quantity"}
    return rest | {"units": units.of(attributes["quantity"], inertia=inertia)}
