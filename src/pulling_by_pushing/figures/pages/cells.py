"""Cells of a page: they run in their order, and print and draw as in a notebook."""

from __future__ import annotations

import ast
import contextlib
import io
import os
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import matplotlib as mpl
from PIL import Image

from planar_pushing.drawing.canvas.style import STYLE_SHEET

#: Pixels per inch of a picture, and its number of colors.
DPI, COLORS = 110, 48
#: Width of printed tables, characters.
WIDTH = 110


class Shown(NamedTuple):
    """Output of a cell: its text and its pictures."""

    text: str
    pictures: tuple[Image.Image, ...]


def run_cells(cells: list[str], results: Path) -> Iterator[Shown]:
    """Run cells in their order, in a folder that holds the results, and yield what each shows.

    Open figures, which would count as those of the first cell, are closed.
    """
    import matplotlib.pyplot as plt
    import pandas as pd

    names: dict[str, Any] = {}
    with (
        tempfile.TemporaryDirectory() as folder,
        mpl.rc_context(),
        pd.option_context("display.width", WIDTH),
    ):
        mpl.rcdefaults()
        mpl.rc_file(STYLE_SHEET)
        mpl.use("agg")
        plt.close("all")
        Path(folder, "results").symlink_to(results.resolve())
        for code in cells:
            with _working_in(folder):
                yield Shown(_run(code, names).replace(os.path.realpath(folder), "..."), _pictures())


@contextlib.contextmanager
def _working_in(folder: str) -> Iterator[None]:
    """A folder as the working folder."""
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


def _run(code: str, names: dict[str, Any]) -> str:
    """Run a cell; what it prints, and the value of its last expression, unless it ends in a semicolon."""
    tree, printed = ast.parse(code), io.StringIO()
    last = tree.body[-1] if tree.body else None
    shows = isinstance(last, ast.Expr) and not code.rstrip().endswith(";")
    body = tree.body[:-1] if shows else tree.body
    with contextlib.redirect_stdout(printed):
        exec(compile(ast.Module(body, []), "cell", "exec"), names)
        if shows and isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
            if value is not None:
                print(repr(value))
    return printed.getvalue()


def _pictures() -> tuple[Image.Image, ...]:
    """The open figures as pictures; they are closed."""
    import matplotlib.pyplot as plt

    pictures = []
    for number in plt.get_fignums():
        file = io.BytesIO()
        plt.figure(number).savefig(file, format="png", dpi=DPI, facecolor="white")
        pictures.append(Image.open(file).convert("RGB").quantize(COLORS, dither=Image.Dither.NONE))
    plt.close("all")
    return tuple(pictures)
