"""What is known of a figure before it is drawn."""

from __future__ import annotations

from dataclasses import dataclass

#: Widths of a journal's column and page, inches.
COLUMN_WIDTH = 3.4
PAGE_WIDTH = 7.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure:
    """Entry of a figure: the one place that registers it.

    Attributes
    ----------
    name : str
        Name of its files in results/figures.
    drawing : str
        What draws it: a module of this package, or an object in one, as "module:object".
    datasets : tuple of str
        What it is drawn from, as "dataset" or "dataset/group".
    size : tuple of float
        Width and height, inches.
    takes : tuple of str
        Values that it takes from the study.
    needs : str, optional
        Effects without which it is not drawn; the others show what there is.
    section : str
        Section of the paper in which it stands.
    caption : str
        Our caption.
    promise : str
        What the paper's caption promises, in our words; empty for a figure of ours.
    """

    name: str
    drawing: str
    datasets: tuple[str, ...]
    size: tuple[float, float]
    takes: tuple[str, ...] = ()
    needs: str | None = None
    section: str = ""
    caption: str = ""
    promise: str = ""

    @property
    def module(self) -> str:
        """Module that draws it."""
        return self.drawing.partition(":")[0]

    def groups(self, dataset: str) -> tuple[str, ...]:
        """Groups of a dataset that it is drawn from."""
        parts = (each.partition("/") for each in self.datasets)
        return tuple(group for stem, _, group in parts if stem == dataset)


def by_name(*figures: Figure) -> dict[str, Figure]:
    """Table of figures by their names, in the order given."""
    return {figure.name: figure for figure in figures}
