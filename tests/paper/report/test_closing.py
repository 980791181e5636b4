"""The last lines of `make`."""

import json

import pytest

from pulling_by_pushing.report.closing import closing_lines


@pytest.fixture
def built(tmp_path):
    (tmp_path / "paper.pdf").touch()
    (tmp_path / "tables").mkdir()
    return tmp_path


@pytest.mark.parametrize("changed", [False, True])
def test_a_report_of_a_changed_tree_is_not_for_publication(built, changed):
    remark = ", with changes" if changed else ""
    table = f'what,value\ncommit,"abc of 2026-01-02{remark}"\n'
    (built / "tables/provenance.csv").write_text(table, encoding="utf-8")
    report = closing_lines(built)[0]
    assert str(built / "paper.pdf") in report
    assert ("not for publication" in report) == changed


@pytest.mark.parametrize(("passed", "word"), [(True, "passed"), (False, "FAILED")])
def test_the_verdict_is_that_of_both_studies(built, passed, word):
    other = built / "studies/sliders"
    (other / "tables").mkdir(parents=True)
    kinds = {"enclosed": {"values": 1000}, "plain": {"values": 20}}
    for folder, each in ((built, True), (other, passed)):
        verdict = json.dumps({"passed": each, "kinds": kinds})
        (folder / "tables/golden_verdict.json").write_text(verdict, encoding="utf-8")
    golden = closing_lines(built, (other,))[1]
    assert golden == f"Golden   {word}: 2,000 numbers enclosed, 40 compared otherwise"
