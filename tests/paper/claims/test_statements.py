"""The statements of the paper on the library; the ledger proves them by the oracle."""

import pytest
from claims.library import Library
from claims.statements import STATEMENTS

from pulling_by_pushing.oracle.balls import precise

CASES = [(statement, scene) for statement, scenes in STATEMENTS.items() for scene in scenes]


def case_id(part):
    if callable(part):
        return part.__name__
    return f"{part.effects}, l={part.rod_length}, psi={part.rod_angle}, {part.law}"


@pytest.mark.parametrize(("statement", "scene"), CASES, ids=case_id)
@precise
def test_a_statement_holds(statement, scene):
    margins = list(statement(Library(), scene))
    assert all(margin > 0 for margin in margins), margins
