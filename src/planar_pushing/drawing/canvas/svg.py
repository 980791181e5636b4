"""Marks as SVG."""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from planar_pushing.drawing.canvas.labels import settle
from planar_pushing.drawing.canvas.marks import (
    DASHES,
    SHAPES,
    Area,
    Arrow,
    Dot,
    Hatch,
    Label,
    Line,
    Picture,
    Sheet,
)
from planar_pushing.mechanics.plane import Array

FONT = "STIXGeneral, 'STIX Two Text', 'Times New Roman', 'DejaVu Serif', serif"
ANCHORS = {"left": "start", "center": "middle", "right": "end"}
#: Commands of matplotlib's mathematical text that labels contain, and the corresponding letters.
LETTERS = {
    r"\phi": "φ", r"\psi": "ψ", r"\theta": "θ", r"\mu": "μ", r"\omega": "ω", r"\rho": "ρ",
    r"\infty": "∞", r"\circ": "°", r"\times": "×",
}  # fmt: skip
#: Strokes of a pattern by the characters of a hatch, in a cell of 6 pixels.
STROKES = {
    "/": "M-1 7L7 -1", "\\": "M-1 -1L7 7", "x": "M-1 7L7 -1M-1 -1L7 7", "+": "M3 0V6M0 3H6",
    ".": "M3 2.2v1.6", "|": "M3 0V6",
}  # fmt: skip
TOKEN = re.compile(
    r"\\math(bf|rm)\{([^{}]*)\}"
    r"|([_^])(\\math(?:bf|rm)\{[^{}]*\}|\{(?:[^{}]|\{[^{}]*\})*\}|\\[A-Za-z]+|\w)"
    r"|\\,|\\?[A-Za-z]+|."
)


def to_svg(
    picture: Picture, box: Array, size: Sequence[float], pad: float = 12.0, point: float = 1.0
) -> str:
    """SVG of a size in pixels that shows a box with padding in points; a point has `point` pixels."""
    sheet = Sheet.around(box, size, pad, point)
    wide, high = (f"{length:.6g}" for length in sheet.size)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide}" height="{high}" '
        f'viewBox="0 0 {wide} {high}" font-family="{html.escape(FONT)}">{content(picture, sheet)}</svg>'
    )


def content(picture: Picture, sheet: Sheet) -> str:
    """Elements of the marks in drawing order, covering marks last."""
    labels = {id(old): new for old, new in _labels(picture, sheet)}
    marks = [labels.get(id(mark), mark) for mark in picture.drawing_order]
    patterns = sorted({(a.hatch, a.ink) for a in marks if isinstance(a, Area) and a.hatch})
    elements = (DRAWERS[type(mark)](mark, sheet) for mark in marks)
    return "".join([*map(_pattern, patterns), *elements])


def _labels(picture: Picture, sheet: Sheet) -> Iterable[tuple[Label, Label]]:
    old = [mark for mark in picture.marks if isinstance(mark, Label)]
    return zip(old, settle(picture, sheet), strict=True)


def _name(hatch: str, ink: str) -> str:
    return (
        "hatch"
        + "".join(f"{ord(character):x}" for character in sorted(set(hatch)))
        + ink.lstrip("#")
    )


def _pattern(look: tuple[str, str]) -> str:
    hatch, ink = look
    strokes = "".join(STROKES[character] for character in sorted(set(hatch)))
    wide = 1.6 if "." in hatch else 0.8
    return (
        f'<defs><pattern id="{_name(hatch, ink)}" width="6" height="6" patternUnits="userSpaceOnUse">'
        f'<path d="{strokes}" stroke="{ink}" stroke-width="{wide}"/></pattern></defs>'
    )


def _path(points: Array, sheet: Sheet, end: str = "") -> str:
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in sheet.to_sheet(points).tolist()) + end


def _area(area: Area, sheet: Sheet) -> str:
    path = "".join(_path(ring, sheet, "Z") for ring in area.rings)
    fills = [area.color, f"url(#{_name(area.hatch, area.ink)})"][: 2 if area.hatch else 1]
    return "".join(f'<path d="{path}" fill="{fill}" fill-rule="evenodd"/>' for fill in fills)


def _stroke_path(path: str, color: str, width: float, dash: str, sheet: Sheet) -> str:
    dashes = " ".join(f"{part * width * sheet.point:.3g}" for part in DASHES[dash])
    broken = f' stroke-dasharray="{dashes}"' if dashes else ""
    return (
        f'<path d="{path}" fill="none" stroke="{color}" stroke-width="{width * sheet.point:.3g}"'
        f"{broken}/>"
    )


