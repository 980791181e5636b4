"""Formulas of the ledger: between dollar signs, valid in Typst, and readable in the CSV."""

import csv
import io
import json
import re

import pytest

from evidence.claims.ledgers import judged, ledger
from planar_pushing.evidence.claims.table import csv_text, plain
from planar_pushing.report.typeset import compiled
from report.setting import check, set_up

#: Signs of a formula; L is the shape, and s follows an apostrophe.
FORMULA = re.compile(
    r"\w_\w|[\^|<>=√°]|(?<![\w)])-\d|sqrt|\barc(?:sin|tan)\b|\b(?:sin|cos|tan)\b"
    r"|\b(?:psi|phi|theta|omega|rho|mu|tau|pi|sigma)\b|(?<!')\b[b-zB-KM-Z]\b"
)
#: Marks of Typst.
MARKS = re.compile(r"[$@]|\"along|\b(?:bold|abs)\(|\b(?:dif|thin|oo)\b")


def texts():
    """Statements, reasons, and arguments, by claim and check."""
    for claim in ledger().claims:
        yield claim.id, claim.statement
        yield f"{claim.id}, reason", claim.reason or ""
        for entry in claim.checks:
            yield f"{claim.id}, {entry.title}", f"{entry.statement or ''} {entry.resolved().how}"


TEXTS = dict(texts())


def test_every_formula_is_between_dollar_signs():
    wrong = {}
    for where, text in TEXTS.items():
        words, formulas = (text.split("$")[start::2] for start in (0, 1))
        assert len(words) == len(formulas) + 1, where
        assert all(each.strip() == each != "" for each in formulas), where
        wrong[where] = [found for part in words for found in FORMULA.findall(part)]
    assert {where: found for where, found in wrong.items() if found} == {}


def test_no_mark_remains_in_plain_text():
    assert [where for where, text in TEXTS.items() if MARKS.search(plain(text))] == []


@pytest.mark.parametrize(
    ("marked", "written"),
    [
        ("with $abs(bold(v)_s)^2 dif theta_s / dif phi$,", "with |v_s|^2 d theta_s / d phi,"),
        ("$p abs(cos(theta / 2)) >= abs(H(k))$", "p |cos(theta / 2)| >= |H(k)|"),
        ("$bold(u) times bold(w)$, $bold(f) dot bold(u)$", "u x w, f . u"),
        ('$tau_(0\')$, $a_(s y)$, $F_"along"^2$', "tau_0', a_sy, F_along^2"),
        ("in $[1, oo]$ on $100 thin 000$", "in [1, inf] on 100 000"),
        ("as in @pull-has-a-slip", "as in pull-has-a-slip"),
        ("A bold (new) word, at 45 times.", "A bold (new) word, at 45 times."),
    ],
)
def test_plain_text(marked, written):
    assert plain(marked) == written


def test_the_table_in_csv_is_plain():
    rows = csv.DictReader(io.StringIO(csv_text(judged())))
    for row in rows:
        for column in ("statement", "reason", "check_statement", "how"):
            assert not MARKS.search(row[column]), row["id"]


def test_every_formula_can_be_set(tmp_path):
    setting = set_up(tmp_path)
    rows = []
    for claim in ledger().claims:
        checks = [
            check(each.title, statement=each.statement, how=each.resolved().how)
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
