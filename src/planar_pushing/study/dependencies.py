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
    """These modules of the package, the packages around them, and all that they import, sorted."""
    graph = _imports()
    asked = {f"{PACKAGE}.{name}" for name in names}
    for name in tuple(asked):
        parts = name.split(".")
        asked |= {".".join(parts[:i]) for i in range(2, len(parts))}
    reached = asked.union(*map(graph.find_upstream_modules, asked))
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
