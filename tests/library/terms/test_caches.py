"""Caches of functions of supports."""

import pytest

from planar_pushing.terms.caches import cache_results


def counted(size):
    calls = []

    @cache_results(size)
    def total(*numbers):
        """Sum of lists and tuples."""
        calls.append(numbers)
        return sum(map(sum, numbers))

    return total, calls


def test_results_are_kept_up_to_a_number():
    total, calls = counted(2)
    for numbers in ((1, 2), (3,), (1, 2), (3,), (4,), (1, 2)):
        assert total(numbers) == sum(numbers)
    assert calls == [((1, 2),), ((3,),), ((4,),), ((1, 2),)]


def test_unhashable_arguments_are_computed_anew():
    total, calls = counted(2)
    numbers = [1, 2]
    assert total(numbers) == 3
    numbers.append(3)
    assert total(numbers) == 6
    assert len(calls) == 2


def test_errors_of_the_function_are_its_own():
    total, calls = counted(2)
    with pytest.raises(TypeError, match="not iterable"):
        total((1, 2), 3)
    assert len(calls) == 1
    assert total.__doc__ == "Sum of lists and tuples."
