"""What the figures of accuracy share."""

import pytest

from figures.evidence.conftest import GROUPS, markers
from planar_pushing.figures import render
from planar_pushing.figures.evidence.work_precision import setting_text
from planar_pushing.study.store import read_dataset


@pytest.mark.parametrize(
    "name", ["accuracy_wrench", "accuracy_cone", "accuracy_evaluations", "accuracy_time"]
)
def test_the_legend_names_every_method(pictures, data, name):
    (legend,) = pictures[name].legends
    given = set(read_dataset(data, GROUPS[name]).method.values)
    assert {text.get_text() for text in legend.get_texts()} == given


@pytest.mark.parametrize(
    ("value", "text"),
    [(1e-12, "$10^{-12}$"), (2e-5, r"$2 \times 10^{-5}$"), (16, "16"), (65536, "65\u2009536")],
)
def test_settings_are_written_in_one_way(value, text):
    assert setting_text(value) == text


@pytest.mark.parametrize("name", ["accuracy_wrench", "accuracy_evaluations", "accuracy_time"])
def test_no_mark_stands_on_the_frame(pictures, name):
    for ax in pictures[name].axes:
        low, high = ax.get_ylim()
        marks = markers(ax)[:, 1]
        assert marks.min() > 2 * low
        assert marks.max() < high / 2


@pytest.mark.slow
@pytest.mark.parametrize("name", ["accuracy_motion", "accuracy_evaluations"])
def test_pictures_have_the_same_bytes_twice(data, tmp_path, name):
    first, second = ([tmp_path / f"{run}.{kind}" for kind in ("svg", "pdf", "png")] for run in "ab")
    for paths in (first, second):
        render.render_file(name, data, paths)
    assert all(a.read_bytes() == b.read_bytes() for a, b in zip(first, second, strict=True))


@pytest.mark.parametrize(
    ("name", "panel", "method", "words"),
    [
        ("accuracy_motion", 0, "event-driven", "tolerance {}"),
        ("accuracy_motion", 1, "time-stepping", "{} steps"),
        ("accuracy_cone", 0, "cubic table", "{} entries"),
    ],
)
def test_the_ends_of_a_line_are_named_by_their_settings(pictures, data, name, panel, method, words):
    found = read_dataset(data, GROUPS[name])
    ends = found.setting[found.method == method].values[[0, -1]]
    texts = [text.get_text() for text in pictures[name].axes[panel].texts]
    assert {words.format(setting_text(end)) for end in ends} <= set(texts)
