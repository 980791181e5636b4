"""What is drawn of a state: both pictures and the words, made in a worker's thread."""

from __future__ import annotations

from typing import Any, NamedTuple

from planar_pushing.explore.handles import Handle
from planar_pushing.explore.pictures import curve, scene
from planar_pushing.explore.state import State
from planar_pushing.explore.words import outcome


class Order(NamedTuple):
    """A picture that is wanted: of a state, with a handle selected, after a number of moves."""

    state: State
    selected: Handle
    moves: int


class Pictures(NamedTuple):
    """What a state looks like."""

    found: scene.Found
    scene: dict[str, Any]
    curve: dict[str, Any]
    words: str


def pictures(order: Order) -> Pictures:
    """Solve, and make the columns of both pictures."""
    state = order.state
    found = scene.found(state)
    columns = scene.picture(state, found, order.selected)
    words = outcome(tuple(found.solutions), found.pusher, found.shown)
    return Pictures(found, columns, curve.picture(state, found), words)
