"""The code that a job of the workflow runs: its change makes the job's results stale.

Snakemake follows a script, not what it imports. A job has the digest of its modules among its parameters;
the files themselves, a hundred inputs a job, would be looked at again each time that a job is chosen.
"""

from __future__ import annotations

import hashlib
from functools import cache
from importlib.util import find_spec
from pathlib import Path

import grimp

PACKAGE = "planar_pushing"


@cache
def _imports() -> grimp.ImportGraph:
    return grimp.build_graph(PACKAGE, cache_dir=None)


def modules(*names: str) -> list[str]:
    """These modules of the package and all that they import, sorted."""
    graph = _imports()
    reached = {f"{PACKAGE}.{name}" for name in names}
    for name in tuple(reached):
        reached |= graph.find_upstream_modules(name)
    return sorted(reached)


@cache
def _digest(module: str) -> bytes:
    spec = find_spec(module)
    if spec is None or spec.origin is None:
        raise ModuleNotFoundError(module)
    return hashlib.sha256(Path(spec.origin).read_bytes()).digest()


@cache
def code_of(*names: str) -> str:
    """Digest of the names and the source of `modules`."""
    whole = hashlib.sha256()
    for module in modules(*names):
        whole.update(module.encode() + _digest(module))
    return whole.hexdigest()
