"""Sizes, colors and the style sheet that all figures share."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import matplotlib.style

# From Okabe and Ito's palette, whose colors differ for every kind of color vision.
GREEN = "#009E73"
BLUE = "#0072B2"
VERMILION = "#D55E00"
DARK = "#333333"
GREY = "#777777"
LIGHT = "#BBBBBB"

#: What a color stands for, in every figure.
FORCE = VERMILION
MOTION = BLUE
PUSHER = GREEN
SLIP = "#B57A00"  # the palette's orange, darker: it also colors text
IMPACT = "#B40F0F"  # red, dark enough for text
CENTER = "#A0417B"  # a darker purple of the palette's hue: it also colors text
SLIDER = DARK
FENCE = DARK
GUIDE = GREY

#: zorder of arrows: above cones, ring and rod.
ABOVE = 5.0

SYMBOL_SIZE = 9.5
NOTE_SIZE = 7.5
STYLE_SHEET = Path(__file__).with_name("paper.mplstyle")


@contextmanager
def paper_style() -> Iterator[None]:
    """Draw and save inside with matplotlib's defaults and the style sheet, and nothing else."""
    with matplotlib.style.context(["default", str(STYLE_SHEET)]):
        yield
