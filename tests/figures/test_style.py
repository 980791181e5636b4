"""The style sheet."""

import matplotlib

from planar_pushing.figures import style


def test_the_style_does_not_depend_on_the_user_and_leaves_nothing_behind():
    with matplotlib.rc_context({"lines.linewidth": 9.0, "svg.hashsalt": None}):
        with style.paper_style():
            assert matplotlib.rcParams["lines.linewidth"] == 1.2
            assert matplotlib.rcParams["svg.hashsalt"] == "planar-pushing"
        assert matplotlib.rcParams["lines.linewidth"] == 9.0


def test_all_text_is_readable_at_column_width():
    with style.paper_style():
        sizes = [v for k, v in matplotlib.rcParams.items() if k in ("font.size", "xtick.labelsize")]
    assert min([*sizes, style.SYMBOL_SIZE, style.NOTE_SIZE]) >= 7
