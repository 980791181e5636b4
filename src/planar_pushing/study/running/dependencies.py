"""The code that a job of the workflow runs: its change makes the job's results stale.

Snakemake follows a script, not what it imports. A job has the digest of its modules among its parameters;
the files themselves, a hundred inputs a job, would be looked at again each time that a job is chosen.
"""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import planar_pushing
from planar_pushing.terms.extras import require_extra

if TYPE_CHECKING:
    import grimp

PACKAGE = "planar_pushing"


@cache
def _imports() -> grimp.ImportGraph:
    require_extra("workflow")
    import grimp

    return grimp.build_graph(PACKAGE, cache_dir=None)


def modules(*names: str) -> list[str]:
    """These modules of the package and all that they import, sorted.

    With a module Python imports the packages around it, and what those import.
    """
    graph, reached = _imports(), set()
    ahead = {f"{PACKAGE}.{name}" for name in names}
    while ahead:
        reached |= ahead
        near = {each for name in ahead for each in graph.find_modules_directly_imported_by(name)}
        near |= {name.rpartition(".")[0] for name in ahead}
        ahead = near - reached - {PACKAGE}
    return sorted(reached)


@cache
def _digest(module: str) -> bytes:
    # Its file by its name: to look the module up would import the package around it.
    path = Path(planar_pushing.__path__[0]).joinpath(*module.split(".")[1:])
    source = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    return hashlib.sha256(source.read_bytes()).digest()


@cache
def code_of(*names: str) -> str:
    """Digest of the names and the source of `modules`."""
    whole = hashlib.sha256()
    for module in modules(*names):
        whole.update(module.encode() + _digest(module))
    return whole.hexdigest()
