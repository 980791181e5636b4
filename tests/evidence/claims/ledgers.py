"""The ledger of the paper, and copies of its checks with other numbers."""

from functools import cache
from pathlib import Path

from planar_pushing.evidence.claims.ledger import load_ledger
from planar_pushing.evidence.claims.table import judge_all, judge_check

#: Random supports of a check in tests.
FEW = 1000
PROJECT = Path(__file__).parents[3]
LEDGER = PROJECT / "paper/claims.yaml"


@cache
def ledger():
    return load_ledger(LEDGER)


@cache
def judged():
    """The verdicts, on few of the random supports."""
    claims = [
        each.model_copy(update={"checks": tuple(map(_on_few, each.checks))})
        for each in ledger().claims
    ]
    return judge_all(ledger().model_copy(update={"claims": tuple(claims)}))


def _on_few(entry):
    fewer = {"supports": FEW} if entry.claimed.get("supports", 0) > FEW else {}
    return entry.model_copy(update={"claimed": entry.claimed | fewer})


def entries():
    """Every check, by the id of its claim and its own name."""
    return {(claim.id, entry.title): entry for claim in ledger().claims for entry in claim.checks}


def found(claim, name):
    """Evidence of a check."""
    (one,) = (each for each in judged() if each.claim.id == claim)
    (check,) = (each for each in one.checks if each.entry.title == name)
    return check.evidence


def verdict_with(claim, name, **numbers):
    """Evidence of a check with some of its numbers replaced: arguments, or those of a relation."""
    entry = entries()[claim, name]
    key = "claimed" if entry.check else "at"
    own = {each: numbers.pop(each) for each in list(numbers) if each in getattr(entry, key)}
    assert all(getattr(entry, each) is not None for each in numbers), (claim, numbers)
    return judge_check(
        claim, entry.model_copy(update={key: getattr(entry, key) | own} | numbers)
    ).evidence
