"""Figure 7."""

from numpy.testing import assert_allclose


def test_figure_07_cones_are_the_published_ones(plotted):
    data = plotted["figure_07"]
    published = {1.0: 158.70186040475, 2.0: 148.61039132208, 5.0: 138.83997216476}
    assert_allclose(data.motion_cone_left, [*published.values()], rtol=1e-12)
    assert_allclose(data.motion_cone_left - data.motion_cone_right, 180, rtol=1e-13)


def test_every_panel_names_both_sectors_and_has_a_scale(pictures):
    for ax in pictures["figure_07"].axes:
        words = [text.get_text() for text in ax.texts]
        assert {"slip", "pull", "$1$"} <= set(words)
