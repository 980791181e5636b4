"""What accuracy costs is measured by its own target alone."""

import re


def test_the_target_measures_once_and_draws_its_figures(built):
    said = built.snakemake("--dry-run", "accuracy")
    table = re.search(r"Job stats:\njob +count\n[- ]+\n(.*?)\ntotal", said, re.DOTALL)
    jobs = dict(re.findall(r"(\w+) +(\d+)", table[1]))
    drawn = {"accuracy_figure": "3", "effects_figure": "1"}
    assert jobs == {"accuracy": "1", "accuracy_data": "1", "effects_data": "1"} | drawn


def test_the_default_target_leaves_it_out(built):
    assert "accuracy" not in built.snakemake("--dry-run")
