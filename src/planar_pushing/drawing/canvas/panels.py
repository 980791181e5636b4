"""Pictures in the rows of a figure, cropped to their marks, so that little white remains around them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from planar_pushing.drawing.canvas.axes import onto, schematic
from planar_pushing.drawing.canvas.colors import DARK
from planar_pushing.drawing.canvas.labels import settle
from planar_pushing.drawing.canvas.marks import (
    Area,
    Arrow,
    Dot,
    Hatch,
    Label,
    Mark,
    Picture,
    Sheet,
)
from planar_pushing.mechanics.plane import Array

#: White around the marks of a figure, between its panels, and height of a row of titles, in points.
EDGE, GAP, TITLE = 3.0, 14.0, 15.0
#: Room around the other marks in which labels settle, in points.
ROOM = 45.0
#: Rounds of settling labels and scaling, and steps to a scale.
ROUNDS, STEPS = 2, 20


class Texts:
    """The boxes of texts about their positions in points, each measured once.

    A box does not depend on the scale of a picture. It depends on the resolution, to which letters snap,
    and on the style in which the first such text is measured.

    Parameters
    ----------
    dpi : float
        Dots per inch of the figure.
    """

    def __init__(self, dpi: float) -> None:
        self._page = Figure(dpi=dpi)
        FigureCanvasAgg(self._page)  # has one renderer, where a bare figure makes one for each text
        self._boxes: dict[tuple[str, float, str], Array] = {}

    def box(self, label: Label) -> Array:
        """Lower left and upper right corner of a label in points from its position, shape (2, 2)."""
        key = label.text, label.size, label.align
        if key not in self._boxes:
            self._boxes[key] = self._measure(*key)
        return np.asarray(self._boxes[key] + label.offset)

    def _measure(self, text: str, size: float, align: str) -> Array:
        artist = self._page.text(
            0.0, 0.0, text, fontsize=size, ha=align, va="center", linespacing=0.95
        )
        box = artist.get_window_extent().get_points() * 72 / self._page.dpi
        artist.remove()
        return np.asarray(box)


class Extents(NamedTuple):
    """The boxes of marks at every scale: corners in the scene, and what pens and texts add to them.

    Both have shape (mark, corner, xy), the second in points. The head of an arrow has a size in points
    but a direction in the scene, so that the box of an arrow is formed anew at each scale.
    """

    scene: Array
    paper: Array
    arrows: tuple[Arrow, ...]

    @classmethod
    def of(cls, texts: Texts, marks: Sequence[Mark]) -> Extents:
        """Extents of marks, with the sizes of their texts."""
        arrows = tuple(mark for mark in marks if isinstance(mark, Arrow))
        boxes = [_parts(texts, mark) for mark in marks if not isinstance(mark, Arrow)]
        scene, paper = np.reshape(boxes, (-1, 2, 2, 2)).swapaxes(0, 1)
        return cls(scene, paper, arrows)

    def corners(self, scale: float) -> Array:
        """Lower left and upper right corner of all marks, in points from the scene's origin."""
        boxes = np.concatenate(
            [scale * self.scene + self.paper, *(_arrow_box(arrow, scale) for arrow in self.arrows)]
        )
        return np.array([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])


def _parts(texts: Texts, mark: Mark) -> Array:
    """Corners of a mark in the scene, and what its pen or its text adds in points; shape (2, 2, 2)."""
    if isinstance(mark, Label):
        return np.array([[mark.position, mark.position], texts.box(mark)])
    if isinstance(mark, Area):
        points, rim = np.concatenate(mark.rings), 0.0
    elif isinstance(mark, Hatch):
        points, rim = mark.strokes.reshape(-1, 2), mark.width / 2
    elif isinstance(mark, Dot):
        points, rim = mark.position[None], (mark.size + mark.width) / 2
    else:
        points, rim = mark.points, mark.width / 2
    return np.array([[points.min(axis=0), points.max(axis=0)], [(-rim, -rim), (rim, rim)]])


def _arrow_box(arrow: Arrow, scale: float) -> Array:
    """Corners of an arrow in points from the scene's origin, shape (1, 2, 2)."""
    points, rim = np.concatenate(arrow.shape(1 / scale)), arrow.width / 2
    return np.array([[scale * points.min(axis=0) - rim, scale * points.max(axis=0) + rim]])


class Cropped(NamedTuple):
    """A picture with its labels in place, points per unit, and the corners of all marks.

    The corners have shape (2, 2), in points from the origin of the scene.
    """

    picture: Picture
    scale: float
    box: Array

    @property
    def size(self) -> Array:
        """Width and height in points."""
        return np.asarray(np.ptp(self.box, axis=0))

    def draw(self, figure: Figure, left: float, low: float) -> Axes:
        """Draw the picture on new axes, with their lower left corner at a position in points."""
        size, middle = self.size, self.box.mean(axis=0) / self.scale
        paper = 72 * figure.get_size_inches()
        ax = schematic(figure, (*(np.array([left, low]) / paper), *(size / paper)))
        sheet = Sheet(middle, self.scale, size, 1.0)
        (x_low, y_low), (x_high, y_high) = sheet.box
        ax.set(xlim=(x_low, x_high), ylim=(y_low, y_high))
        onto(self.picture, ax, sheet)
        return ax


