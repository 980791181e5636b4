"""The page on evidence has the numbers of the results."""

import json
import re
from pathlib import Path

import pytest

# .ci/run runs the slow tests after make, which writes the results.
pytestmark = pytest.mark.slow

TEXT = " ".join(Path("paper/manual/evidence.md").read_text(encoding="utf-8").split())
NUMBERS = Path("results/tables/numbers.json")
#: Sentences of the page, with keys of the numbers in them.
SENTENCES = (
    "{golden-enclosed} numbers of {golden-variables} variables are compared",
    "at {golden-by-integrals} centers",
    "by {golden-roundings} roundings",
    "{golden-integrated} numbers of motions over time",
    "{golden-plain} numbers (data plotted",
    "The other {golden-labels} entries",
    "{claims} statements, {claims-ours} of them ours, with {claims-checks} checks",
    "| proved | {claims-proved} |",
    "| enclosed | {claims-enclosed} |",
    "| sampled | {claims-sampled} |",
    "| open | {claims-open} |",
    "| refuted | {claims-refuted} |",
    "over the {spin-ratios} spin ratios in the report is {closed-form-error} machine epsilons",
    "are accurate to {cone-error},",
    "one third, {ellipsoid-limit}: this",
    "contains {hard-cases} cases",
    "{hard-well} cases are well-conditioned, and {hard-accurate} of these",
    "up to {hard-thin} units in the last place",
    "{hard-ill} are ill-conditioned, with a condition number above {hard-limit},",
    "{pushes-feet} pushes of a triangle on three feet, {pushes-face} pushes",
    "and {pushes-sides} pushes of polygons",
    "has a median error of {pushes-feet-motion-known-feet};",
    "for the same feet it is {pushes-feet-motion-known-feet-ellipsoid}.",
)


def in_words(number):
    """A number as the page writes it."""
    value = float(number["text"])
    if value >= 1e6:
        text = f"{value / 1e6:.2g} million"
    else:
        text = f"{value:,.0f}" if value >= 1e4 else number["text"]
    return text + {"degree": " degrees"}.get(number["unit"], "")


@pytest.mark.parametrize("sentence", SENTENCES)
def test_numbers_are_those_of_the_results(sentence):
    if not NUMBERS.exists():
        pytest.skip("there are no results; make builds them")
    numbers = json.loads(NUMBERS.read_text(encoding="utf-8"))
    assert re.sub(r"\{(.*?)\}", lambda key: in_words(numbers[key[1]]), sentence) in TEXT
