"""Certified angles of friction of a study's contact laws and coefficients."""

from __future__ import annotations

import math
from typing import Any

from flint import arb

from pulling_by_pushing.evidence.golden.cells.sliders import Record, StudyValues
from pulling_by_pushing.oracle.balls import (
    in_degrees,
    rational,
    terms,
)
from pulling_by_pushing.oracle.modes import (
    INFINITE_FREE,
    INFINITE_NONE,
    PERFECTLY_ROUGH,
    Law,
)

LAWS = {
    "infinite_friction_free": INFINITE_FREE,
    "infinite_friction_none": INFINITE_NONE,
    "perfectly_rough": PERFECTLY_ROUGH,
}


def labeled_law(label: str) -> Law:
    """Contact law of a label on the axis `contact`."""
    return LAWS[label] if label in LAWS else Law(float(label.removeprefix("coulomb_")))


def contact_laws(values: StudyValues, contact: str) -> Record:
    """Cell of the axis `contact`; NaN for a perfectly rough contact."""
    law = labeled_law(contact)
    return {
        "friction_angle": friction_angle(math.nan if law.adhesive else law.friction_coefficient)
    }


def coefficients(values: StudyValues, friction_coefficient: float) -> Record:
    """Cell of the axis `friction_coefficient`."""
    return {"friction_angle": friction_angle(friction_coefficient)}


def friction_angle(mu: float) -> Any:
    """arctan(mu) in degrees: 90 for infinity, NaN for NaN."""
    if math.isnan(mu) or math.isinf(mu):
        return math.nan if math.isnan(mu) else 90.0
    return terms(in_degrees(arb(rational(mu)).atan()))
