"""Every hard case meets its accuracy: 4 ulp, and 4 for each ulp that rounding its inputs costs.

What is harder than the domain allows is refused.
"""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.figure import Figure
from mpmath import mp, mpf

import reference as straight
from planar_pushing.evidence.hard_cases.case import DIGITS, measure
from planar_pushing.evidence.hard_cases.dataset import build
from planar_pushing.evidence.hard_cases.places import contact, lengths, painleve, rest, ring, shares
from planar_pushing.evidence.hard_cases.scenes import make_scene
from planar_pushing.figures.evidence import hard_cases
from planar_pushing.mechanics.solve import solve
from planar_pushing.study.figures import OURS
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.quantities import DATASET as VARIABLES

FAMILIES = {"ring": ring, "lengths": lengths, "contact": contact, "shares": shares, "rest": rest,
            "painleve": painleve}  # fmt: skip


@pytest.fixture(scope="module")
def measures():
    return {
        name: [(case, measure(case)) for case in each.cases()] for name, each in FAMILIES.items()
    }


@pytest.mark.parametrize("name", FAMILIES)
def test_accuracy(measures, name):
    for case, found in measures[name]:
        assert np.isfinite(found.result), case.label
        assert found.error_ulp <= 4 * (1 + found.condition), case.label


@pytest.mark.parametrize("name", FAMILIES)
def test_references_have_their_digits(measures, name):
    with mp.workdps(60):
        for case, found in measures[name]:
            stored = mpf(found.reference_high) + mpf(found.reference_low)
            assert abs(mpf(found.reference) - stored) <= abs(stored) * mpf(10) ** -30 + mpf(
                5e-324
            ), case.label
            digits = found.reference.split("e")[0].replace("-", "").replace(".", "").lstrip("0")
            assert len(digits) <= DIGITS


def recovered(case, stored):
    """1 where the printed integrals in mpmath agree; a spin ratio must give its arm back."""
    (x,) = case.inputs
    if case.quantity == "spin_ratio":
        return straight.ring_torque(stored) / straight.ring_force(stored) / x
    exact = straight.ring_force if case.quantity == "force" else straight.ring_torque
    return stored / exact(x)


def test_references_agree_with_the_printed_integrals():
    with mp.workdps(50):
        for case in ring.cases():
            assert abs(recovered(case, mpf(measure(case).reference)) - 1) < 1e-25, case.label


def test_every_line_has_cases_and_every_label_is_its_own(measures):
    cases = [case for each in measures.values() for case, _ in each]
    assert {case.line for case in cases} == set(range(1, 8))
    assert len({case.label for case in cases}) == len(cases)


def test_ill_conditioned_cases_say_so(measures):
    """Along the rod of a long slider, and where two Painleve slips meet, the digits are not there."""
    ill = {name: [m for _, m in each if m.ill_conditioned] for name, each in measures.items()}
    assert {name for name, each in ill.items() if each} == {"lengths", "painleve"}
    for each in ill["painleve"]:
        assert each.error_ulp > 1e5
        assert (
            each.error_ulp * np.spacing(each.reference_high) <= each.bound * each.reference_high * 4
        )


PSI = np.pi / 4
REFUSED = [
    *[("friction_coefficient", mu, "[0, 1e+09]", {"mu": mu}) for mu in (1e16, 1e300)],
    *[("rod_length", rod, "at most 1e+06 times the radius", {"length": rod}) for rod in (1e8, 1e50)],
    *[("gyration_radius", rho, "0.0001 to 10000 times the slider's radius", {"rho": rho, "share": 1.0})
      for rho in (1e-300, 1e-8, 1e8, 1e300)],
    *[("pusher_magnitude", a, "m a / W in [1e-12, 1e+12]", {"magnitude": a})
      for a in (1e-300, 1e-100, 1e-16, 1e16, 1e100, 1e300)],
]  # fmt: skip


@pytest.mark.parametrize(("name", "given", "allowed", "changed"), REFUSED)
def test_a_value_outside_the_domain_is_refused(name, given, allowed, changed):
    changed = {"length": 2.0, "magnitude": 1.0} | changed
    length, magnitude = changed.pop("length"), changed.pop("magnitude")
    with pytest.raises(InvalidValue) as caught:
        solve(make_scene(length, PSI, **changed), 1.0, magnitude)
    assert caught.value.name == name
    assert float(caught.value.given) == given
    assert allowed in caught.value.allowed
    assert str(caught.value).startswith(f"{name}: ")


def test_dataset_is_described():
    data = build()
    assert set(data.variables) <= set(VARIABLES)
    assert all({"units", "long_name"} <= set(each.attrs) for each in data.variables.values())
    assert data.line.values.tolist() == sorted(data.line.values)


def test_figure_shows_every_case():
    data, figure = build(), Figure(figsize=OURS["hard_cases"].size)
    hard_cases.draw(figure, data)
    (ax,) = figure.axes
    strokes, fine, ill = (line.get_xdata().size for line in ax.lines[:3])
    assert strokes == fine + ill == data.sizes["case"]
    assert ill == int(data.ill_conditioned.sum())
    assert [tick.get_text() for tick in ax.get_xticklabels()] == list(hard_cases.PLACES)
