"""What a job of a dataset asks for, by the number of its points: threads, memory and time."""

from __future__ import annotations

import math

#: Points for which a job takes another thread, and the most threads that it keeps busy.
POINTS_PER_THREAD, MOST_THREADS = 2**20, 4
#: Megabytes of a job, and of each of its threads (measured: 240, and 110 for contact modes).
MEMORY, MEMORY_PER_THREAD = 320, 160
#: Minutes of a job, and seconds of a point: ten times what contact modes take on a slow core.
MINUTES, SECONDS_PER_POINT = 10, 5e-5


def threads(points: int) -> int:
    """Threads that a job of so many points keeps busy."""
    return min(max(math.ceil(points / POINTS_PER_THREAD), 1), MOST_THREADS)


def memory(points: int, cores: int) -> int:
    """Megabytes that a job of so many points takes on so many cores."""
    return MEMORY + MEMORY_PER_THREAD * min(cores, MOST_THREADS)


def minutes(points: int) -> int:
    """Minutes after which a job of so many points has failed, on one core."""
    return MINUTES + math.ceil(points * SECONDS_PER_POINT / 60)
