"""An array of supports: one support in many frames, those of an object's contacts."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics.plane import Array, Frame, labeled_like

#: Types of supports whose pieces move rigidly with them, which need not hold for a user's own types.
KINDS: set[type] = set()


class SupportInFrames:
    """An array of supports: one support, expressed in each of an array of frames.

    The mechanics reads the support and the frames. Everything else sees the array of supports, or the
    DataArray if the frames are labeled.

    Parameters
    ----------
    support : Support
        With a method `in_frame`.
    frame : Frame
        Its numbers are arrays of one shape.
    """

    def __init__(self, support: Any, frame: Frame) -> None:
        self.support, self.frame = support, frame

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the array."""
        return self.frame.shape

    @property
    def ndim(self) -> int:
        """Number of dimensions of the array."""
        return len(self.shape)

    @property
    def size(self) -> int:
        """Number of supports."""
        return int(np.prod(self.shape))

    @property
    def origins(self) -> Array:
        """Origins of the frames, shape (size, 2)."""
        return np.column_stack([np.ravel(coordinate) for coordinate in self.frame.origin])

    @property
    def axes(self) -> Array:
        """Directions of the x axes of the frames, shape (size, 2)."""
        return np.column_stack([np.ravel(coordinate) for coordinate in self.frame.axis])

    @property
    def is_rigid(self) -> bool:
        """Whether the pieces of the supports are those of the support, expressed in the frames."""
        return _is_rigid(self.support)

    @property
    def frames(self) -> list[Frame]:
        """The frames, in a flat list."""
        rows = np.column_stack([self.origins, self.axes]).tolist()
        return [Frame((x, y), (a, b)) for x, y, a, b in rows]

    @cached_property
    def supports(self) -> list[Any]:
        """The supports, in a flat list."""
        return [self.support.in_frame(frame) for frame in self.frames]

    @cached_property
    def array(self) -> Any:
        """The array of supports."""
        return self.alike(self.__array__())

    def alike(self, values: npt.NDArray[Any]) -> Any:
        """Values over the frames, with their labels."""
        return labeled_like(self.frame.axis[0], values)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        supports = np.empty(self.size, dtype=object)
        for i, support in enumerate(self.supports):
            supports[i] = support
        return supports.reshape(self.shape)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self.array, name)

    def __len__(self) -> int:
        return self.shape[0]

    def __getitem__(self, key: Any) -> Any:
        return self.array[key]

    def __repr__(self) -> str:
        return repr(self.array)


def _is_rigid(support: Any) -> bool:
    members = getattr(support, "members", ())
    return type(support) in KINDS and all(_is_rigid(member) for _, member in members)


def flatten_supports(support: Any) -> Any:
    """The supports of an array, flattened; a single support counts as an array of one."""
    if type(support) in KINDS:
        return (support,)
    if isinstance(support, SupportInFrames):
        return support
    return np.ravel(np.array(support, dtype=object))
