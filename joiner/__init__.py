"""Build the core: join its modules into one Cython module, which is compiled when the package is installed.

The joiner exists so that the compiled core has the bits of the plain source, which stays ordinary typed
Python without a `.pxd` file or a decorator. Every number and record is a value in C, never boxed in an
object of Python, because the joiner declares each type and leaves nothing to inference.

The language of the core is a small subset of Python, translated statement by statement. The joiner refuses
anything outside the language, and anything that would mean something else in C, with file, line and reason.
`compiler` knows the C compiler and tests what it made; `hook` is what the installation and make run.
"""

from __future__ import annotations

import ast
from pathlib import Path
from typing import NamedTuple

from .bodies import Body
from .language import MATH, RefusedSource
from .names import Names
from .order import check_order

__all__ = ["Joined", "RefusedSource", "join"]

KERNEL = "data: Numbers, rows: Numbers, count: int, columns: int, results: Numbers, width: int"


class Joined(NamedTuple):
    """The text of the module, the functions of `math` it can use, and the kernels that Python calls."""

    source: str
    math: list[str]
    kernels: list[str]


def join(folder: Path) -> Joined:
    """Join the modules of a folder, or raise `RefusedSource`."""
    names = Names(folder)
    bodies = [Body(names, function) for function in names.functions.values()]
    check_order(names, bodies)
    if names.refusals:
        lines = (f"{path}:{line}: {reason}" for path, line, reason in sorted(names.refusals))
        raise RefusedSource("\n".join(lines))
    kernels = [
        name for name, function in names.functions.items()
        if ast.unparse(function.args) == KERNEL and names.signatures[name][1] == "None"
    ]  # fmt: skip
    texts = [*names.structs_in_c(), *names.constants_in_c(), *(body.text() for body in bodies)]
    return Joined("\n".join(texts), [*MATH], kernels)
