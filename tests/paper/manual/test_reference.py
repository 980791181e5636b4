"""The reference has an entry with an example for every public name, every command and every dataset."""

import re
from html import unescape

import pytest
from manual.pages import FOLDER

import planar_pushing as pp
from planar_pushing.commands import parser

pytestmark = pytest.mark.slow

ENTRY = re.compile(r"^\.\. auto\w+:: planar_pushing\.(\w+)\n(.*?)(?=^\.\. auto|^```)", re.M | re.S)
TEXT = "\n".join(page.read_text(encoding="utf-8") for page in FOLDER.glob("reference/*.md"))
ENTRIES = ENTRY.findall(TEXT)
COMMANDS = next(each.choices for each in parser()._actions if isinstance(each.choices, dict))


def test_no_entry_is_written_twice():
    assert sorted(name for name, _ in ENTRIES) == sorted(pp.__all__)


@pytest.mark.parametrize("name", pp.__all__)
def test_every_public_name_has_an_example(name):
    assert ">>> " in dict(ENTRIES)[name]


def plain(html):
    """The text of a piece of HTML, its spaces as one."""
    return " ".join(unescape(re.sub(r"<[^>]*>", " ", html)).split())


def closed(text):
    """The letters, digits and signs of a text, whose spaces and quotation marks Sphinx sets anew."""
    return "".join(re.findall(r"[\w.,:;()/+*=<>\[\]-]", text))


@pytest.mark.parametrize("name", COMMANDS)
def test_help_and_the_page_say_the_same_of_every_argument(name, html, monkeypatch):
    monkeypatch.setenv("COLUMNS", "1000")
    text = (html / "reference/commands.html").read_text(encoding="utf-8")
    section = text[text.index(f'id="command-{name}"') :].partition("</section>")[0]
    terms = [plain(term) for term in re.findall(r"<dt>(.*?)</dt>", section, re.DOTALL)]
    said = COMMANDS[name].format_help()
    lines = re.findall(r"^  (\S.*?)(?: {2,}|\n {3,})(\S.*)$", said, re.MULTILINE)
    listed = {typed: about for typed, about in lines if typed not in ("-h, --help", "--json")}
    assert sorted(terms) == sorted(listed)
    assert all(closed(about) in closed(plain(section)) for about in listed.values())
    assert closed(COMMANDS[name].description) in closed(plain(section))


def test_the_page_has_the_commands_of_help_in_their_order(html, monkeypatch):
    monkeypatch.setenv("COLUMNS", "1000")
    text = (html / "reference/commands.html").read_text(encoding="utf-8")
    said = parser().format_help()
    listed = re.findall(r"^    (\S+)(?: |$)", said, re.MULTILINE)
    assert re.findall(r'<section id="command-([\w-]+)"', text) == listed == list(COMMANDS)


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_is_described_with_its_options(name, html, monkeypatch):
    monkeypatch.setenv("COLUMNS", "1000")  # help breaks lines at hyphens
    text = (html / "reference/commands.html").read_text(encoding="utf-8")
    section = text[text.index(f'id="command-{name}"') :].partition("</section>")[0]
    words = set(re.findall(r"--[\w-]+", section))
    options = set(re.findall(r"(?<!\w)--[a-z][\w-]+", COMMANDS[name].format_help()))
    assert options - {"--help", "--json"} <= words
    assert f"$ planar-pushing {name}" in re.sub(r"<[^>]*>", "", section)
