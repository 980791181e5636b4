"""The gallery shows every figure of the project's studies, with its code and its command."""

import re
from html import unescape
from pathlib import Path

import pytest

from pulling_by_pushing.figures.figure import entry, module_name
from pulling_by_pushing.figures.studies import OURS, study_figures
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE
from pulling_by_pushing.study.study_file import load_study

pytestmark = pytest.mark.slow


def undrawn():
    """Simulations that no figure of their study shows."""
    for file in (PAPER_FILE, SLIDERS_FILE):
        study = load_study(file)
        shown = {source for name in study.figures for source in entry(name).reads}
        yield from (name for name in study.simulations if f"simulations/{name}" not in shown)


@pytest.fixture(scope="module")
def gallery(html):
    return (html / "gallery.html").read_text(encoding="utf-8")


def section(gallery, name):
    return gallery.partition(f'<section id="{name}">')[2].partition("</section>")[0]


@pytest.mark.parametrize("name", [*study_figures(), *OURS])
def test_every_figure_has_its_picture_caption_command_and_code(gallery, name):
    found = section(gallery, name.replace("_", "-"))
    assert f'src="_images/{name}.svg"' in found
    assert "<figcaption>" in found
    text = unescape(re.sub("<[^>]*>", "", found))
    assert f"figures/{name}.svg\n" in text
    module = module_name(name).replace(".", "/")
    code = Path(f"src/pulling_by_pushing/figures/{module}.py").read_text(encoding="utf-8")
    assert code in text


def test_every_other_simulation_has_its_picture_and_its_scene(gallery):
    names = list(undrawn())
    assert names
    for name in names:
        found = section(gallery, f"simulation-{name.replace('_', '-')}")
        assert f'src="_images/simulation_{name}.svg"' in found
        assert Path(re.search("<summary><code>(.*?)</code>", found)[1]).is_file()


@pytest.mark.parametrize("name", ["two-fingers", "box-along-a-wall", "finger-in-a-corner"])
def test_scenes_with_several_contacts_have_their_picture_command_and_file(gallery, name):
    found = section(gallery, f"scene-{name}")
    assert "<svg" in found
    text = unescape(re.sub("<[^>]*>", "", found))
    code = f"workflow/scenes/{name.replace('-', '_')}.yaml"
    assert f"planar-pushing draw {code} -o " in text
    assert Path(code).read_text(encoding="utf-8").rstrip() in text


def test_no_figure_is_shown_twice(gallery):
    pictures = re.findall(r'src="(_images/[^"]*)"', gallery)
    assert len(pictures) == len(set(pictures)) == len([*study_figures(), *OURS, *undrawn()])
