"""The page for readers of the paper names figures, sections, functions and datasets that exist."""

import re
from pathlib import Path

import pytest

import planar_pushing as pp
from pulling_by_pushing.figures.figure import entry
from pulling_by_pushing.figures.studies import NUMBERS

PAGE = Path("paper/manual/readers.md")
REPORT = Path("paper/report.typ")
SHOWN = re.compile(r'#(?:paper|our)-figure\("?(\w+)"?')
ROWS = {
    cells[0]: cells
    for line in PAGE.read_text(encoding="utf-8").splitlines()
    if (cells := [cell.strip() for cell in line.strip("|").split("|")])[0] in NUMBERS.values()
}


def report_sections():
    """Heading of the section of the report that shows each figure."""
    shown = {}
    for file in re.findall(r'#include "(sections/\w+\.typ)"', REPORT.read_text(encoding="utf-8")):
        text = (REPORT.parent / file).read_text(encoding="utf-8")
        heading = re.search(r"^= (.*?)(?: <[\w-]+>)?$", text, re.MULTILINE)
        for name in SHOWN.findall(text):
            shown[f"figure_{int(name):02}" if name.isdigit() else name] = heading[1]
    return shown


def test_every_figure_has_its_row_in_order():
    assert list(ROWS) == list(NUMBERS.values())


@pytest.mark.parametrize("name", NUMBERS)
def test_title_section_and_datasets_of_a_figure(name):
    number, title, section, _, datasets = ROWS[NUMBERS[name]]
    assert (number, title) == (NUMBERS[name], entry(name).title)
    assert section == report_sections()[name]
    assert datasets == ", ".join(f"`{source}`" for source in entry(name).reads)


def test_the_page_names_public_functions():
    names = re.findall(r"`pp\.(\w+)`", PAGE.read_text(encoding="utf-8"))
    assert set(names) <= set(pp.__all__)
    assert all("`pp." in cells[3] for cells in ROWS.values())
