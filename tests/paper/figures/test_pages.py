"""The pages in docs are those of the manual, with what their cells print and draw."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.figures.pages import __main__ as pages
from pulling_by_pushing.figures.pages import markdown
from pulling_by_pushing.figures.pages.cells import run_cells

#: What a page needs of the results: numbers, a verdict, datasets.
FROM_RESULTS = re.compile(r"\{number\}|results/tables|open_dataset\(")
NAMES = {
    page: (markdown.SOURCE / page).read_text(encoding="utf-8") for page in markdown.rendered_pages()
}
ALONE = [page for page, text in NAMES.items() if not FROM_RESULTS.search(text)]
WITH_RESULTS = [page for page in NAMES if page not in ALONE]


@pytest.mark.parametrize("page", ALONE, ids=str)
def test_stored_pages_are_those_of_the_manual(page):
    assert not pages.differing_files(page), "run make pages WRITE=1"


@pytest.mark.slow  # .ci/run runs the slow tests after make, which writes the results
@pytest.mark.parametrize("page", WITH_RESULTS, ids=str)
def test_stored_pages_have_the_numbers_of_the_results(page):
    if not Path("results/tables/numbers.json").exists():
        pytest.skip("there are no results; make builds them")
    assert not pages.differing_files(page), "run make pages WRITE=1"


def test_every_stored_page_and_picture_belongs_to_a_page():
    stored = {path.relative_to(markdown.OUTPUT) for path in markdown.OUTPUT.rglob("*.md")}
    assert stored == set(NAMES)
    text = "".join(path.read_text(encoding="utf-8") for path in markdown.OUTPUT.rglob("*.md"))
    for picture in (markdown.OUTPUT / "pictures").iterdir():
        assert f"pictures/{picture.name})" in text


@pytest.fixture
def project(tmp_path, monkeypatch):
    """A folder with one page and results."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "results/tables").mkdir(parents=True)
    numbers = {"edge": {"text": "-20.04", "unit": "degree"}}
    (tmp_path / "results/tables/numbers.json").write_text(json.dumps(numbers), encoding="utf-8")
    (tmp_path / "tests/golden/images").mkdir(parents=True)
    Image.new("RGB", (4, 4)).save("tests/golden/images/figure_01.png")
    (tmp_path / "paper/manual/theory").mkdir(parents=True)

    def write(text, name="theory/page.md"):
        (tmp_path / "paper/manual" / name).write_text(text, encoding="utf-8")
        return markdown.render_page(Path(name)).text

    return write


def test_roles_and_links(project):
    project("# Other\n", "other.md")
    text = "At {number}`edge`, {py:func}`~planar_pushing.solve`, [page](../other.md#part)\n"
    assert project(text) == "At \u221220.04°, `solve`, [page](../other.md#part)\n"
    assert project("[code](../../../src/a.py)") == "[code](../../src/a.py)"
    assert (
        project("[names](../reference/cones.md), ![x](https://a.b)\n")
        == "names, ![x](https://a.b)\n"
    )
    block = "```python\n[a](../reference/b.md)\n```\n"
    assert project(block) == block


def test_directives(project):
    figure = "```{figure} ../../../results/figures/figure_01.svg\n:alt: A fence.\n:width: 60%\n"
    figure += "\nAt {number}`edge`.\n```\n"
    shown = "![A fence.](../../tests/golden/images/figure_01.png)\n\n*At \u221220.04°.*\n"
    assert project(figure) == shown
    math = "```{math}\n:label: sum\n\na + b\n```\nBy {eq}`sum`\n"
    assert project(math) == "```math\na + b \\tag{1}\n```\nBy (1)\n"
    Path("results/tables/text.txt").write_text("one\ntwo\nthree\n", encoding="utf-8")
    part = "```{literalinclude} ../../../results/tables/text.txt\n:language: none\n"
    part += ":start-at: two\n:lines: -1\n```\n"
    assert project(part) == "```text\ntwo\n```\n"
    project("# A title\n", "theory/other.md")
    assert project("```{toctree}\n:hidden:\n\nother\n```\n") == "- [A title](other.md)\n"


def test_cells_print_and_draw(project):
    code = "x = 2\nprint('a')\nx + 1\n"
    cells = f"```{{code-cell}} ipython3\n{code}```\n```{{code-cell}} ipython3\nx;\n```\n"
    shown = f"```python\n{code}```\n\n```text\na\n3\n```\n```python\nx;\n```\n"
    assert project(cells) == shown
    plot = ["import matplotlib.pyplot as plt\nplt.plot([1, 2]);", "import os; sorted(os.listdir())"]
    drawn, listed = run_cells(plot, Path("results"))
    assert (drawn.text, len(drawn.pictures)) == ("", 1)
    assert listed == ("['results']\n", ())


@pytest.mark.parametrize(
    ("text", "said"),
    [("{number}`none`", "none: no such number"), ("{ref}`x`", r"\{ref\}; allowed: number"),
     ("```{note}\nx\n```\n", r"\{note\}; allowed")],
)  # fmt: skip
def test_what_plain_markdown_cannot_show_is_refused(project, text, said):
    with pytest.raises(InvalidFile, match=said):
        project(text)


def test_numbers():
    written = [
        markdown.format_number(text) for text in ("129600", "1e-08", "2.5e+3", "-3.0", "1234")
    ]
    assert written == ["129\u202f600", "10⁻⁸", "2.5 \u00d7 10³", "\u22123.0", "1234"]


def test_a_page_is_stored_once(project, capsys):
    project(
        "# Page\n```{code-cell} ipython3\nimport matplotlib.pyplot as plt\nplt.plot([1, 2]);\n```\n"
    )
    for more, code, said in (([], 1, "differs"), (["--write"], 1, "differs"), ([], 0, "unchanged")):
        assert pages.main(more) == code
        assert f"docs/theory/page.md: {said}" in capsys.readouterr().out
    picture = Path("docs/pictures/page_1.png")
    with Image.open(picture) as image:
        other = Image.fromarray(255 - np.asarray(image.convert("RGB")))
    other.save(picture)
    Path("docs/old.md").write_text("# Old\n", encoding="utf-8")
    assert pages.main([]) == 1
    assert "docs/old.md: has no source; remove it" in capsys.readouterr().out
