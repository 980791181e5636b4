"""Typeset a Typst source, as a PDF or in HTML, with bytes that depend only on its inputs."""

from __future__ import annotations

import os
import re
from importlib.metadata import distribution
from pathlib import Path
from typing import Literal

import typst

from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.replacing import PathLike, replacing

#: The figures' fonts, which ship with matplotlib, so that text and figures use the same family.
FONTS = str(distribution("matplotlib").locate_file("matplotlib/mpl-data/fonts/ttf"))


#: What Typst says of every page in HTML.
EXPERIMENTAL = "html export is under active development and incomplete"


def typeset_pdf(source: PathLike, root: PathLike, results: str = "results") -> bytes:
    """Typeset a source as a PDF, with the fonts of the figures and those shipped with Typst.

    Parameters
    ----------
    source : path
        The Typst file.
    root : path
        The folder that contains all files that the source reads, except the results.
    results : str
        The folder of the results, relative to `root`, or the path of a folder elsewhere.

    Raises
    ------
    InvalidFile
        If the source cannot be typeset, or only with a warning, such as a missing font.
    """
    return _compile(source, root, results, "pdf")


def typeset_html(source: PathLike, root: PathLike, results: str = "results") -> str:
    """Typeset a source as a page in HTML, with formulas in MathML; parameters as in `typeset_pdf`."""
    return _compile(source, root, results, "html").decode("utf-8")


def _compile(
    source: PathLike, root: PathLike, results: str, output: Literal["pdf", "html"]
) -> bytes:
    if not Path(source).is_file():
        raise InvalidFile(f"{source}: no such file; give the path of a Typst source")
    top, place = _common_root(Path(root).resolve(), Path(root, results).resolve())
    compiler = typst.Compiler(
        input=str(source),
        root=str(top),
        ignore_system_fonts=True,
        font_paths=[FONTS],
        sys_inputs={"results": place},
    )
    try:
        content, warnings = compiler.compile_with_warnings(format=output, timestamp=0)
    except typst.TypstError as error:
        raise InvalidFile(_explain(source, error)) from None
    for warning in warnings:
        if warning.message != EXPERIMENTAL:
            raise InvalidFile(_explain(source, warning))
    if not isinstance(content, bytes):
        raise InvalidFile(f"{source}: was not typeset as one file; set its output to paged")
    return content


def _common_root(root: Path, results: Path) -> tuple[Path, str]:
    """Innermost folder with the sources and the results, and the path of the results from it."""
    top = Path(os.path.commonpath([root, results]))
    return top, f"/{results.relative_to(top).as_posix()}"


def _explain(source: PathLike, fault: typst.TypstError | typst.TypstWarning) -> str:
    """One-line message: the location of a fault, its description, and hints."""
    places = re.findall(r"┌─ (\S+)", fault.diagnostic)
    said = fault.message.removeprefix("assertion failed: ").removeprefix("panicked with: ")
    message = f"{places[-1] if places else source}: cannot be typeset: {said}"
    return "; ".join([message, *fault.hints])


def typeset(source: PathLike, root: PathLike, output: PathLike, results: str = "results") -> None:
    """Write the PDF of a source, completely or not at all; errors as in `typeset_pdf`."""
    pdf = typeset_pdf(source, root, results)
    with replacing(output) as temporary:
        temporary.write_bytes(pdf)
