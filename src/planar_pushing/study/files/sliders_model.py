"""What the file of a study of sliders holds: supports side by side, over one grid."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import BeforeValidator, Field

from planar_pushing.study.files.fields import (
    Angles,
    Coordinates,
    FileModel,
    FilePath,
    FrictionCoefficients,
    Lengths,
    Name,
    Positive,
    RodAngle,
    RodAngles,
    Text,
    refuse,
)
from planar_pushing.study.files.models import StudyFile
from planar_pushing.study.files.support_model import SupportEntry

#: The key that only a study of sliders has.
KEY = "supports"


def _gallery(given: object) -> object:
    if not isinstance(given, dict) or not given:
        raise refuse("a mapping of at least one name to a support")
    return given


class RodEntry(FileModel):
    """The rod where a figure has no axis for it."""

    rod_length: Positive
    rod_angle: RodAngle


class SlidersGrid(FileModel):
    """The axes of the datasets; angles in degrees, centers of rotation in the body frame."""

    center_x: Coordinates
    center_y: Coordinates
    rod_length: Lengths
    rod_angle: RodAngles
    friction_coefficient: FrictionCoefficients
    pusher_angle: Angles


class SlidersFile(FileModel):
    """Supports by name, and the grid over which each is pushed; lengths in any one unit.

    `simulations` names the scene files with a section `simulate` that are followed over time. Paths are
    relative to the study's file.
    """

    title: Text
    slider: RodEntry
    supports: Annotated[dict[Name, SupportEntry], BeforeValidator(_gallery)]
    grid: SlidersGrid
    simulations: dict[Name, FilePath] = Field(default_factory=dict)
    golden: FilePath | None = None

    def gallery(self) -> dict[str, Any]:
        """Build the supports, by name."""
        return {name: entry.build() for name, entry in self.supports.items()}


#: A study of either kind.
Study = StudyFile | SlidersFile


def kind_of(content: object) -> type[Study]:
    """Model of a study, by what its file or a slice of it holds."""
    return SlidersFile if isinstance(content, Mapping) and KEY in content else StudyFile
