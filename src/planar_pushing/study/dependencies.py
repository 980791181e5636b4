"""The modules whose change makes a job of the workflow stale."""

from __future__ import annotations

from functools import cache
from importlib.util import find_spec
from pathlib import Path

import grimp

PACKAGE = "planar_pushing"


@cache
def _imports() -> grimp.ImportGraph:
    return grimp.build_graph(PACKAGE, cache_dir=None)


def modules(*names: str) -> list[str]:
    """Source files of these modules of the package and of all that they import, sorted."""
    graph = _imports()
    reached = {f"{PACKAGE}.{name}" for name in names}
    for name in tuple(reached):
        reached |= graph.find_upstream_modules(name)
    return sorted(_source(name) for name in reached)


def _source(module: str) -> str:
    spec = find_spec(module)
    path, here = Path(str(spec.origin if spec else module)), Path.cwd()
    return str(path.relative_to(here) if path.is_relative_to(here) else path)
