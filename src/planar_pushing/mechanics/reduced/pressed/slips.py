"""Slips of any support, as `base` asks for them: under friction or inertia alone, and under both."""

from __future__ import annotations

from collections.abc import Callable
from math import hypot
from typing import Any

from planar_pushing.mechanics.compiled import compiled, generic
from planar_pushing.mechanics.effects.any_mass import MassAt
from planar_pushing.mechanics.reduced.corners import corner_under
from planar_pushing.mechanics.reduced.pressed.motions import (
    at_end,
    line_of,
    pushed,
    rise_of,
    write,
)
from planar_pushing.mechanics.reduced.pressed.places import Slide
from planar_pushing.mechanics.reduced.pressed.sliding import slips_along


@compiled
def edge_motion(effects, own, edge):
    """As `base.edge_motion`."""
    moved = pushed(effects, own, edge, 1.0)
    scale = 1.0 / max(hypot(moved.v_x, moved.v_y), abs(moved.spin))
    force = _growth(effects, scale)
    twist = scale * moved.v_x, scale * moved.v_y, scale * moved.spin
    return *twist, force * moved.f_x, force * moved.f_y


@compiled
def steady_slips(effects, own, edge, normal, start, found):
    """As `base.slips`, for one effect, whose motion keeps its direction; of a corner both ends."""
    line = line_of(effects, own, edge, 1.0)
    corner = corner_under(effects, line)
    if corner.exists:
        middle = pushed(effects, own, edge, 1.0)
        first = at_end(own, corner.first, middle.along, -middle.aside)
        last = at_end(own, corner.last, middle.along, -middle.aside)
        count = _grown(effects, own, first, normal, found[0])
        return count + _grown(effects, own, last, normal, found[count])
    return _grown(effects, own, pushed(effects, own, edge, 1.0), normal, found[0])


@compiled
def _grown(effects, own, moved, normal, found):
    """Write down a motion that has grown to a given normal part; how many can."""
    advance = rise_of(own, moved)
    if not ((normal > 0.0 and advance > 0.0) or (normal < 0.0 and advance < 0.0)):
        return 0
    scale = normal / advance
    write(moved, scale, _growth(effects, scale), found)
    return 1


@generic
def _growth(kinds: Any) -> Callable[..., Any]:
    """How a force grows with the motion."""
    return _in_proportion if MassAt in kinds else _not


@compiled
def _in_proportion(effects, scale):
    return scale


@compiled
def _not(effects, scale):
    return 1.0


@compiled
def slips(effects, own, edge, normal, start, found):
    """As `base.slips`, for friction and inertia."""
    if edge.x != 0.0:
        return slips_along(Slide(effects, own, edge, normal), start, found)
    # Under a force along the normal, the normal part alone says which motion it is.
    if not edge.y * normal > 0.0:
        return 0
    write(pushed(effects, own, edge, edge.y * normal), 1.0, 1.0, found[0])
    return 1
