"""No number of the prose is typed: a digit in a section is part of a reference or of an equation.

Taken out before looking for digits: right and straight angles, comments, numbers named by their key,
references to equations, sections and figures of the paper, citations and labels, numbered equations, and
exponents.
"""

import re
from pathlib import Path

import pytest

from pulling_by_pushing.figures.figure import entry
from pulling_by_pushing.figures.studies import OURS, numbered
from pulling_by_pushing.report.tables import NUMBERS

SECTION_FILES = sorted(Path("paper/sections").glob("*.typ"))
NUMBER = re.compile(r"#(?:n|word)\(\"([\w-]+)\"\)|#equal\(\$\w+\$, \"([\w-]+)\"\)")
ALLOWED = (
    re.compile(r"^//.*$", re.MULTILINE),
    re.compile(r"\b(?:90|180)°"),
    NUMBER,
    re.compile(r"#(?:eq|eqs|fig|figs)\(\d+(?:, \d+)?\)"),
    re.compile(r"#claim\(\"[\w-]+\"\)"),
    re.compile(r"#sec\((?:\d|\"\d\.\d\")\)"),
    re.compile(r"#paper-figure\(\d+(?:, wide: true)?(?:, width: \d+%)?\)"),
    re.compile(r"#our-fig(?:ure)?\(\"\w+\"\)"),
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
        "The cone spans 170°.",
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
    assert numbers == list(range(1, len(numbered()) + 1))
    assert all(entry(name).section for name in numbered())


def parts(report):
    """Text of the report and of its supplement, with the sections in their order."""
    found = re.split(r"#show: supplement\n", report)
    assert len(found) == 2
    return [
        " ".join(
            Path("paper", name).read_text(encoding="utf-8")
            for name in re.findall(r'include "(sections/\w+\.typ)"', part)
        )
        for part in found
    ]


def test_figures_stand_in_the_order_of_their_numbers():
    """In the report and in its supplement, each with the figures that it shows."""
    order = [*numbered(), *OURS]
    shown = [
        [(number and f"figure_{int(number):02}") or name for number, name in re.findall(
            r"#paper-figure\((\d+)|#our-figure\(\"(\w+)\"\)", part
        )]
        for part in parts(Path("paper/report.typ").read_text(encoding="utf-8"))
    ]  # fmt: skip
    for figures in shown:
        assert figures == sorted(figures, key=order.index)
    assert sorted([name for figures in shown for name in figures], key=order.index) == order
    assert order[:13] == shown[0][:13]
