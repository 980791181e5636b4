"""The contacts of an object with its pushers and walls at the start of a motion over time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from planar_pushing.mechanics.contact import in_numbers
from planar_pushing.mechanics.outline import require_outline
from planar_pushing.mechanics.plane import Frame, direction
from planar_pushing.objects.several.contact import Contact
from planar_pushing.objects.several.simulate_contacts import DRAWN, mover_of, place_pushers
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.several.movers import Mover, Pose, Shape, rests
from planar_pushing.simulation.walls import Wall


def contacts_at_start(
    contacts: Sequence[Contact],
    pushers: Sequence[Pusher],
    *,
    outline: Any,
    object_pose: tuple[float, float, float],
    walls: Sequence[Wall] = (),
) -> list[Contact]:
    """The contacts at time 0, with the velocities of their pushers, and those with walls.

    Parameters and errors are those of `simulate_contacts`, and the contacts those of `solve_contacts`.
    """
    whole = require_outline(outline)
    x, y, angle = object_pose
    world = Frame((x, y), tuple(direction(angle).tolist()))
    moving = []
    places = place_pushers(contacts, pushers, whole, outline)
    for contact, place, pusher in zip(contacts, places, pushers, strict=True):
        mover, _ = mover_of(place, pusher, world, whole.size, 1.0)
        v_x, v_y = (world.vector_in(mover.path(0.0)[1]) + 0.0).tolist()
        moving.append(replace(contact, velocity=(v_x, v_y)))
    shape = Shape(whole)
    for wall in walls:
        fixed = Mover(in_numbers(wall.law), wall.position, 0.0, wall.unit_normal, rests)
        touches = shape.touches(0, fixed, Pose(x, y, angle), 0.0, DRAWN * whole.size)
        moving += [Contact(touch.point, touch.normal, law=wall.law) for touch in touches]
    return moving
