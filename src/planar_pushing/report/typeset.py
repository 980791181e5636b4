"""Set a Typst source as a PDF whose bytes depend on what it reads alone."""

from __future__ import annotations

import re
from importlib.metadata import distribution
from pathlib import Path

import typst

from planar_pushing.study.files.replacing import PathLike, replacing
from planar_pushing.terms.errors import InvalidFile

#: The figures' fonts, which ship with matplotlib; so text and pictures have one family.
FONTS = str(distribution("matplotlib").locate_file("matplotlib/mpl-data/fonts/ttf"))


def compiled(source: PathLike, root: PathLike, results: str = "results") -> bytes:
    """Set a source as a PDF, with the fonts of the figures and those that Typst ships.

    Parameters
    ----------
    source : path
        The Typst file.
    root : path
        The folder that holds all that it reads.
    results : str
        The folder of the results, from `root`.

    Raises
    ------
    InvalidFile
        Where the source cannot be set, or is set with a warning such as a missing font.
    """
    if not Path(source).is_file():
        raise InvalidFile(f"{source}: no such file; give the path of a Typst source")
    compiler = typst.Compiler(
        input=str(source),
        root=str(root),
        ignore_system_fonts=True,
        font_paths=[FONTS],
        sys_inputs={"results": f"/{results}"},
    )
    try:
        pdf, warnings = compiler.compile_with_warnings(format="pdf", timestamp=0)
    except typst.TypstError as error:
        raise InvalidFile(_explain(source, error)) from None
    for warning in warnings:
        raise InvalidFile(_explain(source, warning))
    if not isinstance(pdf, bytes):
        raise InvalidFile(f"{source}: was not set as one PDF; set its output to paged")
    return pdf


def _explain(source: PathLike, fault: typst.TypstError | typst.TypstWarning) -> str:
    """One line: the place that a fault comes from, what it is, and what helps."""
    places = re.findall(r"┌─ (\S+)", fault.diagnostic)
    said = fault.message.removeprefix("assertion failed: ").removeprefix("panicked with: ")
    return "; ".join([f"{places[-1] if places else source}: cannot be set: {said}", *fault.hints])


def typeset(source: PathLike, root: PathLike, output: PathLike, results: str = "results") -> None:
    """Write the PDF of a source, whole or not at all; errors as in `compiled`."""
    pdf = compiled(source, root, results)
    with replacing(output) as temporary:
        temporary.write_bytes(pdf)
