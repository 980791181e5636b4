"""No number of the prose is typed: a digit in a section is part of a reference or of an equation.

Taken out before looking for digits: right and straight angles, comments, numbers named by their key,
references to equations, sections and figures of the paper, citations and labels, numbered equations, and
exponents.
"""

import re
from pathlib import Path

import pytest
from manual.test_evidence import SENTENCES

from pulling_by_pushing.evidence.claims.ledger import load_ledger
from pulling_by_pushing.figures.studies import BODY, SUPPLEMENT
from pulling_by_pushing.report.tables import NUMBERS

SECTION_FILES = sorted(Path("paper/sections").glob("*.typ"))
NUMBER = re.compile(r"#(?:n|word)\(\"([\w-]+)\"\)|#equal\(\$\w+\$, \"([\w-]+)\"\)")
ALLOWED = (
    re.compile(r"^//.*$", re.MULTILINE),
    re.compile(r"\b(?:90|180)°"),
    NUMBER,
    re.compile(r"#(?:eq|eqs|fig|figs)\(\d+(?:, \d+)?\)"),
    re.compile(r"#(?:claim|theorem)\(\"[\w-]+\"|\bverdict-row\(\"[\w-]+\""),
    re.compile(r"#sec\((?:\d|\"\d\.\d\")\)"),
    re.compile(r"#paper-figure\(\d+(?:, wide: true)?(?:, width: \d+%)?\)"),
    re.compile(r"#our-fig(?:ure)?\(\"\w+\"(?:, width: \d+%)?\)"),
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


def test_report_and_manual_name_every_number_and_no_other():
    in_report = NUMBER.findall(" ".join(path.read_text(encoding="utf-8") for path in sources()))
    pages = " ".join(
        path.read_text(encoding="utf-8") for path in Path("paper/manual").rglob("*.md")
    )
    keys = {first or second for first, second in in_report}
    assert keys <= set(NUMBERS)
    plain = re.findall(r"\{([\w-]+)\}", " ".join(SENTENCES))  # on a page that a test compares
    assert keys | set(re.findall(r"\{number\}`([\w-]+)`", pages)) | set(plain) == set(NUMBERS)


def test_no_stop_after_a_number_is_lost():
    # Typst takes a semicolon after a call as the call's end and sets nothing.
    for path in sources():
        assert not re.search(r"#[\w-]+\([^)]*\);", path.read_text(encoding="utf-8")), path


def test_every_section_is_part_of_the_report():
    report = Path("paper/report.typ").read_text(encoding="utf-8")
    included = re.findall(r'include "(sections/\w+\.typ)"', report)
    assert sorted(included) == [f"sections/{path.name}" for path in SECTION_FILES]


def parts():
    """Text of the report and of its supplement, with the sections in their order."""
    report = Path("paper/report.typ").read_text(encoding="utf-8")
    halves = re.split(r"#show: supplement\n", report)
    assert len(halves) == 2
    return [
        " ".join(
            Path("paper", name).read_text(encoding="utf-8")
            for name in re.findall(r'include "(sections/\w+\.typ)"', half)
        )
        for half in halves
    ]


#: What shows a figure: one of the paper's numbers, or a name of ours.
SHOWN = re.compile(r"#paper-figure\((\d+)|#our-figure\(\"(\w+)\"")
#: A mention: one figure, two neighbors, or one of ours; a longer range is about all figures of the paper.
MENTIONED = re.compile(r"#fig\((\d+)\)|#figs\((\d+), (\d+)\)|#our-fig\(\"(\w+)\"\)")


def paper_name(number):
    return f"figure_{int(number):02}"


def mentions(text):
    """Names of the figures in the order of their mentions."""
    for one, first, second, ours in MENTIONED.findall(text):
        if one or ours:
            yield ours or paper_name(one)
        elif int(second) == int(first) + 1:
            yield from (paper_name(first), paper_name(second))


def test_every_figure_is_shown_once_in_its_half():
    for half, names in zip(parts(), (BODY, SUPPLEMENT), strict=True):
        shown = [ours or paper_name(number) for number, ours in SHOWN.findall(half)]
        assert shown == list(names)


def test_figures_are_mentioned_in_the_order_of_their_numbers():
    """Those of the report, and those of its supplement."""
    mentioned = dict.fromkeys(mentions(" ".join(parts())))
    for names in (BODY, SUPPLEMENT):
        assert [name for name in mentioned if name in names] == list(names)
    body = set(mentions(parts()[0]))
    assert body >= set(BODY)


def test_statements_theorems_and_propositions_are_mentioned_in_the_order_of_their_numbers():
    """They are numbered in the order of the ledger."""
    ids = re.findall(r"#(?:claim|theorem)\(\"([\w-]+)\"", " ".join(parts()))
    ledger = [claim for claim in load_ledger("paper/claims.yaml").claims if claim.id in ids]
    tables = Path("paper/claims_table.typ").read_text(encoding="utf-8")
    theorems = re.findall(r"\"([\w-]+)\"", re.search(r"#let theorems = \((.*)\)", tables)[1])
    assert len(theorems) == 2
    mentioned = list(dict.fromkeys(ids))
    for numbered in (
        [claim.id for claim in ledger if claim.origin == "paper"],
        [claim.id for claim in ledger if claim.id in theorems],
        [claim.id for claim in ledger if claim.origin == "ours" and claim.id not in theorems],
    ):
        assert numbered
        assert [name for name in mentioned if name in numbered] == numbered


def test_statements_of_the_ledger_ascend_with_the_sections_of_the_paper():
    sections = [
        claim.section
        for claim in load_ledger("paper/claims.yaml").claims
        if claim.origin == "paper"
    ]
    assert sections == sorted(sections)


def test_every_work_is_cited_and_in_the_references():
    text = " ".join([*parts(), Path("paper/report.typ").read_text(encoding="utf-8")])
    bibliography = Path("paper/references.bib").read_text(encoding="utf-8")
    entries = re.findall(r"^@\w+\{([\w-]+),", bibliography, re.MULTILINE)
    labels = re.findall(r"<([\w-]+)>", text)
    assert set(re.findall(r"(?<!\w)@([a-z][\w-]*[a-z\d])", text)) - set(labels) == set(entries)