def _line(line: Line, sheet: Sheet) -> str:
    return _stroke_path(_path(line.points, sheet), line.color, line.width, line.dash, sheet)


def _hatch(hatch: Hatch, sheet: Sheet) -> str:
    path = "".join(_path(stroke, sheet) for stroke in hatch.strokes)
    return _stroke_path(path, hatch.color, hatch.width, "", sheet)


def _arrow(arrow: Arrow, sheet: Sheet) -> str:
    shaft, head = arrow.shape(sheet.unit)
    line = _stroke_path(_path(shaft, sheet), arrow.color, arrow.width, arrow.dash, sheet)
    if arrow.filled:
        return f'{line}<path d="{_path(head, sheet, "Z")}" fill="{arrow.color}"/>'
    return line + _stroke_path(_path(head, sheet), arrow.color, arrow.width, "", sheet)


def _dot(dot: Dot, sheet: Sheet) -> str:
    wide = dot.width * sheet.point
    edge = f' stroke="{dot.edge}" stroke-width="{wide:.3g}"' if wide else ""
    radius = dot.size / 2
    if dot.shape == "o":
        x, y = sheet.to_sheet(dot.position).tolist()
        face = dot.face or "none"
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius * sheet.point:.3g}" fill="{face}"{edge}/>'
    shapes = ""
    for points, filled in SHAPES[dot.shape]:
        face = dot.edge if filled else dot.face or "none"
        path = _path(dot.position + radius * sheet.unit * points, sheet, "Z")
        shapes += f'<path d="{path}" fill="{face}"{edge}/>'
    return shapes


def _label(label: Label, sheet: Sheet) -> str:
    right, up = label.offset
    x, y = (sheet.to_sheet(label.position) + sheet.point * np.array([right, -up])).tolist()
    size, rows = label.size * sheet.point, label.text.split("\n")
    head = (
        f'<text x="{x:.1f}" y="{y:.1f}" fill="{label.color}" font-size="{size:.3g}" '
        f'text-anchor="{ANCHORS[label.align]}" stroke="white" stroke-width="{2 * sheet.point:.3g}" '
        f'stroke-linejoin="round" paint-order="stroke">'
    )
    spans = []
    for number, row in enumerate(rows):
        down = 0.34 + number - (len(rows) - 1) / 2
        spans.append(f'<tspan x="{x:.1f}" y="{y + down * size:.1f}">{text(row)}</tspan>')
    return f"{head}{''.join(spans)}</text>"


def text(row: str) -> str:
    """A row of a label in SVG; mathematical text between dollar signs is bold, italic or small."""
    parts = row.split("$")
    texts = [
        html.escape(part) if i % 2 == 0 else "".join(_math(part)) for i, part in enumerate(parts)
    ]
    return "".join(texts)


def _math(row: str) -> Iterator[str]:
    for token in TOKEN.finditer(row):
        bold, inner, raised, script = token[1], token[2], token[3], token[4]
        if bold:
            style = 'font-weight="bold"' if bold == "bf" else ""
            yield f"<tspan {style}>{html.escape(inner)}</tspan>"
        elif raised:
            shift, back = ("0.25em", "-0.175em") if raised == "_" else ("-0.3em", "0.21em")
            inside = script[1:-1] if script[0] == "{" else script
            small = f'<tspan dy="{shift}" font-size="70%">{"".join(_math(inside))}</tspan>'
            level = f'<tspan dy="{back}">\N{ZERO WIDTH SPACE}</tspan>'
            yield "\N{DEGREE SIGN}" if inside == r"\circ" else small + level
        elif token[0] == r"\,":
            yield "\N{THIN SPACE}"
        elif token[0] in LETTERS:
            yield f'<tspan font-style="italic">{LETTERS[token[0]]}</tspan>'
        elif token[0].isalpha():
            yield f'<tspan font-style="italic">{html.escape(token[0])}</tspan>'
        else:
            yield "" if token[0] in "{}" else html.escape(token[0])


DRAWERS: dict[type, Callable[[Any, Sheet], str]] = {
    Area: _area,
    Line: _line,
    Hatch: _hatch,
    Arrow: _arrow,
    Dot: _dot,
    Label: _label,
}
