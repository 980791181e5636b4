"""Outlines in files: a list of corners, or one shape with its numbers under its name."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from planar_pushing.mechanics.outline.outline import Outline, require_outline, rounded
from planar_pushing.mechanics.supports.disc import Disc
from planar_pushing.terms.declared import NUMBER, PAIR, Declaration
from planar_pushing.terms.errors import InvalidValue, suggestion

CORNERS = {"type": "array", "minItems": 3, "items": PAIR}
WORDS = (
    "the corners of a simple polygon, in order, or one of {disc: {radius}}, {rounded: {vertices, radius}}, "
    "{bulges: [[x, y, bulge], ...]} and {ellipse: {a, b}}"
)


def _pieces(rows: Any) -> Outline:
    """Rows of pieces, in which the word inf is the radius of curvature of a side."""
    words = {"inf": math.inf}
    if isinstance(rows, (list, tuple)) and all(isinstance(row, (list, tuple)) for row in rows):
        rows = [
            [words.get(number, number) if isinstance(number, str) else number for number in row]
            for row in rows
        ]
    return Outline.from_pieces(rows)


#: Outlines by their names in files: the maker, its keys, and those that can be left out.
SHAPES: dict[str, tuple[Callable[..., Any], tuple[str, ...], tuple[str, ...]]] = {
    "disc": (Disc, ("radius", "center"), ("center",)),
    "rounded": (lambda vertices, radius: rounded(vertices, radius), ("vertices", "radius"), ()),
    "bulges": (Outline.from_bulges, (), ()),
    "ellipse": (Outline.ellipse, ("a", "b", "arcs"), ("arcs",)),
    "pieces": (_pieces, (), ()),
}


def outline_of_entry(entry: Any, name: str = "outline") -> Outline:
    """The outline that an entry of a file describes.

    Raises
    ------
    InvalidValue
        If the entry has an unknown shape or key, or the shape is refused.
    """
    if not isinstance(entry, dict):
        return require_outline(entry, name)
    shape = next(iter(entry), None)
    if len(entry) != 1 or shape not in SHAPES:
        remedy = suggestion(str(shape), SHAPES, "name one shape")
        raise InvalidValue(name, entry, WORDS, remedy)
    maker, keys, optional = SHAPES[shape]
    content = entry[shape]
    if not keys:
        return require_outline(maker(content), name)
    required = [key for key in keys if key not in optional]
    if not isinstance(content, dict) or {*content} - {*keys} or {*required} - {*content}:
        raise InvalidValue(
            f"{name}.{shape}", content, f"the keys {', '.join(keys)}", f"give {', '.join(required)}"
        )
    return require_outline(maker(**content), name)


class ShapeEntry(dict[str, Any]):
    """The entry of a shape; it is not changed, so that scenes in the form of files are keys of caches."""

    def __hash__(self) -> int:  # type: ignore[override]
        return hash(repr(self))


def entry_of_outline(outline: Outline) -> Any:
    """The entry of a file from which the same outline is read: its corners, a disc, or its pieces."""
    if outline.corners is not None:
        return outline.corners
    if len(outline.pieces) == 1:
        x, y, radius = outline.pieces[0, :3].tolist()
        center = {"center": [x, y]} if x or y else {}
        return ShapeEntry(disc={"radius": radius} | center)
    return ShapeEntry(pieces=outline.pieces.tolist())


#: JSON schema: corners, or one shape.
SCHEMA: dict[str, Any] = {
    "anyOf": [
        CORNERS,
        {
            "type": "object", "minProperties": 1, "maxProperties": 1, "additionalProperties": False,
            "properties": {
                "disc": {"type": "object"}, "rounded": {"type": "object"}, "ellipse": {"type": "object"},
                "bulges": {"type": "array", "items": {"type": "array", "items": NUMBER}},
                "pieces": {"type": "array"},
            },
        },
    ]
}  # fmt: skip


class OutlineDeclaration(Declaration):
    """An outline, as a parameter and in files."""

    words = WORDS
    schema = SCHEMA

    def require(self, name: str, value: Any) -> Outline:
        return require_outline(value, name)

    def read(self, entry: Any) -> Any:
        return entry_of_outline(outline_of_entry(entry, ""))

    def from_file(self, entry: Any) -> Outline:
        return outline_of_entry(entry)

    def to_file(self, value: Outline) -> Any:
        entry = entry_of_outline(value)
        return entry if isinstance(entry, dict) else [list(corner) for corner in entry]


#: The declaration of outlines.
OUTLINE = OutlineDeclaration()
