"""Notebook pictures of scenes, solutions and supports, if the extra for figures is installed."""

from __future__ import annotations

from importlib import import_module

from planar_pushing.terms.errors import InvalidValue, MissingExtra


def picture(name: str, *of: object) -> str | None:
    """SVG from a function of the figures; None for arrays, or without the extra for figures.

    The figures import the mechanics, so their module is looked up by name.
    """
    try:
        module = import_module("planar_pushing.figures.notebook")
        return str(getattr(module, name)(*of))
    except (MissingExtra, InvalidValue):
        return None


class Pictured:
    """A support, which notebooks show in its body frame."""

    __slots__ = ()

    def _repr_svg_(self) -> str | None:
        return picture("support_svg", self)
