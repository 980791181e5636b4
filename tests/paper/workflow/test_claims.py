"""The claims in the workflow: a wrong one fails the run, by name, and writes nothing."""

import json

import pytest

pytestmark = pytest.mark.slow

LEDGER = "paper/claims.yaml"
TABLE = "tables/claims.json"


def test_the_table_is_built(built):
    table = json.loads((built.results / TABLE).read_text(encoding="utf-8"))
    assert table["counts"]["proved"] > 0
    assert (built.results / TABLE).with_suffix(".csv").is_file()


def test_a_wrong_claim_fails_the_run_and_says_why(fresh):
    path = fresh.root / LEDGER
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("threshold: 1.5}", "threshold: 1.4}"), encoding="utf-8")
    said = fresh.snakemake("claims", code=1)
    assert "claims whose verdict is not the expected one: 1" in said
    assert "pulling-condition: refuted, expected proved; threshold: false: a_sy = 0 at" in said
    assert "Traceback" not in said
    assert not (fresh.results / TABLE).exists()
    path.write_text(text, encoding="utf-8")
    fresh.snakemake("claims")
    assert (fresh.results / TABLE).is_file()


def test_a_wrong_ledger_is_named(fresh):
    path = fresh.root / LEDGER
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace('section: "5"', 'section: "6"'), encoding="utf-8")
    said = fresh.snakemake("claims", code=1)
    assert ".section: '6' given; allowed: '1', '2', '3'" in said
