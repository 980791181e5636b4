"""The page of proofs: every entry of the ledger with its arguments, as HTML with formulas in MathML."""

import re
from html import unescape

import pytest

from pulling_by_pushing.evidence.claims.ledger import load_ledger
from pulling_by_pushing.report.parts.evidence import VERDICTS
from pulling_by_pushing.report.typeset import typeset_html

pytestmark = pytest.mark.slow


def proofs(setting):
    return typeset_html(setting.root / "paper/proofs.typ", setting.root)


def words(html):
    """Text of the sections without marks."""
    content = html[html.index("<body>") :].replace("</p>", " ").replace("</div>", " ")
    return re.sub(r"\s+", " ", unescape(re.sub("<[^>]*>", "", content)))


@pytest.fixture(scope="module")
def text(shared):
    return words(proofs(shared))


def test_an_entry_has_its_places_its_outcomes_and_its_reason(text):
    assert "Statement 1. A statement. proved" in text
    assert "Some edge: -20.125°; other edge: 1.5".replace("-", "\u2212") in text
    assert "Eqs. (12), (13), Fig. 5" in text
    assert "Reason. The sign is the other one." in text
    assert "Proposition 1. A statement. proved Proof; a program checks identities." in text
    assert "Another argument. Own: 1.375." in text
    assert "A part of it. An argument with" in text
    assert "4321 points" in text


def test_an_argument_of_two_checks_is_printed_once(text):
    assert text.count("A change of sign.") == 1


def test_the_margin_of_a_proof_is_no_number_of_its_statement(text):
    assert "0.875" not in text


def test_a_value_has_no_more_than_eight_decimals(setting):
    file = setting.tables / "claims.json"
    content = file.read_text(encoding="utf-8")
    assert '"-20.125"' in content
    file.write_text(content.replace('"-20.125"', '"-20.12500000123456789012"'), encoding="utf-8")
    text = words(proofs(setting))
    assert "\u221220.125°" in text
    assert "123456" not in text


def test_every_entry_of_the_ledger_has_an_anchor_and_every_reference_leads_to_one(setting):
    setting.write_ledger()
    html = proofs(setting)
    anchors = re.findall(r'id="([^"]*)"', html)
    assert anchors == [f"claim-{claim.id}" for claim in in_order()]
    links = re.findall(r'href="#([^"]*)"', html)
    assert links
    assert set(links) <= set(anchors)


def in_order():
    """The statements, the theorems, and then the propositions."""
    claims = load_ledger("paper/claims.yaml").claims
    theorems = ("pulls-where-it-slips", "pull-has-a-slip")
    rank = {"paper": 0, "ours": 2}
    return sorted(claims, key=lambda claim: 1 if claim.id in theorems else rank[claim.origin])


def test_every_entry_is_listed_in_short_with_its_verdict(setting):
    text = words(proofs(setting))
    for number, verdict in enumerate(VERDICTS):
        assert re.search(rf"Statement {number + 1}: Number {number} on .*? \({verdict}\)", text), (
            verdict
        )
    assert "Proposition 1: Short for claim-ours (proved)" in text


def test_formulas_are_in_mathml(setting):
    setting.write_ledger()
    html = proofs(setting)
    assert html.count("<math>") > 500
    assert "$" not in words(html)
