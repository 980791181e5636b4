"""Ranges of numbers in files."""

from pulling_by_pushing.study.study_file import load_study


def test_ranges_are_free_of_accumulated_rounding():
    shares = load_study("workflow/config/paper.yaml").grid.inertia_share
    assert shares == tuple(i / 20 for i in range(21))
