"""The ledger of the paper, and copies of its claims with other numbers."""

from functools import cache
from pathlib import Path

from planar_pushing.evidence.claims.ledger import load_ledger
from planar_pushing.evidence.claims.table import judge, judge_all

#: Random supports of a claim in tests.
FEW = 1000
PROJECT = Path(__file__).parents[3]
LEDGER = PROJECT / "paper/claims.yaml"


@cache
def ledger():
    return load_ledger(LEDGER)


@cache
def judged():
    """The verdicts, on few of the random supports."""
    claims = [_on_few(each) for each in ledger().claims]
    return judge_all(ledger().model_copy(update={"claims": tuple(claims)}))


def _on_few(given):
    count = given.claimed.get("supports", 0)
    fewer = {"supports": FEW} if count > FEW else {}
    return given.model_copy(update={"claimed": given.claimed | fewer})


def claim(name):
    (found,) = (each for each in ledger().claims if each.id == name)
    return found


def verdict_with(name, **numbers):
    """Evidence for a claim with some of its numbers replaced."""
    given = claim(name)
    assert set(numbers) <= set(given.claimed), name
    return judge(given.model_copy(update={"claimed": given.claimed | numbers})).evidence
