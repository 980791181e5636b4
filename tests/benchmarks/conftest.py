"""Ratios of a candidate's time to a floor's, taken in turns, and their table at the end.

Times are those of the processor, so that other programs on the machine count as little as can be.
"""

from __future__ import annotations

import statistics
import time

import pytest

RATIOS: list[tuple[str, float, float]] = []


@pytest.fixture
def ratio(benchmark, request):
    """Time `candidate` with `floor` before each round; the median ratio, against its limit."""

    def measure(candidate, floor, limit, *, scale=1.0, rounds=25):
        taken = []

        def run_floor():
            start = time.process_time()
            floor()
            taken.append(time.process_time() - start)

        benchmark.pedantic(candidate, setup=run_floor, rounds=rounds, warmup_rounds=2)
        pairs = zip(benchmark.stats.stats.data, taken[-rounds:], strict=True)
        found = scale * statistics.median(mine / floors for mine, floors in pairs)
        benchmark.extra_info["ratio"], benchmark.extra_info["limit"] = found, limit
        RATIOS.append((request.node.name, found, limit))
        return found

    return measure


def pytest_terminal_summary(terminalreporter):
    if RATIOS:
        terminalreporter.section("time as a multiple of the floor's")
    for name, found, limit in RATIOS:
        terminalreporter.write_line(f"{name:64} {found:10.6f}   at most {limit:g}")
