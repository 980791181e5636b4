"""The page's texts as HTML: the solutions in a table, the legend of the map, and how long one waits."""

from __future__ import annotations

from html import escape

from planar_pushing.explore.pictures.modes import Map, look
from planar_pushing.explore.pictures.scene import Found
from planar_pushing.explore.words import row
from planar_pushing.figures.motion.timeline import MODES

HEADS = {"force": "Force", "motion": "Motion", "centre": "Centre", "slip": "Slip"}


def chip(color: str) -> str:
    """A small square of a color."""
    return f'<span class="chip" style="background:{color}"></span>'


def solutions(found: Found) -> str:
    """Every consistent solution, the one that is drawn in full in bold."""
    if not len(found.solutions):
        return '<p class="none">No consistent solution.</p>'
    head = "".join(f"<th>{each}</th>" for each in ("Mode", *HEADS.values()))
    rows = []
    for index, solution in enumerate(found.solutions):
        texts = row(solution, found.pusher)
        name = chip(MODES[int(solution.mode)][0]) + escape(texts["mode"])
        cells = "".join(f"<td>{escape(texts[key])}</td>" for key in HEADS)
        shown = ' class="shown"' if index == found.shown else ""
        rows.append(f"<tr{shown}><th>{name}</th>{cells}</tr>")
    return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>"


def legend(found: Map) -> str:
    """Names of the sets of modes that a map shows."""
    codes = sorted(set(found.codes.ravel().tolist()), key=lambda code: (code.bit_count(), code))
    looks = dict.fromkeys(look(code) for code in codes)
    return " ".join(
        f'<span class="key">{chip(color)}{escape(name)}</span>' for name, color in looks
    )
