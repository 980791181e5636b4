"""The dataset of hard cases."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields

import numpy as np
import xarray as xr

from planar_pushing.evidence.hard_cases.case import (
    ILL_CONDITIONED,
    PRECISION,
    Case,
    Measure,
    measure,
)
from planar_pushing.evidence.hard_cases.places import contact, lengths, painleve, rest, ring, shares
from planar_pushing.study.describe import describe

FAMILIES = (ring, lengths, contact, shares, rest, painleve)


def cases() -> Iterator[Case]:
    """Every hard case, by line."""
    for family in FAMILIES:
        yield from family.cases()


def build() -> xr.Dataset:
    """Measure every case.

    Returns
    -------
    xarray.Dataset
        Over `case`: the reference, the result, its error and the condition number.
    """
    every = sorted(cases(), key=lambda case: case.line)
    found = [measure(case) for case in every]
    columns = {
        "line": np.array([case.line for case in every], np.int8),
        "quantity": [str(case.quantity) for case in every],
        "quantity_unit": [case.quantity.unit for case in every],
        **{field.name: [getattr(each, field.name) for each in found] for field in fields(Measure)},
        "error_bound": [each.bound for each in found],
        "ill_conditioned": np.array([each.ill_conditioned for each in found]),
    }
    dataset = xr.Dataset(
        {name: ("case", column) for name, column in columns.items()},
        coords={"case": [case.label for case in every]},
    )
    return describe(
        dataset,
        title="Hard cases: results in doubles against references of 40 digits",
        source="Eqs. (2)-(12)",
        parameters={"precision_bits": PRECISION, "ill_conditioned_from": ILL_CONDITIONED},
    )