def crop(texts: Texts, picture: Picture, wide: float = 0.0, scale: float | None = None) -> Cropped:
    """Crop a picture to its marks.

    Parameters
    ----------
    texts : Texts
        Sizes of texts on the figure on which it will be drawn.
    picture : Picture
    wide : float, optional
        Width of the marks with their labels, in points; the default is for a known scale.
    scale : float, optional
        Points per unit of the scene; by default the picture fills the width.
    """
    marks: Sequence[Mark] = picture.marks
    bare = Extents.of(texts, [mark for mark in marks if not isinstance(mark, Label)])
    full, points = bare, scale or _filling_scale(bare, wide, 1.0)
    for _ in range(ROUNDS):
        box = bare.corners(points)
        sheet = Sheet(box.mean(axis=0) / points, points, np.ptp(box, axis=0) + 2 * ROOM, 1.0)
        marks = _settle_labels(picture, sheet)
        full = Extents.of(texts, marks)
        points = scale or _filling_scale(full, wide, points)
    return Cropped(Picture(list(marks)), points, full.corners(points))


def _settle_labels(picture: Picture, sheet: Sheet) -> list[Mark]:
    """Marks of a picture, with labels that stay where they settle on a sheet."""
    labels = iter(settle(picture, sheet))
    return [
        next(labels)._replace(held=True) if isinstance(mark, Label) else mark
        for mark in picture.marks
    ]


def _filling_scale(extents: Extents, wide: float, start: float) -> float:
    """Scale at which marks have a width in points, by steps from a positive scale."""
    scale = start
    for _ in range(STEPS):
        factor = wide / float(np.ptp(extents.corners(scale)[:, 0]))
        if factor == 1.0:
            break
        scale *= factor
    return scale


class Panel(NamedTuple):
    """A picture with its title, and the name of the scale that it shares with other panels, if any."""

    picture: Picture
    title: str = ""
    scale: str = ""


def panels(
    figure: Figure, contents: Sequence[Panel], columns: int = 1, *, scale: float | None = None
) -> list[Axes]:
    """Draw pictures in a grid, cropped to their marks, and fit the height of the figure to them.

    The panels of a row show y = 0, the line of a fence, at one height.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
    contents : sequence of Panel
    columns : int
        Number of panels in a row.
    scale : float, optional
        Points per unit of the scene; by default the panels fill the columns.
    """
    wide = (72 * figure.get_figwidth() - 2 * EDGE - (columns - 1) * GAP) / columns
    pictures = _to_scale(Texts(figure.dpi), contents, wide, scale)
    title = TITLE if any(panel.title for panel in contents) else 0.0
    rows = [range(i, min(i + columns, len(contents))) for i in range(0, len(contents), columns)]
    above = [max(pictures[i].box[1, 1] for i in row) for row in rows]
    below = [min(pictures[i].box[0, 1] for i in row) for row in rows]
    spaces = GAP * (len(rows) - 1) + 2 * EDGE
    high = float(sum(above) - sum(below)) + title * len(rows) + spaces
    figure.set_figheight(high / 72)
    axes, top = [], high - EDGE
    for row, up, down in zip(rows, above, below, strict=True):
        level = top - title - up
        for column, index in enumerate(row):
            picture = pictures[index]
            middle = EDGE + column * (wide + GAP) + wide / 2
            low = level + picture.box[0, 1]
            axes.append(picture.draw(figure, middle - picture.size[0] / 2, low))
            _add_title(figure, contents[index].title, middle, top)
        top = level + down - GAP
    return axes


def _to_scale(
    texts: Texts, contents: Sequence[Panel], wide: float, scale: float | None
) -> list[Cropped]:
    """Pictures of the panels: as wide as allowed, and at one scale if they share its name."""
    pictures = [crop(texts, panel.picture, wide, scale) for panel in contents]
    for name in {panel.scale for panel in contents} - {""}:
        shared = [i for i, panel in enumerate(contents) if panel.scale == name]
        smallest = min(pictures[i].scale for i in shared)
        for i in shared:
            pictures[i] = crop(texts, contents[i].picture, wide, smallest)
    return pictures


def _add_title(figure: Figure, title: str, middle: float, top: float) -> None:
    """Add the title of a panel, below a height in points."""
    if title:
        wide, high = 72 * figure.get_size_inches()
        figure.text(middle / wide, top / high, title, ha="center", va="top", color=DARK)
