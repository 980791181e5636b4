"""Pictures of the objects of the mechanics in notebooks, where the figures are installed."""

from __future__ import annotations

from importlib import import_module

from planar_pushing.terms.errors import InvalidValue, MissingExtra


def picture(name: str, *of: object) -> str | None:
    """SVG by a function of the figures; None without their extra, and of arrays.

    The figures build on the mechanics, so that their module is looked up by name.
    """
    try:
        module = import_module("planar_pushing.figures.notebook")
        return str(getattr(module, name)(*of))
    except (MissingExtra, InvalidValue):
        return None


class Pictured:
    """A support: notebooks show it in its body frame."""

    __slots__ = ()

    def _repr_svg_(self) -> str | None:
        return picture("support_svg", self)
