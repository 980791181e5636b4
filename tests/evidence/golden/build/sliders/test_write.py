"""Golden data of sliders: names, radii, what is decided, and the defining integrals on the second route."""

import numpy as np
import pytest

from planar_pushing.certified.supports.pressure import integrals, moments
from planar_pushing.evidence.golden.build import second
from planar_pushing.evidence.golden.build.enclosures import golden_variables
from planar_pushing.evidence.golden.build.sliders import write as sliders

STUDY = {
    "supports": {
        "disc": {"shape": "disc", "radius": 1.0, "center": (0.0, 0.0)},
        "box": {"shape": "polygon", "vertices": ((-1, -0.5), (1, -0.5), (1, 0.5), (-1, 0.5))},
        "tripod": {
            "shape": "points",
            "positions": ((1.0, 0.0), (-0.5, 0.9), (-0.5, -0.9)),
            "weights": (1.0, 1.0, 1.0),
        },
        "blade": {"shape": "segment", "start": (0.0, -1.0), "end": (0.0, 1.0)},
    },
    "grid": {
        "center_x": (-0.5, 0.25, 0.5),
        "center_y": (-1.5, 0.5),
        "rod_length": (0.5, 5.0),
        "rod_angle": (45.0, 90.0),
        "friction_coefficient": (0.25, float("inf")),
        "pusher_angle": (-180.0, -45.0, 0.0, 90.0, 135.0),
    },
}
BUILDERS = [sliders.supports, sliders.cones, sliders.modes]


@pytest.mark.parametrize("build", BUILDERS)
def test_every_number_has_a_unit_and_a_rigorous_radius(build):
    dataset = build(STUDY)
    assert all("units" in each.attrs for each in dataset.variables.values())
    for name in golden_variables(dataset):
        values = dataset[name].values
        if values.dtype.kind in "bi":
            assert f"{name}_radius" not in dataset
            continue
        radius, size = dataset[f"{name}_radius"].values, np.abs(values)
        known = ~np.isnan(values)
        assert ((radius <= 1e-25 * size) | ((size == 0) & (radius < 1e-39)))[known].all()
    assert {"method", "part", "precision_bits", "flint"} <= set(dataset.attrs)


def test_a_part_of_the_grid_is_kept():
    assert sliders.supports(STUDY).center_x.values.tolist() == [-0.5, 0.5]
    found = sliders.modes(STUDY)
    assert found.pusher_angle.values.tolist() == [-180, -45, 0, 90, 135]
    assert found.consistent.dims == (*sliders.ROD, "pusher_angle", "mode")


def test_modes_without_a_solution_have_no_values():
    found = sliders.modes(STUDY)
    for name in ("force_angle", "force_angle_end", "motion_angle", "spin"):
        np.testing.assert_array_equal(np.isnan(found[name]), ~found.consistent)
    assert (found.pivot.values[~found.consistent.values] == -1).all()


def test_a_pivot_leaves_an_interval_of_forces():
    """Across the rod the tripod turns about its first foot."""
    at = {"support": "tripod", "rod_length": 0.5, "rod_angle": 45, "pusher_angle": 135}
    found = sliders.modes(STUDY).sel(**at, friction_coefficient=np.inf, mode="STICK")
    assert found.pivot == 0
    assert found.force_angle != found.force_angle_end


def test_the_defining_integrals_overlap(monkeypatch):
    """The part that is thinned out, on both routes."""
    study = second.thinned(STUDY)
    first = [build(STUDY) for build in BUILDERS]
    monkeypatch.setattr(moments, "_route", integrals.printed)
    for build, whole in zip(BUILDERS, first, strict=True):
        found = second.agreement(STUDY, build(study), whole)
        assert not found.apart
        assert found.compared > 0
