"""A point at a corner of the outline: it leaves an outer corner, and an inner one along a side.

A point at an outer corner has no radius of curvature at all: sticking, it keeps the direction of its normal
in the world, until one side is along the fence frame; slipping, it goes on to the side at once. At an inner
corner it touches two sides, and its frame, about the bisector of their normals, rotates with the slider.
"""

from __future__ import annotations

from math import cos, sin

from planar_pushing.core.instant.solution import SLIP_LEFT, SLIP_RIGHT
from planar_pushing.core.motion.kinematics.fence import Span
from planar_pushing.core.motion.kinematics.rolling import is_sharp
from planar_pushing.core.motion.kinematics.system import RunState, System
from planar_pushing.core.motion.kinematics.wall import (
    chain_of,
    end_of_piece,
    move_to_place,
    put_wall,
)
from planar_pushing.core.supports.chain import chain_piece


def side_of_pocket(system: System, contact: int) -> int:
    """The side along which a slip leaves the inner corner at the contact."""
    piece = chain_piece(chain_of(system), system.run.wall.piece)
    return piece.next if contact == SLIP_LEFT else piece.before


def turn_to_side(system: System, contact: int, x: float, y: float) -> tuple[float, float]:
    """A vector of the frame of an inner corner, in that of the side along which a slip leaves it."""
    turn = system.run.wall.pocket if contact == SLIP_RIGHT else -system.run.wall.pocket
    c, s = cos(turn), sin(turn)
    return c * x + s * y, c * y - s * x


def leave_pocket(system: System, state: RunState, number: int) -> None:
    """Make a side of the inner corner at the contact the wall."""
    side = chain_piece(chain_of(system), number)
    is_after: bool = chain_piece(chain_of(system), system.run.wall.piece).next == number
    put_wall(system, number, end_of_piece(side, is_after), state.along)


def leave_corner(system: System, during: Span, time: float, state: RunState, contact: int) -> bool:
    """Let a point that slips at a corner go on to the side; return whether it does."""
    forward: bool = contact == SLIP_LEFT
    if (contact != SLIP_RIGHT and not forward) or not is_sharp(system):
        return False
    piece = chain_piece(chain_of(system), system.run.wall.piece)
    number = piece.next if forward else piece.before
    neighbor = chain_piece(chain_of(system), number)
    move_to_place(system, during, time, state, number, end_of_piece(neighbor, forward))
    return True
