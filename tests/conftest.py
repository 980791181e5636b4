"""Hypothesis draws the same examples on every run and keeps no database."""

from __future__ import annotations

import pytest
from core.both_forms import BothForms
from hypothesis import HealthCheck, settings

from planar_pushing.mechanics.kernels import calls as kernels

settings.register_profile(
    "reproducible",
    derandomize=True,
    database=None,
    deadline=None,
    max_examples=40,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)
settings.load_profile("reproducible")


@pytest.fixture
def both(monkeypatch):
    """The kernels, each of whose answers is compared with that of its plain source."""
    if kernels.COMPILED is None:
        pytest.skip("the core is not compiled, or PLANAR_PUSHING_PLAIN is set")
    both = BothForms(kernels.COMPILED)
    monkeypatch.setattr(kernels, "COMPILED", both)
    return both
