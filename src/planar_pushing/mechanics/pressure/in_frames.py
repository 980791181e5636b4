"""The pieces of one support in many frames, gathered without constructing a support for each."""

from __future__ import annotations

from functools import partial

import numpy as np

from planar_pushing.core.supports.multipole import ORDER, ROWS, TERMS
from planar_pushing.mechanics.plane import Frame
from planar_pushing.mechanics.pressure.assembly import (
    Gathered,
    blocks_of,
    gather_pieces,
    lay_out,
    measure_pieces,
    stack,
)
from planar_pushing.mechanics.pressure.pieces import EDGES, ENDS, PLATES, Array, Pieces


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
    blocks, _ = blocks_of(pieces)
    x, y = origins.T
    a, b = axes.T
    frame = Frame((x[:, None], y[:, None]), (a[:, None], b[:, None]))
    # Without the plates, whose centers and shares follow from their edges.
    rows = [np.tile(block, (count, 1)) for block in blocks]
    for kind, *columns in ENDS:
        number = PLATES if kind == EDGES else kind
        for column in dict.fromkeys(columns):
            ends = slice(column, column + 2)
            places = frame.point_in(blocks[number][:, ends]) + 0.0
            rows[number][:, ends] = places.reshape(-1, 2)
    counts, lengths = one.layout.counts, one.layout.lengths
    group = measure_pieces(rows, lay_out(np.tile(counts, (count, 1)), np.tile(lengths, count)))
    if not len(lengths):
        return group
    terms = stack(one, one.extents).terms.reshape(-1, ROWS, 2)
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
