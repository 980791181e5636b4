"""The unit in which the page shows lengths, and how it names it."""

from __future__ import annotations

from collections.abc import Mapping

from planar_pushing.explorer.state import State
from planar_pushing.terms.units import Units

#: Meters in each unit of length that the page converts.
METERS: Mapping[str, float] = {"m": 1.0, "cm": 0.01, "mm": 0.001}


def own_unit(state: State) -> str:
    """Unit of the scene's lengths; empty if the scene names none."""
    units = state.scene.units
    return "" if units is None else units.length


def units_of(state: State) -> list[str]:
    """Units of length that the page can show: m, cm and mm, or that of the scene alone."""
    own = own_unit(state)
    return list(METERS) if own in METERS else [own]


def shown_unit(state: State) -> str:
    """Unit of the lengths on the page: the chosen one, if the scene's lengths can be converted to it."""
    return state.unit if state.unit in units_of(state) and state.unit else own_unit(state)


def factor(state: State) -> float:
    """A length on the page for a length of 1 in the scene."""
    own, shown = own_unit(state), shown_unit(state)
    return METERS[own] / METERS[shown] if own in METERS and shown in METERS else 1.0


def label(name: str, state: State) -> str:
    """Name of a length with its unit, if the scene has one."""
    unit = shown_unit(state)
    return f"{name} ({unit})" if unit else name


def note(state: State) -> str:
    """A sentence on the unit of the lengths on the page, empty if the scene names one."""
    if shown_unit(state):
        return ""
    return (
        "Lengths are multiples of one unit, which the scene does not name; "
        f"the support reaches {state.size:.4g} from its center."
    )


def headings(state: State, accelerates: bool) -> dict[str, str]:
    """Units of the columns of the table of solutions, by column; empty without units.

    The motion is an acceleration or a velocity.
    """
    units: Units | None = state.scene.units
    if units is None:
        return {}
    power = "\N{SUPERSCRIPT TWO}" if accelerates else ""
    motion = f"{units.length}/{units.time}{power}"
    length = shown_unit(state)
    return {
        "force": units.force, "motion": motion, "slip": motion, "center": length, "at x*": length,
    }  # fmt: skip
