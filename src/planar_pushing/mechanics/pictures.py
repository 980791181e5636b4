"""Notebook pictures of scenes, solutions and supports, drawn by functions that are registered here."""

from __future__ import annotations

from collections.abc import Callable

from planar_pushing.terms.errors import InvalidValue, MissingExtra

#: Functions that return the SVG of a scene, a push or a support, by these words.
PICTURES: dict[str, Callable[..., str]] = {}
#: Functions that register pictures, called when a picture is needed.
LOADERS: list[Callable[[], object]] = []


def picture(kind: str, *of: object) -> str | None:
    """SVG of a scene, a push or a support; None for arrays, or if nothing draws it.

    A loader whose dependencies are not installed raises `MissingExtra`.
    """
    try:
        for load in LOADERS:
            load()
        return PICTURES[kind](*of) if kind in PICTURES else None
    except (MissingExtra, InvalidValue):
        return None


class Pictured:
    """A support, which notebooks show in its body frame."""

    __slots__ = ()

    def _repr_svg_(self) -> str | None:
        return picture("support", self)
