"""A plugin of pytest that runs the tests once without a change, then with each change in a fork of its own.

The tests are collected once. The first run records what each test costs, and the changes that it reaches;
a change is then tried only with files of tests that reach it, the cheapest first, until one fails.
"""

from __future__ import annotations

import json
import os
import resource
import select
import signal
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

#: Seconds of processor time for one test with a change, beside ten times its usual cost.
MOST_OF_ONE = 10.0
#: Seconds until a fork that only waits is ended, and bytes that it can have.
LONGEST, MEMORY = 900.0, 6 << 30
#: They compare the two forms of the core, which have the same change, or compile or join it.
LEFT_OUT = {
    "test_same_bits.py",
    "test_plain.py",
    "test_build.py",
    "test_joiner.py",
    "test_processes.py",
}
#: In the place of a failure, after the last test for which there was time.
LATE = "time"


class Loop:
    """The plugin.

    Parameters
    ----------
    numbers : list of int
        The changes to be tried.
    workers : int
        How many forks run at a time.
    report : callable
        Is called with the number of a change, what became of it, and the seconds of processor time.
    """

    def __init__(
        self, numbers: list[int], workers: int, report: Callable[[int, str, float], None], core: Any,
        baseline: Path, most: float,
    ) -> None:  # fmt: skip
        self.numbers, self.workers, self.report, self.core = numbers, workers, report, core
        self.baseline, self.most = baseline, most
        self.cost: dict[str, float] = {}
        self.reached: dict[str, list[int]] = {}

    def pytest_collection(self) -> None:
        """A failure is not made smaller."""
        from hypothesis import Phase, settings  # pytest has to import it first

        phases = [Phase.explicit, Phase.generate]
        settings.register_profile("mutants", settings.get_profile("reproducible"), phases=phases)
        settings.load_profile("mutants")

    def pytest_collection_modifyitems(self, items: list[pytest.Function]) -> None:
        """Leave out the tests that a change in both forms cannot fail."""
        items[:] = [
            item
            for item in items
            if item.path.name not in LEFT_OUT and "both" not in item.fixturenames
        ]

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """Run the tests without a change, then with each."""
        items = self._try_without_change(session.items)
        jobs = {k: (k, self._tests_of(k, items)) for k in self.numbers}
        for number, lines, ended in self._fork_all(jobs, True):
            used = sum(line.get("cost", 0.0) for line in lines)
            self.report(number, _fate(lines, ended, len(jobs[number][1])), used)
        return True

    def _try_without_change(self, items: list[pytest.Function]) -> list[pytest.Function]:
        """Record the cost of each test and what it reaches, unless known; return those that pass."""
        if self.baseline.exists():
            for line in self.baseline.read_text(encoding="utf-8").splitlines():
                self._take(json.loads(line))
        missing: dict[Path, list[pytest.Function]] = defaultdict(list)
        for item in items:
            if item.nodeid not in self.cost:
                missing[item.path].append(item)
        jobs = {k: (0, tests) for k, tests in enumerate(missing.values())}
        with self.baseline.open("a", encoding="utf-8") as file:
            for _, lines, ended in self._fork_all(jobs, False):
                for line in lines:
                    if "cost" in line:
                        file.write(json.dumps(line) + "\n")
                        self._take(line)
                    else:
                        print(f"without a change {line['test']} {ended}", flush=True)
                file.flush()
        passing = [item for item in items if item.nodeid in self.cost]
        total = sum(self.cost[item.nodeid] for item in passing)
        print(f"{len(passing)} tests, {total:.0f} s without a change", flush=True)
        return passing

    def _take(self, line: dict[str, Any]) -> None:
        """Remember a test, unless it fails without a change."""
        if line["failure"]:
            print(f"without a change {line['test']} fails: {line['failure']}", flush=True)
        else:
            self.cost[line["test"]], self.reached[line["test"]] = line["cost"], line["reached"]

    def _tests_of(self, number: int, items: list[pytest.Function]) -> list[pytest.Function]:
        """The tests in files that reach a change: first those that do, and the cheapest files."""
        by_file: dict[Path, list[pytest.Function]] = defaultdict(list)
        for item in items:
            by_file[item.path].append(item)
        order: list[tuple[bool, float, list[pytest.Function]]] = []
        for tests in by_file.values():
            hits = [item for item in tests if number in self.reached[item.nodeid]]
            if hits:
                rest = [item for item in tests if number not in self.reached[item.nodeid]]
                for part, later in ((hits, False), (rest, True)):
                    part = sorted(part, key=lambda item: self.cost[item.nodeid])
                    total = sum(self.cost[item.nodeid] for item in part)
                    order.append((later, total / max(1, len(part)), part))
        order.sort(key=lambda entry: entry[:2])
        return [item for _, _, part in order for item in part]

    def _fork_all(
        self, jobs: dict[int, tuple[int, list[pytest.Function]]], stops: bool
    ) -> Iterator[tuple[int, list[dict[str, Any]], str]]:
        """Run jobs, some at a time; yield the lines that each has written, and how it was ended."""
        waiting, running = list(jobs.items()), {}
        while waiting or running:
            while waiting and len(running) < self.workers:
                job, (number, items) = waiting.pop(0)
                reader, writer = os.pipe()
                pid = os.fork()
                if pid == 0:
                    os.close(reader)
                    self._run_tests(number, items, writer, stops)
                os.close(writer)
                running[reader] = (job, pid, bytearray(), time.monotonic())
            for reader in select.select([*running], [], [], 1.0)[0]:
                job, pid, text, _ = running[reader]
                new = os.read(reader, 1 << 16)
                text += new
                if not new:
                    os.close(reader)
                    del running[reader]
                    yield job, *_read(text, os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]))
            for _, pid, _, start in running.values():
                if time.monotonic() - start > LONGEST * (1 if stops else 10):
                    os.kill(pid, signal.SIGKILL)

    def _run_tests(
        self, number: int, items: list[pytest.Function], writer: int, stops: bool
    ) -> None:
        """Run tests in a fork with a change, write a line for each, and end the process."""
        watch = _Watch()
        try:
            os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
            os.dup2(1, 2)
            signal.signal(signal.SIGPROF, signal.SIG_DFL)
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            manager = items[0].config.pluginmanager
            manager.unregister(manager.get_plugin("terminalreporter"))
            manager.register(watch)
            self.core.choose(number)
            begin = time.process_time()
            for item, following in zip(items, [*items[1:], None], strict=True):
                test = item.nodeid
                os.write(writer, (json.dumps({"test": test}) + "\n").encode())
                self.core.take_reached()
                start = time.process_time()
                if stops:
                    signal.setitimer(signal.ITIMER_PROF, MOST_OF_ONE + 10.0 * self.cost[test])
                item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
                cost = time.process_time() - start
                late = stops and not watch.failure and time.process_time() - begin > self.most
                line = {"test": test, "cost": cost, "failure": LATE if late else watch.failure}
                line["reached"] = [] if stops else self.core.take_reached()
                os.write(writer, (json.dumps(line) + "\n").encode())
                if stops and line["failure"]:
                    break
                watch.failure = ""
        except BaseException as error:
            os.write(writer, (json.dumps({"test": repr(error)}) + "\n").encode())
            os._exit(3)
        os._exit(0)


