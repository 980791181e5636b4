"""The pieces of one support in many frames, gathered without constructing a support for each."""

from __future__ import annotations

from functools import partial

import numpy as np

from planar_pushing.core.supports.multipole import ORDER, TERMS
from planar_pushing.mechanics.plane import Frame
from planar_pushing.mechanics.pressure.assembly import (
    Gathered,
    gather_pieces,
    measure_pieces,
    stack_with_terms,
)
from planar_pushing.mechanics.pressure.pieces import ENDS, PLATES, Array, Pieces


def gather_in_frames(pieces: Pieces, origins: Array, axes: Array) -> Gathered:
    """Pieces of a support in frames, as `gather_pieces` returns them for a list of one support per frame.

    Parameters
    ----------
    pieces : Pieces
    origins, axes : ndarray, shape (n, 2)
        Origins of the frames, and directions of their x axes, in the frame of the pieces.

    Notes
    -----
    Positions equal those of supports that are moved one by one, to the last bit. Plates differ by rounding,
    because their pressure and their series are not recomputed in each frame.
    """
    one, count = gather_pieces([pieces]), len(axes)
    x, y = origins.T
    a, b = axes.T
    frame = Frame((x[:, None], y[:, None]), (a[:, None], b[:, None]))
    # Without the plates, whose centers and shares follow from their edges.
    rows = [np.tile(block, (count, 1)) for block in one.rows]
    for kind, *columns in ENDS:
        for column in dict.fromkeys(columns):
            ends = slice(column, column + 2)
            places = frame.point_in(one.rows[kind][:, ends]) + 0.0
            rows[kind][:, ends] = places.reshape(-1, 2)
    owners = [np.repeat(np.arange(count), len(block)) for block in one.rows]
    lengths = np.tile(np.diff(one.first), count)
    group = measure_pieces(rows[:PLATES], rows[-1], owners, lengths, count)
    if not len(lengths):
        return group
    _, _, terms = stack_with_terms(one, one.extents)
    return group._replace(write_terms=partial(_rotate_terms, terms, axes))


def _rotate_terms(terms: Array, axes: Array, rotated: Array) -> None:
    """Write the terms of a support's plates in frames of other directions.

    Positions z become ``z conj(a)`` for an axis a, so the means of z^j conj(z)^k are multiplied by
    ``conj(a)^(j - k)``.
    """
    before, after = terms.view(complex)[..., 0], rotated.view(complex)
    after = after.reshape(len(axes), *before.shape)
    orders = np.repeat(np.arange(ORDER + 1), (ORDER - np.arange(ORDER + 1)) // 2 + 1)
    powers = np.ones((len(axes), ORDER + 1), dtype=complex)
    np.cumprod(
        np.broadcast_to((axes @ [1, -1j])[:, None], (len(axes), ORDER)), axis=1, out=powers[:, 1:]
    )
    np.multiply(before[:, :TERMS], powers[:, None, orders], out=after[..., :TERMS])
    after[..., TERMS:] = before[:, TERMS:]
