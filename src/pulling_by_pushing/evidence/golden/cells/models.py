"""Certified numbers of pushes with and without inertia that have a closed form."""

from __future__ import annotations

from flint import arb

from pulling_by_pushing.evidence.golden.cells.sliders import Record, StudyValues
from pulling_by_pushing.oracle.balls import rational, terms

#: Standard gravity, m/s^2.
GRAVITY = 9.80665


def coasting_length(values: StudyValues, support: str, speed: float) -> Record:
    """Displacement without inertia of a push through the center by a finger that stops: v^2/(2 mu_s g).

    With inertia the box then slides over this length, on any support, and without it rests. The computed
    displacement is the difference of two positions, of which one is at the distance.
    """
    section = values["model_errors"]
    coefficient, distance = (
        rational(section[name]) for name in ("support_friction_coefficient", "distance")
    )
    length = arb(rational(speed) ** 2 / (2 * coefficient * rational(GRAVITY)))
    return {"coasting_error": terms(length, arb(distance), arb(distance) + length)}
