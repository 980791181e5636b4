"""Times of repeated calls in one process, and the machine that they were taken on."""

from __future__ import annotations

import os
import platform
import time
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path

import numpy as np

from planar_pushing.mechanics.planar import Array

#: Repeats that are kept of every measurement; one more, the first, warms up.
REPEATS = 7
PACKAGES = ("planar-pushing", "numpy", "scipy", "h5py", "python-flint")


def seconds(call: Callable[[], object], repeats: int = REPEATS) -> Array:
    """Durations of repeated calls after one that does not count, shape (repeats,)."""
    call()
    taken = np.empty(repeats)
    for index in range(repeats):
        start = time.perf_counter()
        call()
        taken[index] = time.perf_counter() - start
    return taken


def machine() -> dict[str, str]:
    """Processor, number of cores, operating system and versions; nothing that names the host."""
    return {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        **{name: version(name) for name in PACKAGES},
    }


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    if info.is_file():
        for line in info.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or "unknown"
