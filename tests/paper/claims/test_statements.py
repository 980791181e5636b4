"""The statements of the paper on the library, and on the oracle, whose proofs they illustrate."""

import pytest
from claims.library import Library
from claims.statements import STATEMENTS

from pulling_by_pushing.evidence.proofs.mechanics import Oracle
from pulling_by_pushing.oracle.balls import precise

CASES = [(statement, scene) for statement, scenes in STATEMENTS.items() for scene in scenes]


def case_id(part):
    if callable(part):
        return part.__name__
    return f"{part.effects}, l={part.rod_length}, psi={part.rod_angle}, {part.law}"


@pytest.mark.parametrize("mechanics", [Oracle(), Library()], ids=["oracle", "library"])
@pytest.mark.parametrize(("statement", "scene"), CASES, ids=case_id)
@precise
def test_a_statement_holds(statement, scene, mechanics):
    margins = list(statement(mechanics, scene))
    assert all(margin > 0 for margin in margins), margins
