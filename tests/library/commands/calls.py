"""Slow functions that several commands call."""

from copy import deepcopy


def called_once(function):
    """The function of pushes, which finds the result for the same pushes and options once."""
    found = []

    def call(pushes, *arguments, **options):
        given = (arguments, options)
        for before, others, result in found:
            if others == given and before.identical(pushes):
                return deepcopy(result)
        result = function(pushes, *arguments, **options)
        found.append((pushes, given, result))
        return deepcopy(result)

    return call
