"""Formulas of the ledger: between dollar signs, valid in Typst."""

import json
import re

from evidence.claims.ledgers import ledger
from report.setting import check, set_up

from pulling_by_pushing.report.typeset import compiled

#: Signs of a formula; L is the shape, and s follows an apostrophe.
FORMULA = re.compile(
    r"\w_\w|[\^|<>=√°]|(?<![\w)])-\d|sqrt|\barc(?:sin|tan)\b|\b(?:sin|cos|tan)\b"
    r"|\b(?:psi|phi|theta|omega|rho|mu|tau|pi|sigma)\b|(?<!')\b[b-zB-KM-Z]\b"
)


def texts():
    """Statements, reasons, and arguments, by claim and check."""
    for claim in ledger().claims:
        yield claim.id, claim.statement
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


def test_every_formula_can_be_set(tmp_path):
    setting = set_up(tmp_path)
    rows = []
    for claim in ledger().claims:
        checks = [
            check(each.title, statement=each.statement, how=ledger().arguments[each.argument])
            for each in claim.checks
        ]
        row = claim.model_dump(exclude={"expect", "checks"}) | {"checks": checks}
        rows.append(row | {"verdict": claim.expect})
    (setting.tables / "claims.json").write_text(json.dumps({"claims": rows}), encoding="utf-8")
    source = setting.root / "paper" / "ledger.typ"
    source.write_text(
        '#import "claims_table.typ": claims-table\n'
        '#set text(font: "STIXGeneral")\n'
        '#claims-table("paper")\n#claims-table("ours")\n',
        encoding="utf-8",
    )
    assert compiled(source, setting.root).startswith(b"%PDF")
