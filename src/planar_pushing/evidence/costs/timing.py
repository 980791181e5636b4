"""Times of repeated calls in one process, and the machine that they were taken on."""

from __future__ import annotations

import json
import os
import platform
import time
from collections.abc import Callable, Sequence
from importlib.metadata import version
from pathlib import Path

import numpy as np
import xarray as xr

from planar_pushing.mechanics.plane import Array

#: Rounds that are kept; one more, the first, warms up.
REPEATS = 9
PACKAGES = ("planar-pushing", "numpy", "scipy", "h5py", "python-flint")


def seconds(calls: Sequence[Callable[[], object]], repeats: int = REPEATS) -> Array:
    """Durations of calls, taken in turns after a round that does not count, shape (calls, repeats).

    What else the machine does for a while then falls on few repeats of every call, not on all of one.
    """
    taken = np.empty((repeats + 1, len(calls)))
    for each in taken:
        for index, call in enumerate(calls):
            start = time.perf_counter()
            call()
            each[index] = time.perf_counter() - start
    return taken[1:].T


def machine() -> dict[str, str]:
    """Processor, number of cores, operating system and versions; nothing that names the host."""
    return {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        **{name: version(name) for name in PACKAGES},
    }


def stamped(measured: xr.Dataset) -> xr.Dataset:
    """Name the machine that a dataset was measured on."""
    return measured.assign_attrs(machine=json.dumps(machine()))


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    if info.is_file():
        for line in info.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or "unknown"
