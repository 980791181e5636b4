"""The PDF says what the results say, its bytes depend on them alone, and errors say what is wrong."""

import io
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest
from PIL import Image
from pypdf import PdfReader
from report.setting import PICTURE, set_up

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.evidence.claims.ledger import load_ledger
from pulling_by_pushing.figures.figure import drawing, entry
from pulling_by_pushing.figures.studies import NUMBERS as FIGURE_NUMBERS
from pulling_by_pushing.figures.studies import study_figures
from pulling_by_pushing.report.tables import NUMBERS
from pulling_by_pushing.report.typeset import typeset, typeset_pdf

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
    return typeset_pdf(shared.source, shared.root)


@pytest.fixture(scope="module")
def text(pdf):
    return text_of(pdf)


#: A number of the prose in digits, by its key.
PRINTED = re.compile(r"#n\(\"([\w-]+)\"\)|#equal\(\$\w+\$, \"([\w-]+)\"\)")


def marked(setting, source):
    """Keys of the numbers of the prose whose marks the PDF does not show, once they are written."""
    before = text_of(typeset_pdf(source, setting.root))
    numbers = setting.numbers()
    sections = [path.read_text(encoding="utf-8") for path in source.parent.glob("sections/*.typ")]
    keys = [first or second for first, second in PRINTED.findall("".join(sections))]
    marks = {key: f"-{1000 + 7 * i}.{100 + i}" for i, key in enumerate(dict.fromkeys(keys))}
    for key, mark in marks.items():
        assert mark not in before
        numbers[key]["text"] = mark
    setting.write_numbers(numbers)
    after = text_of(typeset_pdf(source, setting.root))
    return [key for key, mark in marks.items() if mark not in after]


def test_each_number_of_the_prose_is_that_of_the_results(setting):
    assert set(setting.numbers()) == set(NUMBERS)
    assert marked(setting, setting.source) == []


def test_a_failed_golden_check_is_on_the_first_page_and_has_a_table(setting, text):
    assert "golden check of this build failed" not in text
    file = setting.tables / "golden_failures.csv"
    file.write_text(f"{file.read_text()}motion_cones: left,3 of 4719,1.5e-09,5.0e-13\n", "utf-8")
    pages = PdfReader(io.BytesIO(typeset_pdf(setting.source, setting.root))).pages
    assert "golden check of this build failed" in re.sub(r"\s+", " ", pages[0].extract_text())
    said = text_of(typeset_pdf(setting.source, setting.root))
    assert "motion_cones: left 3 of 4719 1.5e-09 5.0e-13" in said


def test_results_can_be_in_a_folder_elsewhere(setting, text, tmp_path_factory):
    folder = tmp_path_factory.mktemp("elsewhere") / "results"
    (setting.root / "results").rename(folder)
    assert text_of(typeset_pdf(setting.source, setting.root, str(folder))) == text
    with pytest.raises(InvalidFile, match="not found"):
        typeset_pdf(setting.source, setting.root)


def test_a_power_of_ten_is_set_as_one(setting):
    numbers = setting.numbers()
    numbers["trapezoid-error"]["text"] = "-7.3e-11"
    numbers["hard-limit"]["text"] = "1e+09"
    setting.write_numbers(numbers)
    text = text_of(typeset_pdf(setting.source, setting.root))
    assert "-7.3x10-11" in text
    assert "below 109" in text


def test_units_and_thousands(setting):
    numbers = setting.numbers()
    numbers["rod-angle"]["text"] = "77"
    numbers["slip-share"]["text"] = "61"
    numbers["sticking-pulls"]["text"] = "1234567"
    setting.write_numbers(numbers)
    text = text_of(typeset_pdf(setting.source, setting.root))
    assert "77°" in text
    assert re.search("61 ?%", text)
    assert re.search("1 ?234 ?567", text)


def test_every_figure_has_its_number_and_caption(text):
    for name, number in FIGURE_NUMBERS.items():
        assert f"Figure {number}." in text, name
    ours = [
        name for name in study_figures() if not entry(name).promise and name.startswith("figure")
    ]
    assert text.count("Not in the paper.") == len(ours)
    assert "Limit curves for several rod lengths" in text


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


def test_the_title_is_not_that_of_the_paper(pdf):
    title = PdfReader(io.BytesIO(pdf)).metadata.title
    bibliography = Path("paper/references.bib").read_text(encoding="utf-8")
    assert title not in bibliography


def test_statements_of_the_paper_have_what_we_find_and_the_verdict_of_the_ledger(text):
    assert "Pulling and this slip are one phenomenon. proved" in text
    assert text.count("A normal push sticks for every support.") == 1
    assert "An argument" not in text  # the manual has the proofs


def test_cones_deviations_and_what_identifies_the_code_are_in_the_text(text):
    for part in ("178.75", "54 degrees", "equal shares", "Closed forms."):
        assert part in text
    assert "Version 9.8.7, commit 0a1b2c of 2026-01-02. License: MIT." in text
    cited = re.search(r"How to cite. (.*?) The file", text)[1]
    for part in (
        "The planar-pushing developers",
        "[Re] Pulling by Pushing",
        "version 9.8.7",
        "commit 0a1b2c,",
    ):
        assert part in cited


