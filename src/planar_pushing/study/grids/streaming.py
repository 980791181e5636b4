"""A dataset written block by block, in memory that its size does not change.

Blocks are made and compressed by threads and written in order, so that the bytes depend on the content
alone. A block of what is compressed is a whole number of the pieces in which it is stored.
"""

from __future__ import annotations

import itertools
import zlib
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

import h5netcdf
import h5py
import numpy as np
import xarray as xr

from planar_pushing.mechanics.numerics.arrays import CORES
from planar_pushing.study.files.replacing import PathLike, replacing
from planar_pushing.study.storage.parts import Part, blocks
from planar_pushing.study.storage.store import LEVEL, stored_chunks, write_dataset

#: Points that are computed, and that are copied, at once.
COMPUTED, COPIED = 2**17, 2**18
#: What makes the part of a dataset.
Make = Callable[[Part], Any]


class Piece(NamedTuple):
    """A part of a variable, to be stored: compressed, with its place, or values, with their range."""

    name: str
    place: tuple[Any, ...]
    packed: bytes | None
    values: Any


def stream_dataset(
    make: Make, lengths: Mapping[str, int], path: PathLike, *, most: int, threads: int = 1
) -> None:
    """Write a dataset that is made in parts, whole or not at all.

    Parameters
    ----------
    make : callable
        Makes the dataset of a part of the grid; of the whole for an empty part.
    lengths : mapping
        Length of each dimension along which it can be cut.
    path : path
    most : int
        Points of a part.
    threads : int
        Parts that are made at once.
    """
    parts = blocks(lengths, most)
    if len(parts) < 2:
        write_dataset(make({}), path)
        return
    with replacing(path) as temporary:
        first = make(parts[0])
        _stretch(first, lengths, temporary)
        with h5py.File(temporary, "r+") as file:
            variables = dict(file)  # opened once: that takes longer than to store a piece
            layout = {name: each.chunks for name, each in variables.items()}
            jobs = (lambda part=part: list(pieces(make(part), part, layout)) for part in parts[1:])
            for found in itertools.chain(
                [pieces(first, parts[0], layout)], _in_order(jobs, threads)
            ):
                for piece in found:
                    _store(variables[piece.name], piece)


def _stretch(first: xr.Dataset, lengths: Mapping[str, int], path: Path) -> None:
    """An empty file for a whole dataset, as xarray writes one part of it."""
    sample = path.with_name(f"{path.name}.sample")
    try:
        write_dataset(first, sample)
        with h5netcdf.File(sample, "r") as source, h5netcdf.File(path, "w") as whole:
            whole.dimensions = {
                name: lengths.get(name, each.size) for name, each in source.dimensions.items()
            }
            whole.attrs.update(source.attrs)
            for name, variable in source.variables.items():
                _create(whole, name, variable)
    finally:
        sample.unlink(missing_ok=True)


def _create(file: h5netcdf.File, name: str, like: h5netcdf.Variable) -> None:
    lengths = tuple(file.dimensions[dim].size for dim in like.dimensions)
    chunks = stored_chunks(lengths, like.dtype)
    layout = {"chunks": chunks, "compression": "gzip", "compression_opts": LEVEL} if chunks else {}
    dtype = h5py.string_dtype() if like.dtype.kind == "O" else like.dtype
    file.create_variable(name, like.dimensions, dtype, **layout).attrs.update(like.attrs)


def pieces(made: xr.Dataset, part: Part, layout: Mapping[str, Any]) -> Iterator[Piece]:
    """What a part of a dataset stores; what lies along none of its ranges is stored with the first."""
    for name, variable in ((str(name), each) for name, each in made.variables.items()):
        dims = tuple(map(str, variable.dims))
        if any(span.start for dim, span in part.items() if dim not in dims):
            continue
        place = tuple(part.get(dim, slice(None)) for dim in dims)
        values = np.asarray(variable.values)
        values = values.astype(np.int8) if values.dtype == bool else values
        if layout[name] and _whole_pieces(part, dims, layout[name]):
            yield from _compressed(name, values, place, layout[name])
        else:
            yield Piece(name, place, None, values)


def _whole_pieces(part: Part, dims: tuple[str, ...], chunk: tuple[int, ...]) -> bool:
    """Whether a part of a variable is made of stored pieces: a short last one ends the dimension."""
    if not set(part) <= set(dims):
        return False
    spans = [part.get(dim, slice(0, 0)) for dim in dims]
    return not any(span.start % step for span, step in zip(spans, chunk, strict=True))


def _compressed(
    name: str, values: np.ndarray[Any, Any], place: tuple[slice, ...], chunk: tuple[int, ...]
) -> Iterator[Piece]:
    """The stored pieces of a block, each padded to its whole shape as HDF5 has it."""
    starts = [range(0, n, step) for n, step in zip(values.shape, chunk, strict=True)]
    origin = [span.start or 0 for span in place]
    for corner in itertools.product(*starts):
        inside = values[tuple(slice(a, a + n) for a, n in zip(corner, chunk, strict=True))]
        whole = inside
        if inside.shape != chunk:
            whole = np.zeros(chunk, values.dtype)
            whole[tuple(map(slice, inside.shape))] = inside
        packed = zlib.compress(np.ascontiguousarray(whole).data, LEVEL)
        yield Piece(name, tuple(a + b for a, b in zip(origin, corner, strict=True)), packed, None)


def _store(variable: h5py.Dataset, piece: Piece) -> None:
    if piece.packed is None:
        variable[piece.place] = piece.values
    else:
        variable.id.write_direct_chunk(piece.place, piece.packed)


def _in_order(jobs: Iterable[Callable[[], Any]], threads: int) -> Iterator[Any]:
    """Results in order, computed by threads with a core each; no more are ahead than there are threads."""
    ahead: deque[Future[Any]] = deque()
    with ThreadPoolExecutor(threads, initializer=CORES.set, initargs=(1,)) as pool:
        try:
            for job in jobs:
                ahead.append(pool.submit(job))
                if len(ahead) > threads:
                    yield ahead.popleft().result()
            while ahead:
                yield ahead.popleft().result()
        finally:
            pool.shutdown(wait=True, cancel_futures=True)
