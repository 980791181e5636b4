"""No number of the prose is typed: a digit in a section is part of a reference or of an equation.

Taken out before looking for digits: comments, numbers named by their key, references to equations, sections
and figures of the paper, citations and labels, numbered equations, and exponents.
"""

import re
from pathlib import Path

import pytest

from planar_pushing.figures.catalog import CAPTIONS, FIGURES, PROMISES, SECTIONS
from planar_pushing.report.numbers import NUMBERS

SECTION_FILES = sorted(Path("paper/sections").glob("*.typ"))
NUMBER = re.compile(r"#n\(\"([\w-]+)\"\)|#equal\(\$\w+\$, \"([\w-]+)\"\)")
ALLOWED = (
    re.compile(r"^//.*$", re.MULTILINE),
    NUMBER,
    re.compile(r"#(?:eq|eqs|fig|figs)\(\d+(?:, \d+)?\)"),
    re.compile(r"#sec\((?:\d|\"\d\.\d\")\)"),
    re.compile(r"#paper-figure\(\d+(?:, wide: true)?\)"),
    re.compile(r"@[\w-]+|<[\w-]+>"),
    re.compile(r"\$ .*? \$", re.DOTALL),
    re.compile(r"\^\d"),
)


def prose(text):
    """Source without what may hold digits."""
    for pattern in ALLOWED:
        text = pattern.sub(" ", text)
    return text


def sources():
    return [*SECTION_FILES, Path("paper/report.typ")]


@pytest.mark.parametrize("path", sources(), ids=lambda path: path.stem)
def test_no_digit_is_typed(path):
    lines = prose(path.read_text(encoding="utf-8")).splitlines()
    assert [line for line in lines if re.search(r"\d", line)] == []


@pytest.mark.parametrize(
    "typed",
    [
        "The cone spans 180 degrees.",
        "For $l = 2$ it pulls.",
        '#n("pushes") and 3 more',
        "Fig. 12",
        "#text(size: 9pt)[word]",
    ],
)
def test_a_typed_number_is_found(typed):
    assert re.search(r"\d", prose(typed))


def test_the_prose_names_every_number_and_no_other():
    found = NUMBER.findall(" ".join(path.read_text(encoding="utf-8") for path in sources()))
    assert {first or second for first, second in found} == set(NUMBERS)


def test_no_stop_after_a_number_is_lost():
    # Typst takes a semicolon after a call as the call's end and sets nothing.
    for path in sources():
        assert not re.search(r"#[\w-]+\([^)]*\);", path.read_text(encoding="utf-8")), path


def test_every_section_is_part_of_the_report():
    report = Path("paper/report.typ").read_text(encoding="utf-8")
    included = re.findall(r'include "(sections/\w+\.typ)"', report)
    assert sorted(included) == [f"sections/{path.name}" for path in SECTION_FILES]


def test_every_figure_is_in_the_report_and_described():
    text = " ".join(path.read_text(encoding="utf-8") for path in SECTION_FILES)
    numbers = sorted(int(number) for number in re.findall(r"#paper-figure\((\d+)", text))
    assert numbers == list(range(1, len(FIGURES) + 1))
    assert set(CAPTIONS) == set(PROMISES) == set(SECTIONS) == set(FIGURES)


def test_our_captions_hold_no_numbers():
    assert [name for name, caption in CAPTIONS.items() if re.search(r"\d", caption)] == []
