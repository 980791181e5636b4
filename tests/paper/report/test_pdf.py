"""The PDF says what the results say, its bytes depend on them alone, and errors say what is wrong."""

import io
import re
import subprocess
import sys
from pathlib import Path

import pytest
from pypdf import PdfReader
from report.setting import REPORT, set_up

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.figures.figure import entry
from pulling_by_pushing.figures.studies import OURS, numbered
from pulling_by_pushing.report.tables import NUMBERS
from pulling_by_pushing.report.typeset import compiled, typeset

pytestmark = pytest.mark.slow

#: Minus sign and quote as they are typed.
PLAIN = str.maketrans("\u2212\u2019", "-'")


def text_of(pdf):
    """Text of all pages, without breaks and with plain signs."""
    pages = (page.extract_text() for page in PdfReader(io.BytesIO(pdf)).pages)
    text = re.sub(r"\s+", " ", " ".join(pages)).translate(PLAIN)
    return re.sub(" ?\u00d7 ?", "x", text)  # the space around the sign depends on the font


@pytest.fixture(scope="module")
def pdf(shared):
    return compiled(shared.source, shared.root)


@pytest.fixture(scope="module")
def text(pdf):
    return text_of(pdf)


def marked(setting, file, source):
    """Names of the numbers of a file whose marks the PDF does not show, once they are written."""
    before = text_of(compiled(source, setting.root))
    numbers = setting.numbers(file)
    sections = [path.read_text(encoding="utf-8") for path in source.parent.glob("sections/*.typ")]
    words = re.findall(r"#word\(\"([\w-]+)\"\)", "".join(sections))  # counts, which show no digits
    marks = {key: f"-{1000 + 7 * i}.{100 + i}" for i, key in enumerate(numbers) if key not in words}
    for key, mark in marks.items():
        assert mark not in before
        numbers[key]["text"] = mark
    setting.write_numbers(numbers, file)
    after = text_of(compiled(source, setting.root))
    return [key for key, mark in marks.items() if mark not in after]


def test_each_number_of_the_prose_is_that_of_the_results(setting):
    assert set(setting.numbers()) == set(NUMBERS)
    assert marked(setting, REPORT, setting.source) == []


def test_the_tables_of_costs_are_in_the_text(text):
    assert "wrench some rule 64 4711 3.5x10-9 0.25 ns" in text
    assert "some place 41 2 3 4713" in text
    assert "some support 0.4725 1.1 2.2 3.3 4.4" in text
    assert "3.7x108 7 3.8x106" in text


def test_a_failed_golden_check_is_on_the_first_page_and_has_a_table(setting, text):
    assert "golden check of this build failed" not in text
    file = setting.tables / "golden_failures.csv"
    file.write_text(f"{file.read_text()}motion_cones: left,3 of 4719,1.5e-09,5.0e-13\n", "utf-8")
    pages = PdfReader(io.BytesIO(compiled(setting.source, setting.root))).pages
    assert "golden check of this build failed" in re.sub(r"\s+", " ", pages[0].extract_text())
    said = text_of(compiled(setting.source, setting.root))
    assert "motion_cones: left 3 of 4719 1.5e-09 5.0e-13" in said


def test_a_power_of_ten_is_set_as_one(setting):
    numbers = setting.numbers()
    numbers["trapezoid-error"]["text"] = "-7.3e-11"
    numbers["hard-limit"]["text"] = "1e+09"
    setting.write_numbers(numbers)
    text = text_of(compiled(setting.source, setting.root))
    assert "-7.3x10-11" in text
    assert "below 109" in text


def test_units_and_thousands(setting):
    numbers = setting.numbers()
    numbers["rod-angle"]["text"] = "77"
    numbers["slip-share"]["text"] = "61"
    numbers["pushes"]["text"] = "1234567"
    setting.write_numbers(numbers)
    text = text_of(compiled(setting.source, setting.root))
    assert "77°" in text
    assert re.search("61 ?%", text)
    assert re.search("1 ?234 ?567", text)


def test_every_figure_has_our_caption(text):
    for number in range(1, len(numbered()) + len(OURS) + 1):
        assert f"Figure {number}." in text
    ours = [name for name in numbered() if not entry(name).promise]
    assert text.count("Not in the paper.") == len(ours)
    assert "Limit curves for several rod lengths" in text


