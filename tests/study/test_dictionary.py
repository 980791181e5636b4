"""The data dictionary."""

from pathlib import Path

from planar_pushing.study.dictionary import dictionary_text


def test_data_dictionary_is_that_of_the_datasets(results):
    stored = Path("results/README.md").read_text(encoding="utf-8")
    assert stored == dictionary_text(str(results)), "run make dictionary"
