"""Golden datasets: names, dimensions, units, radii, and independence from the mechanics."""

import math
import subprocess
import sys

import numpy as np
import pytest

from planar_pushing.certified.contact import modes
from planar_pushing.evidence.golden.build import generate

EFFECTS = ["support_friction", "inertia", "support_friction+inertia"]
CONTACTS = {
    "coulomb_1.4": ("coulomb", modes.coulomb(1.4)),
    "infinite_friction_free": ("infinite_friction", modes.INFINITE_FREE),
    "infinite_friction_none": ("infinite_friction", modes.INFINITE_NONE),
    "perfectly_rough": ("perfectly_rough", modes.PERFECTLY_ROUGH),
}


def build_limit_curves(processes=1):
    grid = {
        "effects": EFFECTS,
        "rod_length": [0, 2],
        "rod_angle": [45, 90],
        "force_angle": [0, 45, 181],
    }
    return generate.limit_curves(grid, processes=processes)


def build_motion_cones():
    axes = {"rod_length": [0, 2], "rod_angle": [45, 90], "friction_coefficient": [0, 1.5, math.inf]}
    return generate.motion_cones({"effects": EFFECTS, **axes})


def build_contact_modes():
    axes = {
        "rod_length": [0, 2],
        "pusher_magnitude": [1, 1.42],
        "pusher_angle": [-180, -1, 0, 90, 165],
    }
    return generate.contact_modes({"effects": EFFECTS, **axes}, CONTACTS)


def build_acceleration_centers():
    return generate.acceleration_centers(
        {"rod_length": [0, 5], "force_angle": [0, 45, 90], "inertia_share": [0, 0.5, 1]}
    )


BUILDERS = [build_limit_curves, build_motion_cones, build_contact_modes, build_acceleration_centers]


@pytest.mark.parametrize("builder", BUILDERS)
def test_every_number_has_a_unit_and_a_rigorous_radius(builder):
    dataset = builder()
    names = [n for n in dataset.data_vars if not n.endswith(("_low", "_radius"))]
    assert all("units" in variable.attrs for variable in dataset.variables.values())
    for name in names:
        values = dataset[name]
        if values.dtype.kind in "bi":
            assert f"{name}_radius" not in dataset
            continue
        radius, low = dataset[f"{name}_radius"], dataset[f"{name}_low"]
        if "mode" not in values.dims:  # a mode without a solution has no values
            assert not values.isnull().any()
        finite = np.isfinite(values)
        assert (radius.where(finite, 0) <= 1e-25 * abs(values.where(finite, 0))).all()
        assert (abs(low) <= np.spacing(abs(values.where(finite, 1)))).all()
        assert radius.attrs["units"] == values.attrs["units"]
    assert {"method", "precision_bits", "python_flint", "flint"} <= set(dataset.attrs)


def test_dimensions_and_names():
    curves = build_limit_curves()
    assert curves.force.dims == ("effects", "rod_length", "rod_angle", "force_angle")
    assert {"force", "force_x", "force_y", "spin_ratio", "motion_angle"} <= set(curves)
    cones = build_motion_cones()
    assert cones.pulls.dims == ("effects", "rod_length", "rod_angle", "friction_coefficient")
    assert cones.pulls.dtype == bool
    found = build_contact_modes()
    dims = ("effects", "contact", "rod_length", "pusher_magnitude", "pusher_angle")
    assert found.outcome.dims == dims
    assert found.consistent.dims == (*dims, "mode")
    assert list(found.law.values) == [
        "coulomb",
        "infinite_friction",
        "infinite_friction",
        "perfectly_rough",
    ]
    *finite, rough = found.friction_coefficient.values
    assert finite == [1.4, math.inf, math.inf]
    assert math.isnan(rough)
    centers = build_acceleration_centers()
    assert centers.center_x.dims == ("rod_length", "force_angle", "inertia_share")
    assert centers.exact_cone_left.dims == ("rod_length",)


def test_slowest_and_fastest_slip():
    point = {"effects": "support_friction+inertia", "contact": "coulomb_1.4", "rod_length": 2}
    found = build_contact_modes().sel(
        **point, pusher_magnitude=1.42, pusher_angle=-1, mode="SLIP_LEFT"
    )
    assert found.consistent == 2
    assert found.outcome == 2
    assert found.spin_ratio > found.spin_ratio_fast > 0
    assert found.force_angle == found.force_angle_fast


def test_modes_without_a_solution_have_no_values():
    found = build_contact_modes()
    empty = found.consistent == 0
    for name in ("spin_ratio", "force_angle", "spin_ratio_fast", "force_angle_fast"):
        assert (found[name].isnull() == empty).all()
        rest = found[name].sel(mode="SEPARATE")
        assert (rest.where(~empty.sel(mode="SEPARATE"), 0) == 0).all()


def test_the_bound_is_that_of_the_cases():
    grid = {"rod_length": [1.0, 2.0], "rod_angle": [45.0], "force_angle": [0.0, 15.0, 45.0, 180.0]}
    found = generate.center_regions(grid).sel(rod_length=2, rod_angle=45)
    ring = math.sqrt(2)
    misses, touches, translates = (found.sel(force_angle=angle) for angle in (0, 15, 45))
    np.testing.assert_allclose(misses.bound_y, [ring, ring + 1], rtol=1e-15)
    assert (touches.bound_x.diff("bound_end") == 0).all()
    assert np.isinf(translates.bound_x).all()
    assert (abs(misses.exact_x - ring) < 1e-15).all()
    assert ((ring < misses.exact_y) & (misses.exact_y < ring + 1)).all()


def test_translations_have_their_centre_at_infinity():
    centers = build_acceleration_centers().sel(rod_length=5, force_angle=45)
    assert (centers.center_x == -math.inf).all()
    assert (centers.center_y == math.inf).all()


def test_workers_compute_the_same():
    assert build_limit_curves().identical(build_limit_curves(processes=2))


def test_golden_numbers_share_no_code_with_the_mechanics():
    code = (
        "import sys, planar_pushing.evidence.golden.build.jobs\n"
        "print([m for m in sys.modules if m.startswith('planar_pushing.mechanics')])"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "[]"
