"""Calls are timed in turns, on a machine that is described."""

import platform

from planar_pushing.evidence.costs.timing import machine, seconds


def test_calls_are_timed_in_turns_after_a_round_that_does_not_count():
    calls = []
    taken = seconds([lambda: calls.append("a"), lambda: calls.append("b")], 5)
    assert taken.shape == (2, 5)
    assert (taken >= 0).all()
    assert calls == ["a", "b"] * 6


def test_the_machine_is_described_without_its_name():
    found = machine()
    assert {"processor", "cores", "system", "python", "numpy", "scipy"} <= set(found)
    assert platform.node() not in found.values()
