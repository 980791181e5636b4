"""Links of pages lead to files and headings that exist; pages for visitors are plain Markdown."""

import re
from pathlib import Path

import pytest

PAGES = sorted(
    path
    for pattern in ("*.md", "results/README.md", "paper/**/*.md", "docs/**/*.md")
    for path in Path().glob(pattern)
)
BLOCK = re.compile(r"^(`{3,}).*?^\1 *$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)\s]+)\)")
SCHEME = re.compile(r"[a-z]+:")
#: Pages that a visitor reads as they are in the repository.
PLAIN = [
    Path(name)
    for name in (
        "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "results/README.md", "paper/deviations.md",
        "paper/manual/evidence.md", "paper/manual/glossary.md", "paper/manual/limits.md",
        "paper/manual/readers.md",
    )
] + sorted(Path("docs").rglob("*.md"))  # fmt: skip


def text_of(page):
    """Text of a page without its blocks of code."""
    return BLOCK.sub("", page.read_text(encoding="utf-8"))


def anchors(page):
    """Anchors of the headings of a page, as GitHub and Sphinx make them, and its labels."""
    text = text_of(page)
    headings = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    slugs = {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}
    return slugs | set(re.findall(r"^\(([\w-]+)\)=$", text, re.MULTILINE))


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_links_lead_to_files_and_headings(page):
    for link in LINK.findall(text_of(page)):
        if SCHEME.match(link):
            continue
        name, _, anchor = link.partition("#")
        target = (page.parent / name).resolve() if name else page.resolve()
        assert target.exists(), link
        assert not anchor or anchor in anchors(target), link


@pytest.mark.parametrize("page", PLAIN, ids=str)
def test_pages_that_visitors_read_are_plain_markdown(page):
    assert not re.search(r"^`{3,}\{|\{[\w:]+\}`", page.read_text(encoding="utf-8"), re.MULTILINE)


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_targets_of_make_exist(page):
    targets = re.findall(r"^([a-z-]+):", Path("Makefile").read_text(encoding="utf-8"), re.MULTILINE)
    typed = re.findall(r"(?:`|^\$ )make ([a-z-]+)", page.read_text(encoding="utf-8"), re.MULTILINE)
    assert set(typed) <= set(targets)
