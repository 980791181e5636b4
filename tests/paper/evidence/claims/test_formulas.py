"""Formulas of the ledger: between dollar signs, valid in Typst."""

import re

import pytest
from evidence.claims.ledgers import ledger
from report.setting import set_up

from pulling_by_pushing.report.typeset import typeset_html

#: Signs of a formula; L is the shape, and s follows an apostrophe.
FORMULA = re.compile(
    r"\w_\w|[\^|<>=√°]|(?<![\w)])-\d|sqrt|\barc(?:sin|tan)\b|\b(?:sin|cos|tan)\b"
    r"|\b(?:psi|phi|theta|omega|rho|mu|tau|pi|sigma)\b|(?<!')\b[b-zB-KM-Z]\b"
)


def texts():
    """Statements, reasons, and arguments, by claim and check."""
    for claim in ledger().claims:
        yield claim.id, claim.statement
        yield f"{claim.id}, short", claim.short
        yield f"{claim.id}, reason", claim.reason or ""
        for entry in claim.checks:
            yield f"{claim.id}, {entry.title}", entry.statement or ""
    yield from ledger().arguments.items()


TEXTS = dict(texts())


def test_every_formula_is_between_dollar_signs():
    wrong = {}
    for where, text in TEXTS.items():
        words, formulas = (text.split("$")[start::2] for start in (0, 1))
        assert len(words) == len(formulas) + 1, where
        assert all(each.strip() == each != "" for each in formulas), where
        wrong[where] = [found for part in words for found in FORMULA.findall(part)]
    assert {where: found for where, found in wrong.items() if found} == {}


@pytest.mark.slow
def test_every_formula_can_be_set(tmp_path):
    setting = set_up(tmp_path)
    setting.write_ledger()
    assert "<math>" in typeset_html(setting.root / "paper/proofs.typ", setting.root)
