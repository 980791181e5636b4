"""Looks of lines in a panel: legible on white, and told apart by a deuteranope or by their dashes."""

from itertools import combinations, cycle

import pytest
from drawing.test_colors import contrast, distance

from planar_pushing.drawing.canvas.colors import support_colors
from pulling_by_pushing.figures.parts.gallery import families
from pulling_by_pushing.figures.parts.methods import LOOKS
from pulling_by_pushing.figures.parts.rods import DASHES
from pulling_by_pushing.study.study_file import load_study


@pytest.mark.parametrize("method", LOOKS)
def test_methods_have_contrast_on_white(method):
    assert contrast(LOOKS[method]["color"]) >= 3


@pytest.mark.parametrize("family", [0, 1])
def test_supports_of_a_panel_differ_for_a_deuteranope_or_by_their_dashes(family):
    names = families(load_study("workflow/config/sliders.yaml").gallery(), 1.0)[family]
    looks = list(zip(support_colors(names).values(), cycle(DASHES), strict=False))
    assert len(looks) > 1
    for (one, dash), (other, broken) in combinations(looks, 2):
        assert dash != broken or distance(one, other) >= 20
