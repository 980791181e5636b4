"""The owner of a folder in which the workflow runs.

Snakemake notes a run by files, which stay when the run is killed. The operating system knows better: its
lock goes with the process that holds it. Whoever gets it clears what a killed run has left.
"""

from __future__ import annotations

import fcntl
from pathlib import Path
from typing import IO

#: Locks that this process holds, kept open until it ends.
_HELD: dict[Path, IO[str]] = {}


def own_the_folder(folder: str | Path) -> bool:
    """Become the owner of Snakemake's folder, and clear the locks of runs that are gone.

    Returns
    -------
    bool
        False where a run that is alive owns it: Snakemake then says so, or this is one of its jobs.
    """
    place = Path(folder).resolve()
    if place in _HELD:
        return True
    place.mkdir(parents=True, exist_ok=True)
    file = (place / "owner").open("a", encoding="utf-8")
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        file.close()
        return False
    _HELD[place] = file
    for lock in (place / "locks").glob("*.lock"):
        lock.unlink(missing_ok=True)
    return True