def _read(text: bytearray, code: int) -> tuple[list[dict[str, Any]], str]:
    """The lines of a fork, the last one of the test in which it ended, and how it was ended."""
    lines = [json.loads(line) for line in text.decode().splitlines()]
    complete = [line for line in lines if "cost" in line]
    if not code:
        return complete, ""
    complete += [{"test": line["test"], "failure": ""} for line in lines[-1:]]
    killed = code in (-signal.SIGPROF, -signal.SIGKILL)
    return complete, "does not end" if killed else f"ends with {code}"


def _fate(lines: list[dict[str, Any]], ended: str, count: int) -> str:
    """What became of a change, from the lines of its fork and the number of tests that might notice it."""
    if not count:
        return "survives: no test reaches it"
    failure = lines[-1]["failure"] if lines else ""
    if failure != LATE and (ended or failure):
        return f"caught: {lines[-1]['test']}: {ended or failure}"
    return f"survives: {len(lines)} of {count} tests"


class _Watch:
    """Remember how a test failed."""

    failure = ""

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """The last line of a failure."""
        if report.failed and not self.failure:
            crash = getattr(report.longrepr, "reprcrash", None)
            message = crash.message if crash else str(report.longrepr)
            self.failure = (message.strip().splitlines() or ["fails"])[0][:150]
