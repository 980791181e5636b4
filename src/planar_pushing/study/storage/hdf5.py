"""Files of HDF5 that can be read: whole, of their own, and no larger than what they hold.

The sizes that a file declares are checked before it is read: it may be damaged or foreign.
"""

from __future__ import annotations

import os
import re
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

import h5py

from planar_pushing.study.files.replacing import PathLike
from planar_pushing.terms.errors import InvalidFile, PlanarPushingError

#: Most groups and variables of a file.
OBJECTS = 10**4
#: Most bytes that a byte of a file can stand for: what deflate reaches, by its manual.
EXPANSION = 1032
#: A global heap: its mark, its version, three zeros and its size; its objects' index and size.
HEAP = re.compile(rb"GCOL\x01\0\0\0.{8}", re.DOTALL)
#: Bytes that are searched at once: a file may be larger than the memory.
WINDOW = 2**24
SIZE, OBJECT, HEADER = struct.Struct("<Q"), struct.Struct("<H6xQ"), 16


@contextmanager
def readable(path: PathLike) -> Iterator[None]:
    """Look at a file before it is read; errors as in `reading`."""
    with reading(path):
        _look(path)
        yield


@contextmanager
def reading(path: PathLike) -> Iterator[None]:
    """Say of a file that cannot be read what is wrong with it; its values are read within.

    The libraries below answer damage with errors of any kind.
    """
    try:
        yield
    except PlanarPushingError:
        raise
    except FileNotFoundError:
        message = f"{path}: no such dataset; build it with make or snakemake"
        raise InvalidFile(message) from None
    except Exception as error:
        number = error.errno if isinstance(error, OSError) else None
        reason = f" ({os.strerror(number)})" if number else ""
        raise InvalidFile(
            f"{path}: is not a netCDF4 file{reason}; remove it and build it anew"
        ) from None


def _look(path: PathLike) -> None:
    """Refuse a file that refers to others, or declares more than it can hold."""
    _walk_heaps(path)
    declared = 0
    with h5py.File(path, "r") as file:
        for count, variable in enumerate(_variables(file)):
            declared += variable.nbytes
            if variable.external or variable.is_virtual:
                raise InvalidFile(
                    f"{path}: {variable.name} is stored elsewhere; remove it and build it anew"
                )
            if count > OBJECTS or declared > EXPANSION * Path(path).stat().st_size:
                raise InvalidFile(
                    f"{path}: declares more than it holds; remove it and build it anew"
                )


def _walk_heaps(path: PathLike) -> None:
    """Refuse a file in whose global heaps, which hold text and references, a size is wrong.

    The HDF5 library never returns from a heap in which an object's size overflows (section III.E of the
    format: a header of 16 bytes with the size of the collection; objects of an index, a size and data).
    """
    size = Path(path).stat().st_size
    with Path(path).open("rb") as file:
        for start in range(0, size, WINDOW):
            file.seek(start)
            content = file.read(WINDOW + HEADER)
            for heap in HEAP.finditer(content):
                _walk_heap(path, file, start + heap.start(), size)


def _walk_heap(path: PathLike, file: BinaryIO, start: int, size: int) -> None:
    """Go from object to object of the heap that begins at `start`; the next mark is read from there."""
    (whole,) = SIZE.unpack_from(_header(file, start), 8)
    place, end = start + HEADER, min(start + whole, size)
    while place + HEADER <= end:
        index, length = OBJECT.unpack_from(_header(file, place))
        # The size of free space, index 0, includes its header.
        step = HEADER + -(-length // 8) * 8 if index else length
        if not HEADER <= step <= end - place:
            raise InvalidFile(f"{path}: has a damaged heap; remove it and build it anew")
        place += step


def _header(file: BinaryIO, place: int) -> bytes:
    file.seek(place)
    return file.read(HEADER)


def _variables(file: h5py.File) -> Iterator[h5py.Dataset]:
    """The variables of a file and of its groups; links to other places are not followed."""
    groups: list[h5py.Group] = [file]
    seen = 0
    while groups and seen <= OBJECTS:
        group = groups.pop()
        for name in group:
            seen += 1
            if not isinstance(group.get(name, getlink=True), h5py.HardLink):
                raise InvalidFile(f"{file.filename}: {name} is a link; remove it and build it anew")
            found = group[name]
            if isinstance(found, h5py.Dataset):
                yield found
            elif isinstance(found, h5py.Group):
                groups.append(found)
