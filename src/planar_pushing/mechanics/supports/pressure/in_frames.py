"""The pieces of one support in many frames, as those of many supports, without making the supports."""

from __future__ import annotations

import numpy as np

from planar_pushing.core.multipole import ORDER, TERMS
from planar_pushing.mechanics.frames import Frame
from planar_pushing.mechanics.supports.pressure.assembly import (
    Gathered,
    gathered,
    measure_pieces,
    stacked,
)
from planar_pushing.mechanics.supports.pressure.pieces import PLATES, Array, Pieces
from planar_pushing.mechanics.supports.pressure.spread import ENDS


def gather_in_frames(pieces: Pieces, origins: Array, axes: Array) -> Gathered:
    """Pieces of a support expressed in frames, as `gathered` has those of one support for each frame.

    Parameters
    ----------
    pieces : Pieces
    origins, axes : ndarray, shape (n, 2)
        Origins of the frames, and directions of their x axes, in the frame of the pieces.

    Notes
    -----
    Positions are those of supports that are moved one by one, to the last bit; plates differ from theirs by
    rounding, because their pressure and their series are not computed anew in each frame.
    """
    one, count = gathered([pieces]), len(axes)
    x, y = origins.T
    a, b = axes.T
    frame = Frame((x[:, None], y[:, None]), (a[:, None], b[:, None]))
    # Without the plates, whose centers and shares follow from their edges.
    rows = [np.tile(each, (count, 1)) for each in one.rows]
    for kind, *columns in ENDS:
        for column in dict.fromkeys(columns):
            ends = slice(column, column + 2)
            places = frame.point_in(one.rows[kind][:, ends]) + 0.0
            rows[kind][:, ends] = places.reshape(-1, 2)
    owners = [np.repeat(np.arange(count), len(each)) for each in one.rows]
    lengths = np.tile(np.diff(one.first), count)
    found = measure_pieces(rows[:PLATES], rows[-1], owners, lengths, count)
    if not len(lengths):
        return found
    _, _, terms = stacked(one, one.extents)
    return found._replace(terms=_rotate_terms(terms, axes))


def _rotate_terms(terms: Array, axes: Array) -> Array:
    """Terms of a support's plates, as in `multipole.of_all`, in frames of other directions.

    Positions z become ``z conj(a)`` for an axis a, so the means of z^j conj(z)^k are multiplied by
    ``conj(a)^(j - k)``.
    """
    found = np.empty((len(axes), *terms.shape))
    found[..., TERMS:, :] = terms[:, TERMS:]
    before, behind = (np.ascontiguousarray(each).view(complex)[..., 0] for each in (terms, found))
    factors, start = np.ones(len(axes), dtype=complex), 0
    for m in range(ORDER + 1):
        stop = start + (ORDER - m) // 2 + 1
        behind[..., start:stop] = before[:, start:stop] * factors[:, None, None]
        factors = factors * (axes[:, 0] - 1j * axes[:, 1])
        start = stop
    return found.reshape(-1, *terms.shape[1:])
