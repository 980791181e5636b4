"""Units and long names: one table, with an entry of its own where a log means something else."""

from planar_pushing.terms.quantities import (
    BATCH,
    COMPONENT_UNITS,
    DATASET,
    LOG,
    LOG_NOTES,
    LOG_TWIST_UNITS,
    MECHANICS,
    NOTES,
    SLIDERS,
    TWIST_UNITS,
    attributes,
    unit_of,
)


def test_an_entry_has_a_unit_and_a_long_name():
    assert attributes(DATASET, "rod_angle") == {"units": "degree", "long_name": "rod angle"}
    assert unit_of(attributes(LOG, "work")) == "force length"


def test_units_are_those_of_udunits():
    plain = {"1", "degree", "radian", "radian-1", "s"}
    for quantities in (DATASET, LOG, BATCH, MECHANICS):
        for name, (unit, _) in quantities.items():
            found = attributes(quantities, name)
            assert unit_of(found) == unit
            if unit not in COMPONENT_UNITS:
                assert found["units"] in plain, name
                assert found.get("quantity", unit) == unit


def test_a_variable_with_several_units_claims_none_of_them():
    for quantities in (DATASET, LOG, BATCH, MECHANICS, SLIDERS):
        found = attributes(quantities, "twist")
        assert found == {"component_units": "twist_unit", "long_name": quantities["twist"][1]}
        assert "twist_unit" in quantities
    assert attributes(SLIDERS, "ellipsoid")["component_units"] == "twist_unit/wrench_unit"


def test_a_table_repeats_no_entry_of_the_one_below_it():
    for upper, lower in ((LOG, DATASET), (BATCH, LOG)):
        assert set(lower) < set(upper)
    assert BATCH["rod_angle"] == DATASET["rod_angle"] != LOG["rod_angle"]


def test_units_that_are_no_unit_are_explained():
    plain = {"1", "degree", "s", "radian", "time"}
    for quantities, notes in ((DATASET, NOTES), (LOG, LOG_NOTES | NOTES)):
        units = {unit for unit, _ in quantities.values()} - set(COMPONENT_UNITS)
        units |= set(TWIST_UNITS if notes is NOTES else LOG_TWIST_UNITS)
        used = {part for unit in units for part in unit.replace("/", " ").split()}
        assert used <= plain | set(notes)
