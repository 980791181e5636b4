"""The manual as HTML: links, what it loads, and the same bytes twice."""

import re
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

import pytest
from manual.conftest import pages_as_html
from manual.pages import PAGES
from manual.pages import name as page_name
from report.setting import Setting, set_up

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.report.manual import build_manual

pytestmark = pytest.mark.slow

#: Attributes that name what a page loads by itself.
LOADED = {("script", "src"), ("img", "src"), ("link", "href"), ("source", "src")}


class Page(HTMLParser):
    """What a page links to, what it loads, and its anchors."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loads, self.anchors = [], [], {""}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        found = dict(attrs)
        self.anchors |= {found.get("id"), found.get("name")}
        if tag == "a" and "href" in found:
            self.links.append(found["href"])
        self.loads += [found[key] for each, key in LOADED if each == tag and found.get(key)]


@pytest.fixture(scope="session")
def pages(html):
    found = {path: Page(path) for path in html.rglob("*.html")}
    assert {html / f"{page_name(page)}.html" for page in PAGES} <= set(found)
    return found


def test_every_internal_link_leads_somewhere(pages):
    for path, page in pages.items():
        for link in page.links:
            place = urlsplit(link)
            if place.scheme or place.netloc:
                continue
            target = (path.parent / unquote(place.path)).resolve() if place.path else path
            assert target.is_file(), f"{path.name}: {link}"
            if target in pages:
                assert unquote(place.fragment) in pages[target].anchors, f"{path.name}: {link}"


def test_nothing_is_loaded_from_elsewhere(html, pages):
    for path, page in pages.items():
        for place in page.loads:
            found = urlsplit(place)
            assert not found.netloc, f"{path.name}: {place}"
            if found.path and found.scheme != "data":
                assert (path.parent / found.path).is_file(), f"{path.name}: {place}"
    for path in html.rglob("*.css"):
        assert not re.search(r"url\(['\"]?(?:https?:)?//", path.read_text(encoding="utf-8")), path


def test_formulas_are_set_without_a_network(html):
    assert (html / "_static/mathjax/tex-chtml.js").is_file()


def test_two_builds_are_identical(html, tmp_path):
    first, second = (
        {path.relative_to(root): path.read_bytes() for path in root.rglob("*") if path.is_file()}
        for root in (html, pages_as_html(tmp_path / "second"))
    )
    assert first.keys() == second.keys()
    assert [str(name) for name in first if first[name] != second[name]] == []


def test_no_page_names_its_folder(html):
    for path in html.rglob("*"):
        if path.is_file():
            assert str(html.parent).encode() not in path.read_bytes(), path


def short_manual(root, text):
    """A folder of pages with one page, beside results of marked numbers."""
    set_up(root)
    source = root / "short/pages"
    source.mkdir(parents=True)
    for name in ("conf.py", "extensions", "_static"):
        (source / name).symlink_to(root / "paper/manual" / name)
    (source / "index.md").write_text(text, encoding="utf-8")
    return source


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[away](absent.md)", "absent.md"),
        ("{number}`absent`", "absent: no such number in "),
        ("```{results-table} absent.csv\n```", "absent.csv: no such table; build it with make"),
    ],
)
def test_what_is_missing_stops_the_build(tmp_path, text, said):
    source = short_manual(tmp_path, f"# Title\n\n{text}\n")
    with pytest.raises(InvalidFile, match="pages: cannot be built: ") as stopped:
        build_manual(source, tmp_path / "html")
    assert said in str(stopped.value)
    assert not (tmp_path / "html").exists()


NOTEBOOK = """# Title

```{code-cell} ipython3
import json, sys
from ipykernel.connect import get_connection_info
print(sys.executable, json.loads(get_connection_info())["ip"], sep=" on ")
```
"""


def test_kernels_run_this_python_on_loopback_and_need_no_home(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", "/dev/null")
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    build_manual(short_manual(tmp_path, NOTEBOOK), tmp_path / "html")
    assert f"{sys.executable} on 127.0.0.1" in (tmp_path / "html/index.html").read_text()


PLOTS = """
```{code-cell} ipython3
import matplotlib.pyplot as plt
import planar_pushing as pp
friction = (pp.RingFriction(),)
pp.draw(pp.Scene(slider=pp.Slider(rod_length=2, rod_angle=1), contact=pp.Coulomb(1), effects=friction));
```

```{code-cell} ipython3
plt.plot([1, 2]);
```
"""


def test_every_cell_shows_its_plot(tmp_path):
    build_manual(short_manual(tmp_path, NOTEBOOK + PLOTS), tmp_path / "html")
    assert (tmp_path / "html/index.html").read_text(encoding="utf-8").count("<img") == 2


READ = """# Title

{number}`values` and {number}`edge`.

```{results-table} ellipsoids.csv
```
"""


def test_numbers_and_tables_are_read_from_the_results(tmp_path):
    source = short_manual(tmp_path, READ)
    values = {"values": ("22019911", "1"), "edge": ("-1.6e-14", "degree")}
    entries = {key: {"text": text, "unit": unit} for key, (text, unit) in values.items()}
    Setting(tmp_path).write_numbers(entries)
    build_manual(source, tmp_path / "html")
    text = (tmp_path / "html/index.html").read_text(encoding="utf-8")
    assert "22\u202f019\u202f911 and \u22121.6 \u00d7 10⁻¹⁴°." in text
    assert "some support" in text
