"""The exception family."""

import planar_pushing as pp


def test_one_exception_family():
    assert issubclass(pp.InvalidValue, pp.PlanarPushingError)
    assert issubclass(pp.InvalidFile, pp.PlanarPushingError)
    assert issubclass(pp.InvalidValue, ValueError)


def test_a_refusal_keeps_its_parts():
    error = pp.InvalidValue("weight", -1.0, "a finite number > 0", "leave the effect out")
    assert (error.name, error.given, error.allowed, error.remedy) == error.args
    assert str(error) == "weight: -1.0 given; allowed: a finite number > 0; leave the effect out"
