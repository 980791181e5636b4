"""Ratios of a candidate's time to a floor's, taken in turns, and their table at the end."""

from __future__ import annotations

import time

import pytest

RATIOS: list[tuple[str, float, float]] = []


@pytest.fixture
def ratio(benchmark, request):
    """Time `candidate` with `floor` before each round; least time over least time, and its limit."""

    def measure(candidate, floor, limit, *, scale=1.0, rounds=40):
        taken = []

        def run_floor():
            start = time.perf_counter()
            floor()
            taken.append(time.perf_counter() - start)

        benchmark.pedantic(candidate, setup=run_floor, rounds=rounds, warmup_rounds=2)
        found = scale * benchmark.stats.stats.min / min(taken)
        benchmark.extra_info["ratio"], benchmark.extra_info["limit"] = found, limit
        RATIOS.append((request.node.name, found, limit))
        return found

    return measure


def pytest_terminal_summary(terminalreporter):
    if RATIOS:
        terminalreporter.section("time as a multiple of the floor's")
    for name, found, limit in RATIOS:
        terminalreporter.write_line(f"{name:64} {found:10.6f}   at most {limit:g}")
