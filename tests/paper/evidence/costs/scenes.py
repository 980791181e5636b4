"""The motions whose errors are measured: one in the fast tests, since certifying one takes seconds."""

from __future__ import annotations

import pytest

from pulling_by_pushing.evidence.costs import measure
from pulling_by_pushing.evidence.costs.methods import SCENES

#: Numbers of motions, as parameters of a fixture.
COUNTS = [1, pytest.param(len(SCENES), marks=pytest.mark.slow)]


def keep_scenes(patch: pytest.MonkeyPatch, count: int) -> None:
    """Leave only the first motions."""
    for scene in list(SCENES)[count:]:
        patch.delitem(SCENES, scene)
    motion = measure.QUANTITIES["motion"]._replace(cases=list(SCENES))
    patch.setitem(measure.QUANTITIES, "motion", motion)
