"""A sheet on which the picture keeps its place and direction while a contact is dragged."""

from __future__ import annotations

from planar_pushing.drawing.canvas.marks import Positions, Sheet
from planar_pushing.mechanics.plane import Array, Frame


class TurnedSheet(Sheet):
    """A sheet of a picture in another frame.

    The object rests on the sheet while its contact is dragged, although the picture, whose origin is the
    contact, moves and turns.
    """

    frame: Frame

    @classmethod
    def of(cls, sheet: Sheet, frame: Frame) -> TurnedSheet:
        """Sheet that shows a picture in a frame, which is expressed in the frame of the given sheet."""
        turned = cls(*sheet)
        turned.frame = frame
        return turned

    def to_sheet(self, positions: Positions) -> Array:
        """Positions on the sheet, y downward from its upper left corner."""
        return super().to_sheet(self.frame.point_out(positions))

    def to_scene(self, positions: Positions) -> Array:
        """Positions in the scene of positions on the sheet."""
        return self.frame.point_in(super().to_scene(positions))
