"""Limit curves on grids of any size, in blocks of any size.

A grid of N points has `ROD_LENGTHS` times N / 10 force angles. Values go to a file block by block, so that
memory depends on the block alone.
"""

from __future__ import annotations

import tracemalloc
from pathlib import Path

import h5py
import numpy as np

from planar_pushing.evidence.costs.errors import angle_errors
from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.limit_curve import limit_curve
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, Slider
from planar_pushing.study.storage.blocks import blocks

ROD_LENGTHS = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0)
ROD_ANGLE = np.pi / 4
SIZES = tuple(10**n for n in range(3, 8))
BLOCKS = tuple(4**n for n in range(4, 10))
#: Grid on which block sizes are compared, and block in which grid sizes are.
SIZE = 10**6
BLOCK = 2**16
#: Points at which a grid is held against certified values.
CHECKED = 60


def scene(rod_length: float) -> Scene:
    """The paper's ring under friction, with this rod."""
    slider = Slider(rod_length=rod_length, rod_angle=ROD_ANGLE)
    return Scene(slider=slider, contact=InfiniteFriction(), effects=(RingFriction(),))


def write_grid(size: int, block: int, path: Path) -> None:
    """Compute forces and motion angles on a grid of `size` points, `block` at a time, into a file."""
    count = size // len(ROD_LENGTHS)
    with h5py.File(path, "w") as file:
        shape = (len(ROD_LENGTHS), count)
        force, motion = (file.create_dataset(name, shape, "f8") for name in ("force", "motion"))
        for row, length in enumerate(ROD_LENGTHS):
            here = scene(length)
            for part in blocks(count, block):
                curve = limit_curve(here, force_angles(count, part))
                force[row, part], motion[row, part] = curve.magnitude, curve.motion_angle


def force_angles(count: int, part: slice | None = None) -> Array:
    """Force angles at the centers of `count` equal parts of the turn, or a slice of them, radians."""
    index = np.arange(*part.indices(count)) if part else np.arange(count)
    return 2 * np.pi * (index + 0.5) / count


def peak_memory(size: int, block: int, path: Path) -> int:
    """Largest memory that numpy and Python hold while a grid is written, bytes."""
    tracemalloc.start()
    try:
        write_grid(size, block, path)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def grid_errors(path: Path) -> tuple[float, float]:
    """Largest errors of a grid's motion angles, degrees: at its points, and half way between two.

    Half way the grid is interpolated linearly over the force angle; both are taken at `CHECKED` places,
    spread over the grid.
    """
    with h5py.File(path, "r") as file:
        motion = file["motion"]
        count = motion.shape[1]
        rows = np.arange(CHECKED) % len(ROD_LENGTHS)
        columns = ((np.arange(CHECKED) + 0.5) * (count - 1) / CHECKED).astype(int)
        pairs = np.array([motion[r, c : c + 2] for r, c in zip(rows, columns, strict=True)])
    lengths, angles = np.array(ROD_LENGTHS)[rows], force_angles(count)
    between = (angles[columns] + angles[columns + 1]) / 2
    at_points = angle_errors(pairs[:, 0], lengths, angles[columns], ROD_ANGLE)
    half_way = angle_errors(pairs.mean(axis=1), lengths, between, ROD_ANGLE)
    return float(at_points.max()), float(half_way.max())