def test_what_the_captions_of_the_paper_promise_is_said_once(text):
    assert text.count("limit curves for rods of different lengths") == 1
    assert "promises:" not in text


def test_text_and_pictures_have_one_family(pdf):
    pages = PdfReader(io.BytesIO(pdf)).pages
    fonts = {
        str(font.get_object()["/BaseFont"])
        for page in pages
        for font in page["/Resources"].get("/Font", {}).values()
    }
    letters = {name for name in fonts if "STIXGeneral" in name}
    assert letters
    assert all("Math" in name or "Mono" in name for name in fonts - letters), fonts


def test_a_value_of_a_claim_has_no_more_than_eight_decimals(setting):
    ledger = setting.root / "results/tables/claims.json"
    content = ledger.read_text(encoding="utf-8")
    assert '"-20.125"' in content
    long = content.replace('"-20.125"', '"-20.12500000123456789012"')
    ledger.write_text(long, encoding="utf-8")
    found = text_of(compiled(setting.source, setting.root))
    assert "-20.125°" in found
    assert "123456" not in found


def test_the_title_is_not_that_of_the_paper(pdf):
    title = PdfReader(io.BytesIO(pdf)).metadata.title
    bibliography = Path("paper/references.bib").read_text(encoding="utf-8")
    assert title not in bibliography


def test_claims_tables_and_deviations_are_in_the_text(text):
    for part in (
        "claim-0",
        "Some edge: -20.125°",
        "other edge: 1.5",
        "Sec. 3.1: friction cones",
        "Eqs. (12), (13), Fig. 5",
    ):
        assert part in text
    for part in ("claim-3 open", "claim-4 refuted", "The sign is the other one.", "Own: 1.375"):
        assert part in text
    assert text.count("A change of sign.") == 1  # of two checks that argue alike
    assert "0.875" not in text  # the margin of a proof is no number of its statement
    for part in ("A part of it. An argument with", "Another argument.", "4321 points"):
        assert part in text
    assert re.search("65 ?432", text)
    for part in ("178.75", "9.8.7", "54 degrees", "equal shares", "Closed forms."):
        assert part in text


def test_two_builds_in_different_folders_are_identical(pdf, setting, tmp_path):
    first, second = (tmp_path / f"{name}.pdf" for name in "ab")
    for path in (first, second):
        typeset(setting.source, setting.root, path)
    assert first.read_bytes() == second.read_bytes() == pdf
    deeper = set_up(tmp_path / "another" / "folder")
    assert compiled(deeper.source, deeper.root) == pdf
    build = (
        "import sys; from pulling_by_pushing.report.typeset import typeset; typeset(*sys.argv[1:])"
    )
    arguments = [deeper.source, deeper.root, tmp_path / "c.pdf"]
    subprocess.run([sys.executable, "-c", build, *map(str, arguments)], check=True, timeout=60)
    assert (tmp_path / "c.pdf").read_bytes() == pdf
    assert str(tmp_path).encode() not in pdf


def test_pdf_holds_no_date(pdf):
    information = PdfReader(io.BytesIO(pdf)).metadata
    assert "/CreationDate" not in information
    assert "/ModDate" not in information
    assert information.title.startswith("[Re] Pulling by Pushing")


def test_an_unknown_number_stops_the_report(setting):
    numbers = setting.numbers()
    del numbers["pushes"]
    setting.write_numbers(numbers)
    with pytest.raises(
        InvalidFile, match=r"numbers\.json: pushes: no such number; allowed: the keys"
    ):
        typeset(setting.source, setting.root, setting.root / "report.pdf")
    assert not (setting.root / "report.pdf").exists()


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("#missing", r"report.typ:\d+:\d+: cannot be typeset: unknown variable: missing"),
        ('#json("none.json")', "cannot be typeset: file not found"),
        ('#text(font: "No Such Font")[word]', "cannot be typeset: unknown font family"),
    ],
)
def test_a_fault_in_the_source_is_one_message(setting, line, said):
    with setting.source.open("a", encoding="utf-8") as stream:
        stream.write(f"\n{line}\n")
    with pytest.raises(InvalidFile, match=said) as raised:
        compiled(setting.source, setting.root)
    assert "\n" not in str(raised.value)


def test_a_missing_source_is_named(tmp_path):
    with pytest.raises(InvalidFile, match=r"none\.typ: no such file"):
        compiled(tmp_path / "none.typ", tmp_path)