#: Ends of the report and of its supplement, pages.
REPORT_PAGES, SUPPLEMENT_PAGES = 10, 3


#: Golden images of figures, which have their printed size, and their pixels per point.
IMAGES, PIXELS = Path("tests/golden/images"), 108 / 72


def printed_size(name):
    """Width and height of a figure, points."""
    image = IMAGES / f"{name}.png"
    if not image.exists():
        return [72 * length for length in drawing(name).figure.size]
    with Image.open(image) as picture:
        return [pixels / PIXELS for pixels in picture.size]


#: Lowest baseline of the text on a page, points: the bottom margin of 16 mm less room for a subscript.
BOTTOM = 40.0


def lowest_baseline(page):
    """Height of the lowest text of a page without its page number, points from the lower edge."""
    heights = []

    def add(text, cm, tm, *_):
        if text.strip() and text.strip() != "1":
            heights.append(cm[1] * tm[4] + cm[3] * tm[5] + cm[5])

    page.extract_text(visitor_text=add)
    return min(heights)


@pytest.fixture(scope="module")
def printed(tmp_path_factory):
    """Pages of the report with the ledger of the paper and pictures of their own sizes."""
    setting = set_up(tmp_path_factory.mktemp("printed"))
    for name in FIGURE_NUMBERS:
        width, height = printed_size(name)
        size = f'width="{width}pt" height="{height}pt" viewBox="0 0 {width} {height}"'
        picture = re.sub(r'width=.*?viewBox="[^"]*"', size, PICTURE)
        (setting.root / f"results/figures/{name}.svg").write_text(picture, encoding="utf-8")
    setting.write_ledger()
    return PdfReader(io.BytesIO(typeset_pdf(setting.source, setting.root))).pages


@pytest.fixture(scope="module")
def texts(printed):
    """Text of each of these pages."""
    return [re.sub(r"\s+", " ", page.extract_text()) for page in printed]


def test_the_report_has_ten_pages_and_its_supplement_three(texts):
    (first,) = (number for number, text in enumerate(texts) if "S1 Values" in text)
    assert first <= REPORT_PAGES
    assert len(texts) - first <= SUPPLEMENT_PAGES
    assert "References [1]" in texts[first - 1] + texts[first - 2]


def test_nothing_stands_below_the_bottom_margin(printed):
    """Typst lets a figure of a column run over if it does not fit below the figures of the page."""
    assert min(map(lowest_baseline, printed)) > BOTTOM


def test_no_identifier_is_printed(texts):
    text = " ".join(texts)
    ids = [claim.id for claim in load_ledger("paper/claims.yaml").claims]
    assert [name for name in ids if name.count("-") > 1 and name in text] == []
    assert [name for name in FIGURE_NUMBERS if "_" in name and name in text] == []


def test_no_type_is_smaller_than_eight_points(pdf):
    """Subscripts, exponents and code in a line are parts of larger type."""
    sizes = Counter()

    def visit(text, _, matrix, __, size):
        sizes[round(abs(size * matrix[3]), 1)] += len(text.strip())

    for page in PdfReader(io.BytesIO(pdf)).pages:
        page.extract_text(visitor_text=visit)
    small = sum(count for size, count in sizes.items() if size < 7.9)
    assert small < 0.05 * sizes.total(), sizes


def test_no_address_is_hyphenated(pdf):
    text = "".join(page.extract_text() for page in PdfReader(io.BytesIO(pdf)).pages)
    text = re.sub(r"\s", "", text)
    bibliography = Path("paper/references.bib").read_text(encoding="utf-8")
    for address in re.findall(r"doi *= \{(.*)\}", bibliography):
        assert address in text


def test_two_builds_in_different_folders_are_identical(pdf, setting, tmp_path):
    first, second = (tmp_path / f"{name}.pdf" for name in "ab")
    for path in (first, second):
        typeset(setting.source, setting.root, path)
    assert first.read_bytes() == second.read_bytes() == pdf
    deeper = set_up(tmp_path / "another" / "folder")
    assert typeset_pdf(deeper.source, deeper.root) == pdf
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
    del numbers["slip-share"]
    setting.write_numbers(numbers)
    with pytest.raises(
        InvalidFile, match=r"numbers\.json: slip-share: no such number; allowed: the keys"
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
        typeset_pdf(setting.source, setting.root)
    assert "\n" not in str(raised.value)


def test_a_missing_source_is_named(tmp_path):
    with pytest.raises(InvalidFile, match=r"none\.typ: no such file"):
        typeset_pdf(tmp_path / "none.typ", tmp_path)


def test_the_built_report_has_ten_pages_and_a_supplement_of_three():
    path = Path("results/paper.pdf")
    if not path.exists():
        pytest.skip("there is no report; make builds it")
    pages = PdfReader(path).pages
    supplement = next(
        i for i, page in enumerate(pages) if "Supplement" in page.extract_text().split()
    )
    assert supplement <= 10
    assert len(pages) - supplement <= 3
    assert min(map(lowest_baseline, pages)) > BOTTOM
