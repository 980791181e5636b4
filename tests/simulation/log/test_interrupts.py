"""Ctrl-C while a file is written."""

import gc
import signal
import threading

import pytest

from planar_pushing.simulation.disk import undisturbed
from signals import interruptible, uninterruptible


@pytest.fixture(autouse=True)
def heard():
    before = signal.getsignal(signal.SIGINT)
    interruptible()
    yield
    signal.signal(signal.SIGINT, before)


def test_ctrl_c_comes_after_the_block():
    written = []

    def write():
        with undisturbed():
            signal.raise_signal(signal.SIGINT)
            written.append("all")

    with pytest.raises(KeyboardInterrupt):
        write()
    assert written == ["all"]
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)


def test_ctrl_c_that_is_ignored_stays_so():
    uninterruptible()
    with undisturbed():
        signal.raise_signal(signal.SIGINT)
    signal.raise_signal(signal.SIGINT)


def test_an_error_of_the_block_goes_on():
    with pytest.raises(OSError, match="full"), undisturbed():
        raise OSError("full")


def test_threads_hear_no_signals():
    done = []

    def write():
        with undisturbed():
            done.append(signal.getsignal(signal.SIGINT))

    thread = threading.Thread(target=write)
    thread.start()
    thread.join()
    assert done == [signal.getsignal(signal.SIGINT)]


def test_no_garbage_is_collected_until_the_last_block_ends():
    assert gc.isenabled()
    with undisturbed():
        with undisturbed():
            assert not gc.isenabled()
        assert not gc.isenabled()
        inside = []
        other = threading.Thread(target=lambda: inside.append(collects_in_a_block()))
        other.start()
        other.join()
        assert inside == [False]
        assert not gc.isenabled()
    assert gc.isenabled()
    gc.disable()
    try:
        with undisturbed():
            pass
        assert not gc.isenabled()
    finally:
        gc.enable()


def collects_in_a_block():
    with undisturbed():
        return gc.isenabled()
