"""Everything that the page shows of a state, as markup by element id."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from html import escape
from typing import NamedTuple

import numpy as np

from planar_pushing.drawing.canvas.colors import ENERGIES, MODES, look_of
from planar_pushing.drawing.canvas.marks import Picture, Positions, Sheet
from planar_pushing.drawing.words import outcome, row
from planar_pushing.explorer import several
from planar_pushing.explorer.lengths import factor, headings
from planar_pushing.explorer.objects import object_of
from planar_pushing.explorer.pictures import curve, maps
from planar_pushing.explorer.pictures.following import (
    FollowedMotion,
    follow,
    push_at,
    sentence_at,
    solution_at,
)
from planar_pushing.explorer.pictures.handles import handle_of
from planar_pushing.explorer.pictures.layout import Held, markup_of_handles
from planar_pushing.explorer.pictures.pictures import (
    TIME_BOX,
    SolvedPush,
    chip,
    instant_picture,
    markup,
    push_box,
    push_picture,
    solve_push,
    spots_of,
    time_line_picture,
    time_picture,
)
from planar_pushing.explorer.state import Handle, State, without_display
from planar_pushing.mechanics.plane import Array, Frame
from planar_pushing.mechanics.solutions import Solution
from planar_pushing.scenes.contacts_model import ContactsFile

#: Pixels per point: maximum, minimum, and ratio to the picture's width in pixels.
POINT = 1.55, 1.25, 1 / 450
#: Padding around a picture in points.
PAD = 10.0
AT_START = "of the push at the start"


class TurnedSheet(Sheet):
    """A sheet of a picture in another frame.

    The object rests on the sheet while its contact is dragged, although the picture, whose origin is the
    contact, moves and turns.
    """

    frame: Frame

    @classmethod
    def of(cls, sheet: Sheet, frame: Frame) -> TurnedSheet:
        """Sheet that shows a picture in a frame, which is expressed in the frame of the given sheet."""
        turned = cls(*sheet)
        turned.frame = frame
        return turned

    def to_sheet(self, positions: Positions) -> Array:
        """Positions on the sheet, y downward from its upper left corner."""
        return super().to_sheet(self.frame.point_out(positions))

    def to_scene(self, positions: Positions) -> Array:
        """Positions in the scene of positions on the sheet."""
        return self.frame.point_in(super().to_scene(positions))


class Order(NamedTuple):
    """A state to show, sizes of pictures in pixels, the box of the push, and the last event's number.

    A handle can be held; if it is the contact, the object rests on the sheet as in the state `grabbed`.
    """

    state: State
    sizes: Mapping[str, tuple[float, float]]
    box: Array
    number: int = 0
    held: Held | None = None
    grabbed: State | None = None


class View(NamedTuple):
    """Markup by id, the push that is shown, and, over time, the motion and the push at the instant."""

    markup: dict[str, str]
    push: SolvedPush | None = None
    motion: FollowedMotion | None = None
    instant: State | None = None


def sheet_of(size: tuple[float, float], box: Array) -> Sheet:
    """Sheet of a picture with a size in pixels."""
    largest, smallest, ratio = POINT
    return Sheet.around(box, size, PAD, float(np.clip(size[0] * ratio, smallest, largest)))


def view(order: Order) -> View:
    """View of a state: of its contacts, of its push, or of the instant that is followed."""
    if order.state.several is not None:
        return _contacts(order, order.state.several)
    return _push(order) if order.state.time is None else _instant(order, order.state.time)


#: Elements that a scene with several contacts leaves empty.
EMPTY = ("runs", "now", "when", "energies", "curve", "cross", "areas", "legend", "map-when")


def _contacts(order: Order, file: ContactsFile) -> View:
    picture = several.sketch(file)
    sheet = sheet_of(order.sizes["scene"], order.box)
    words = {"scene": markup(picture.draw(), sheet), "solutions": several.table(picture)}
    title = picture.title()
    return View(dict.fromkeys(EMPTY, "") | words | {"words": f"{title[:1].upper()}{title[1:]}."})


def box_of(state: State) -> Array:
    """Corners of the picture of the contacts, or of a push in any direction."""
    return push_box(state) if state.several is None else several.sketch(state.several).box()


def sheet_of_push(order: Order) -> Sheet:
    """Sheet of the picture of a push, on which an object whose contact is dragged keeps its place."""
    sheet = sheet_of(order.sizes["scene"], order.box)
    if order.grabbed is None or order.held is None or order.held.handle != Handle.CONTACT:
        return sheet
    fence, first = object_of(order.state).fence, object_of(order.grabbed).fence
    x, y = first.point_in(fence.origin).tolist()
    a, b = first.vector_in(fence.axis).tolist()
    return TurnedSheet.of(sheet, Frame((x, y), (a, b)))


def _push(order: Order) -> View:
    push = solve_push(order.state)
    sheet = sheet_of_push(order)
    circles = markup_of_handles(spots_of(push, sheet, order.held), handle_of(push.state))
    content = {
        "scene": markup(push_picture(push, sheet, order.held), sheet, circles),
        "words": outcome(push.solutions, push.sketch.pusher, push.chosen),
        "runs": "", "now": "", "when": "", "energies": energy_legend(),
    }  # fmt: skip
    return View(content | _of_push(order, push), push)


def _of_push(order: Order, push: SolvedPush) -> dict[str, str]:
    """Markup of the limit curve, the cross on the map, and the table for a push."""
    scene, symbol = push.state.scene, push.sketch.symbol
    picture = curve.curve_picture(scene, push.solutions, push.chosen, symbol)
    return {
        "curve": _markup(order, "curve", picture, curve.BOX),
        "cross": _markup(order, "map", maps.cross(push.state), maps.BOX),
        "solutions": table(
            push.solutions, push.sketch.pusher, push.chosen, order.state, scene.stores_energy
        ),
    }


def _markup(order: Order, name: str, picture: Picture, box: Array) -> str:
    return markup(picture, sheet_of(order.sizes[name], box))


def _instant(order: Order, time: float) -> View:
    state, motion = order.state, follow(order.state)
    time = min(time, float(motion.times[-1]))
    content = {
        "scene": markup(instant_picture(motion, time), sheet_of(order.sizes["scene"], motion.box)),
        "words": sentence_at(motion, time),
        "runs": _over_time(without_display(state), order.sizes["time"]),
        "now": _markup(order, "time", time_line_picture(motion, time), TIME_BOX),
        "energies": energy_legend(any(run.flush for run in motion.runs)),
    }
    instant = push_at(state, motion, time)
    push = solve_push(replace(state, time=None) if instant is None else instant)
    when = AT_START if instant is None else f"at time {time:.3f}"
    content |= _of_push(order, push) | map_markup(
        push.state, maps.quick_map(push.state), order.sizes["map"]
    )
    content |= {"when": when, "map-when": when}
    if instant is None:
        solution, pusher = solution_at(state, motion, time) or (None, None)
        content["solutions"] = table(
            [] if solution is None else [solution], pusher, 0, order.state, False
        )
    return View(content, push, motion, instant)


@lru_cache(maxsize=4)
def _over_time(state: State, size: tuple[float, float]) -> str:
    return markup(time_picture(follow(state)), sheet_of(size, TIME_BOX))


def table(
    solutions: Sequence[Solution],
    pusher: Array | None,
    chosen: int,
    state: State,
    accelerates: bool,
) -> str:
    """Table of the consistent solutions, with the one drawn in full in bold.

    The units of its columns are those of the state; the motions are accelerations or velocities.
    """
    if not solutions:
        return "<p>No consistent solution.</p>"
    rows, head, units = "", "", headings(state, accelerates)
    for index, solution in enumerate(solutions):
        texts, look = row(_in_shown_unit(solution, state), pusher), MODES[int(solution.mode)]
        head = "".join(f"<th>{escape(_heading(name, units))}</th>" for name in texts)
        name = chip(escape(texts.pop("mode")), look.fill, look.hatch, look.ink)
        cells = "".join(f"<td>{escape(text)}</td>" for text in texts.values())
        emphasis = ' class="shown"' if index == chosen else ""
        rows += f"<tr{emphasis}><th>{name}</th>{cells}</tr>"
    return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"


def _heading(name: str, units: Mapping[str, str]) -> str:
    """Name of a column with its unit."""
    unit = units.get(name, "")
    return f"{name.capitalize()} ({unit})" if unit else name.capitalize()


def _in_shown_unit(solution: Solution, state: State) -> Solution:
    """A solution whose positions are in the unit of the page."""
    scale, position = factor(state), solution.force_position
    if scale == 1.0:
        return solution
    shifted = None if position is None else scale * position
    return replace(solution, center=scale * solution.center, force_position=shifted)


def map_markup(state: State, modes: maps.Map, size: tuple[float, float]) -> dict[str, str]:
    """Markup of the map and its legend."""
    looks = dict.fromkeys(look_of(code) for code in maps.sets_of(modes))
    return {
        "areas": markup(maps.map_picture(state, modes), sheet_of(size, maps.BOX)),
        "legend": "".join(chip(*look[:2], look.hatch, look.ink) for look in looks),
    }


def energy_legend(flush: bool = False) -> str:
    """Legend of the energies, of the line above the modes, and of the strokes of a flush side."""
    lines = "".join(chip(name, color) for name, color in ENERGIES.items())
    strokes = chip("a side flush on the fence", "#FFFFFF", "|") if flush else ""
    return f'{lines}{strokes}<span class="key">\u2501 more than one mode possible</span>'
