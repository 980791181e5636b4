"""Solutions in a user's hands: indexed, compared, printed."""

from dataclasses import replace

import numpy as np
import pytest

import planar_pushing as pp
from mechanics.builders import make_scene

PULL = np.deg2rad(-10)


@pytest.fixture
def three():
    """Separate, stick and slip-left are all consistent."""
    return pp.solve(make_scene(2.0, 2.0), PULL)


def test_indices_and_slices(three):
    assert [three[i].mode.name for i in (0, 1, -1)] == ["SEPARATE", "STICK", "SLIP_LEFT"]
    assert three[1:] == tuple(three)[1:]
    assert three[1] in three
    with pytest.raises(IndexError):
        three[3]


def test_a_mode_is_no_index(three):
    """It is a whole number, and would pick the solution that happens to have it as its place."""
    with pytest.raises(pp.InvalidValue, match="pick a mode with") as caught:
        three[pp.ContactMode.STICK]
    assert caught.value.name == "index"


def test_solutions_are_equal_where_every_number_is(three):
    assert three == pp.solve(make_scene(2.0, 2.0), PULL)
    assert three != pp.solve(make_scene(2.0, 2.0), np.nextafter(PULL, 0.0))
    assert three != pp.solve(make_scene(2.0, 2.0), 1.0)
    assert three[0] == three[0]
    assert three[1] != three[2]
    assert (three == 3, three[0] == 3) == (False, False)


def test_results_of_arrays_are_equal_or_not_as_a_whole():
    scene, angles = make_scene(2.0, 2.0), np.array([PULL, 1.0])
    assert pp.solve(scene, angles) == pp.solve(scene, angles)
    assert pp.solve(scene, angles) != pp.solve(scene, angles + 1e-9)
    assert pp.solve(scene, angles) != pp.solve(scene, angles[:1])
    assert pp.limit_curve(scene, angles) == pp.limit_curve(scene, angles)
    assert pp.limit_curve(scene, angles) != pp.limit_curve(scene, angles + 1e-9)


def test_printed_they_are_a_table_with_a_column_each(three):
    lines = repr(three).splitlines()
    assert lines[0] == "AMBIGUOUS: 3 consistent solutions"
    assert lines[1].split() == ["SEPARATE", "STICK", "SLIP_LEFT"]
    rows = {line[:12].strip(): line[12:].split() for line in lines[2:]}
    assert len(rows) == 10
    assert rows["force x"][0] == "0"
    assert rows["omega"] == [f"{each.twist[2]:.6g}" for each in three]
    assert rows["center y"][0] == "inf"
    assert max(map(len, lines)) < 80


def test_the_table_of_a_notebook(three):
    html = three._repr_html_()
    assert html.startswith("<svg ")
    assert "</svg><p>AMBIGUOUS: 3 consistent solutions</p>\n<table" in html
    assert html.count("<tr") == 11
    assert html.count("<td>") == 30
    assert all(f"<th>{mode}</th>" in html for mode in three.modes)


def test_one_solution_and_none_in_words():
    one = pp.solve(make_scene(2.0, 2.0), 1.0)
    none = pp.solve(make_scene(2.0, pp.InfiniteFriction("none")), np.deg2rad(165))
    assert repr(one).startswith("UNIQUE: 1 consistent solution\n")
    assert repr(none) == "INCONSISTENT: 0 consistent solutions"
    assert none._repr_html_().endswith("</svg><p>INCONSISTENT: 0 consistent solutions</p>")
    assert (
        replace(none, problem=None)._repr_html_() == "<p>INCONSISTENT: 0 consistent solutions</p>"
    )
