"""Both integrators against certified motion: errors of the stored size, and the order of the steps."""

from pathlib import Path

import numpy as np
import pytest

from planar_pushing.evidence.costs import motion
from planar_pushing.study.store import read_dataset

GOLDEN = Path(__file__).with_name("golden_accuracy.nc")
#: Up to here an error is the tolerance's own matter, and rounding may move it.
FLOOR = 1e-9


@pytest.fixture(scope="module")
def found():
    return motion.motion_errors()


def test_settings_and_counts_are_golden(found):
    stored = read_dataset(GOLDEN, "motion")
    assert set(found.variables) == set(stored.variables)
    for name in ("method", "setting", "scene"):
        assert np.array_equal(found[name], stored[name])
    np.testing.assert_allclose(found.evaluations, stored.evaluations, rtol=0.05)


def test_errors_are_golden(found):
    stored = read_dataset(GOLDEN, "motion").motion_error.values
    large = stored > FLOOR
    np.testing.assert_allclose(found.motion_error.values[large], stored[large], rtol=0.05)
    assert (found.motion_error.values[~large] <= FLOOR).all()


def test_event_driven_keeps_its_tolerance(found):
    tight = (found.method == "event-driven") & (found.setting <= 1e-10)
    assert (found.motion_error[tight.values] < 1e-9).all()


def test_steps_are_of_first_order(found):
    steps = found.isel(point=(found.method == "time-stepping").values)
    for error in steps.motion_error.values.T:
        order = np.polyfit(np.log(steps.setting.values), np.log(error), 1)[0]
        assert order == pytest.approx(-1, abs=0.02)


def test_the_certified_end_is_narrow():
    high, low = motion.reference("slipping")
    assert abs(low) <= np.spacing(high) / 2
    assert high == pytest.approx(33.4916431996514, abs=1e-12)
