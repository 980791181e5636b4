"""The ledger of the paper, and copies of its checks with other numbers."""

from functools import cache
from pathlib import Path

from pulling_by_pushing.evidence.claims.ledger import judge_all, load_ledger

LEDGER = Path(__file__).parents[4] / "paper/claims.yaml"


@cache
def ledger():
    return load_ledger(LEDGER)


@cache
def judged():
    return judge_all(ledger())


@cache
def entries():
    """Every check, by the id of its claim and its own name."""
    return {(claim.id, entry.title): entry for claim, entry in ledger().entries()}


def judge(claim, name, mechanics=None, **numbers):
    """Evidence of a check with some of its numbers replaced: arguments, or those of a relation."""
    entry = entries()[claim, name]
    key = "claimed" if entry.check else "at"
    fields = set(type(entry).model_fields) - set(getattr(entry, key))
    own = {each: numbers.pop(each) for each in list(numbers) if each not in fields}
    assert all(getattr(entry, each) is not None for each in numbers), (claim, numbers)
    changed = entry.model_copy(update={key: getattr(entry, key) | own} | numbers)
    (stated,) = (each for each in ledger().claims if each.id == claim)
    return ledger().judge(stated, changed, mechanics)


def found(claim, name):
    """Evidence of a check as it is stated."""
    return judge(claim, name)
