"""Units and long names: one table, with an entry of its own where a log means something else."""

from planar_pushing.terms.quantities import (
    BATCH,
    DATASET,
    LOG,
    LOG_NOTES,
    MECHANICS,
    NOTES,
    attributes,
    unit_of,
)


def test_an_entry_has_a_unit_and_a_long_name():
    assert attributes(DATASET, "rod_angle") == {"units": "degree", "long_name": "rod angle"}
    assert unit_of(attributes(LOG, "twist")) == "length/time"


def test_units_are_those_of_udunits():
    plain = {"1", "degree", "radian", "radian-1", "s"}
    for quantities in (DATASET, LOG, BATCH, MECHANICS):
        for name, (unit, _) in quantities.items():
            found = attributes(quantities, name)
            assert found["units"] in plain, name
            assert unit_of(found) == unit
            assert found.get("quantity", unit) == unit


def test_a_table_repeats_no_entry_of_the_one_below_it():
    for upper, lower in ((LOG, DATASET), (BATCH, LOG)):
        assert set(lower) < set(upper)
    assert BATCH["rod_angle"] == DATASET["rod_angle"] != LOG["rod_angle"]


def test_units_that_are_no_unit_are_explained():
    plain = {"1", "degree", "s", "radian", "time"}
    for quantities, notes in ((DATASET, NOTES), (LOG, LOG_NOTES | NOTES)):
        used = {part for unit, _ in quantities.values() for part in unit.replace("/", " ").split()}
        assert used <= plain | set(notes)
