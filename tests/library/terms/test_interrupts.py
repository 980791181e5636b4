"""Ctrl-C and SIGTERM while threads run: raised once they have ended, whenever the signal comes."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from planar_pushing.mechanics.kernels.arrays import CORES, in_threads
from planar_pushing.terms.signals import (
    Termination,
    interrupts_raise_after,
    termination_as_interrupt,
)
from signals import interruptible

#: Interrupts a call on many blocks at random moments; a lock that stays locked would hold it up for ever.
RANDOM_MOMENTS = """
import _thread, faulthandler, random, signal, threading, time
from planar_pushing.mechanics.kernels.arrays import in_threads

faulthandler.dump_traceback_later(300, exit=True)
signal.signal(signal.SIGINT, signal.default_int_handler)
starts, random = threading.Semaphore(0), random.Random(1)

def interrupt():
    while True:
        starts.acquire()
        moment = time.perf_counter() + 0.02 * random.random()
        while time.perf_counter() < moment:
            pass
        _thread.interrupt_main()

threading.Thread(target=interrupt, daemon=True).start()
count = 0
for _ in range(1500):
    try:
        starts.release()
        in_threads(lambda start: None, range(800))
        time.sleep(0.1)
    except KeyboardInterrupt:
        count += 1
print(count)
"""


@pytest.fixture(autouse=True)
def default_handler():
    before = signal.getsignal(signal.SIGINT)
    interruptible()
    cores = CORES.set(2)
    yield
    CORES.reset(cores)
    signal.signal(signal.SIGINT, before)


def test_an_interrupt_is_raised_after_the_block():
    reached, stops = [], []

    def interrupt():
        with interrupts_raise_after(lambda: stops.append(1)):
            signal.raise_signal(signal.SIGINT)
            reached.append(1)

    with pytest.raises(KeyboardInterrupt):
        interrupt()
    assert reached == stops == [1]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_second_interrupt_is_raised_at_once():
    reached = []

    def interrupt_twice():
        with interrupts_raise_after(lambda: None):
            signal.raise_signal(signal.SIGINT)
            signal.raise_signal(signal.SIGINT)
            reached.append(1)

    with pytest.raises(KeyboardInterrupt):
        interrupt_twice()
    assert not reached
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_sigterm_is_raised_as_what_it_is():
    with pytest.raises(Termination), termination_as_interrupt():
        in_threads(lambda start: start or signal.raise_signal(signal.SIGTERM), range(3))


@pytest.mark.parametrize("name", ["submit", "shutdown"])
def test_nothing_is_raised_within_the_pool_of_threads(monkeypatch, name):
    """Where the exception could come between a lock of the pool and its release."""
    called, reached = getattr(ThreadPoolExecutor, name), []

    def call_interrupted(*arguments, **options):
        if not reached:
            signal.raise_signal(signal.SIGINT)
        reached.append(1)
        return called(*arguments, **options)

    monkeypatch.setattr(ThreadPoolExecutor, name, call_interrupted)
    with pytest.raises(KeyboardInterrupt):
        in_threads(lambda start: None, range(10))
    assert len(reached) == {"submit": 10, "shutdown": 1}[name]


@pytest.mark.parametrize("number", [1, 100])
def test_the_blocks_that_wait_are_not_begun(number):
    begun, main = [], threading.main_thread().ident

    def block(start):
        begun.append(start)
        if start == number - 1:
            signal.pthread_kill(main, signal.SIGINT)
        time.sleep(0.01)

    with pytest.raises(KeyboardInterrupt):
        in_threads(block, range(1000))
    assert number <= len(begun) < number + 100
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_handler_that_raises_nothing_ends_nothing():
    heard, begun = [], []
    signal.signal(signal.SIGINT, lambda *_: heard.append(1))

    def block(start):
        begun.append(start)
        if start == 3:
            signal.pthread_kill(threading.main_thread().ident, signal.SIGINT)
        time.sleep(0.001)

    in_threads(block, range(100))
    assert heard == [1]
    assert sorted(begun) == list(range(100))


def test_an_error_of_a_block_is_raised_and_ends_the_others():
    begun = []

    def block(start):
        begun.append(start)
        time.sleep(0.001)
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        in_threads(block, range(1000))
    assert len(begun) < 100


def test_threads_beside_the_main_one_are_not_interrupted():
    found = []
    thread = threading.Thread(target=lambda: in_threads(found.append, range(50)))
    thread.start()
    thread.join()
    assert sorted(found) == list(range(50))


@pytest.mark.slow
def test_no_moment_of_an_interrupt_leaves_a_lock_locked():
    ended = subprocess.run(
        [sys.executable, "-c", RANDOM_MOMENTS], capture_output=True, text=True, check=False
    )
    assert (ended.returncode, ended.stdout) == (0, "1500\n"), ended.stderr
