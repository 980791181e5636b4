"""The path of a pusher over time, relative to its position at time 0."""

from __future__ import annotations

import itertools

from scipy.integrate import quad

from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.several.movers import Path, Vector

#: Relative and absolute error of the displacement of a velocity that is a function of time.
ERRORS = {"epsrel": 1e-12, "epsabs": 1e-13, "limit": 200}


def path_of(pusher: Pusher, duration: float) -> tuple[Path, tuple[float, ...]]:
    """The path of a pusher until the end of a run, and the times at which its velocity jumps."""
    if not pusher.pieces:
        return _path_of_function(pusher), tuple(pusher.breakpoints)
    # At the end of the run the velocity is the one until then.
    pieces = [piece for piece in pusher.pieces if piece[0] < duration]
    starts = [time for time, _ in pieces]
    velocities = [(float(x), float(y)) for _, (x, y) in pieces]
    places: list[Vector] = [(0.0, 0.0)]
    for (start, end), (v_x, v_y) in zip(itertools.pairwise(starts), velocities, strict=False):
        x, y = places[-1]
        places.append((x + (end - start) * v_x, y + (end - start) * v_y))

    def path(time: float) -> tuple[Vector, Vector]:
        # A jump belongs to the piece that begins.
        piece = max(sum(start <= time for start in starts) - 1, 0)
        (x, y), (v_x, v_y), passed = places[piece], velocities[piece], time - starts[piece]
        return (x + passed * v_x, y + passed * v_y), (v_x, v_y)

    return path, tuple(starts[1:])


def _path_of_function(pusher: Pusher) -> Path:
    """The path of a velocity that is a function of time."""
    known: dict[float, Vector] = {0.0: (0.0, 0.0)}

    def path(time: float) -> tuple[Vector, Vector]:
        if time not in known:
            if len(known) > 64:
                last = max(known)
                known.update({0.0: (0.0, 0.0), last: known[last]})
                for old in [moment for moment in known if moment not in (0.0, last)]:
                    del known[old]
            start = max((moment for moment in known if moment <= time), default=0.0)
            inner = [moment for moment in pusher.breakpoints if start < moment < time] or None
            x, y = (
                quad(lambda t, i=i: pusher.velocity_at(t)[i], start, time, points=inner, **ERRORS)[
                    0
                ]
                for i in (0, 1)
            )
            known[time] = known[start][0] + x, known[start][1] + y
        return known[time], pusher.velocity_at(time)

    return path
