"""Ratios of a candidate's time to a floor's, taken in turns, and their table at the end.

Times are those of the processor, so that other programs on the machine count as little as can be.
"""

from __future__ import annotations

import statistics
import time

import pytest

RATIOS: list[tuple[str, float, float]] = []


class Ratio:
    """Measures ratios of times, and fails beyond twice the bar."""

    def __init__(self, benchmark, name):
        self.benchmark, self.name = benchmark, name

    def __call__(self, candidate, floor, bar, *, scale=1.0, rounds=25):
        """Time `candidate` with `floor` before each round; the median ratio counts."""
        taken = []

        def run_floor():
            start = time.process_time()
            floor()
            taken.append(time.process_time() - start)

        self.benchmark.pedantic(candidate, setup=run_floor, rounds=rounds, warmup_rounds=1)
        pairs = zip(self.benchmark.stats.stats.data, taken[-rounds:], strict=True)
        self.write(scale * statistics.median(mine / floors for mine, floors in pairs), bar)

    def write(self, found, bar):
        """Keep a ratio for the table."""
        self.benchmark.extra_info["ratio"], self.benchmark.extra_info["bar"] = found, bar
        RATIOS.append((self.name, found, bar))
        assert found <= 2 * bar


@pytest.fixture
def ratio(benchmark, request):
    return Ratio(benchmark, request.node.name)


def pytest_terminal_summary(terminalreporter):
    if RATIOS:
        terminalreporter.section("time as a multiple of the floor's")
    for name, found, bar in RATIOS:
        terminalreporter.write_line(f"{name:64} {found:10.3f}   bar {bar:g}")
