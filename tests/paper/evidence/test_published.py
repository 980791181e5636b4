"""The numbers on published pushes, from a folder of small logs in their formats."""

import json

import numpy as np
import pytest
from pushes.written import STRENGTH, TRIANGLE, feet, write_log, write_mat

import planar_pushing as pp
from planar_pushing.pushes.logs.measured import measurements_of
from pulling_by_pushing.evidence.published import _in_load_sets, _pivots, measure

#: Name of a log, which says where the feet are.
FOOTED = "10_130_10_10_10_130"


def test_wrenches_about_a_foot_are_in_its_load_set():
    """Exact pushes: where the object turns about a foot the wrench is in the set, elsewhere mostly not."""
    pushes = measurements_of(pp.simulate_pushes(feet(), TRIANGLE, 60, distance=1.0, seed=4))
    places = np.array([(10.0, 10.0), (130.0, 10.0), (10.0, 130.0)])
    near = _pivots(pushes, places) < 0.01
    within = _in_load_sets(pushes, places, np.full(3, 1 / 3), 5.0)
    assert near.any(axis=1).sum() >= 5
    assert within[near].all()
    assert within.mean() < 0.4
    # With a weight that is wrong by a factor most wrenches are outside.
    assert _in_load_sets(pushes, places, np.full(3, 1 / 3), 15.0).mean() < within.mean()


def test_pivots_are_distances_of_the_center_of_rotation():
    pushes = measurements_of(pp.simulate_pushes(feet(), TRIANGLE, 6, seed=1))
    places = np.array([(10.0, 10.0), (40.0, -20.0)])
    v_x, v_y, omega = pushes.twists.T
    centers = np.column_stack([-v_y / omega, v_x / omega])
    expected = np.linalg.norm(centers[:, None] - places, axis=2)
    assert _pivots(pushes, places) == pytest.approx(expected)


def test_a_folder_without_logs(tmp_path):
    with pytest.raises(pp.InvalidValue) as error:
        measure(tmp_path)
    assert str(error.value) == (
        f"data: '{tmp_path}' given; allowed: a folder with three_feet/*.txt or polygons/*.mat; "
        "give the folder of the published logs"
    )


@pytest.mark.slow
def test_the_numbers_of_a_folder(tmp_path):
    """Two logs with forces, one of the whole face, and one of poses alone, each on three feet or even."""
    random = np.random.default_rng(0)
    for name in ("three_feet", "polygons"):
        (tmp_path / name).mkdir()
    plate = (pp.SupportFriction(support=pp.Polygon(TRIANGLE), weight=5.0),)
    for name, effects in ((FOOTED, feet()), ("patch", plate)):
        pushes = pp.simulate_pushes(effects, TRIANGLE, 24, noise=(0.5, 0.3, 0.05), seed=4)
        write_log(tmp_path / "three_feet" / f"{name}.txt", pushes, random)
    square = pp.Polygon([(-45, -45), (45, -45), (45, 45), (-45, 45)])
    effects = (pp.SupportFriction(support=square),)
    pushes = pp.simulate_pushes(effects, square.vertices, 16, seed=1, finger_radius=4.75)
    write_mat(tmp_path / "polygons" / "abs_rect1.mat", pushes, random)
    found = measure(tmp_path, seed=2, splits=2)
    assert json.loads(json.dumps(found)) == found
    assert found["seed"] == 2
    assert found["command"] == "snakemake measured_pushes --config data=FOLDER"
    parts = {"three_feet", "patch", "polygons", "about_a_foot"}
    told = {"source", "command", "seed", "splits", "polygon_splits", "primary"}
    assert found.keys() == told | parts
    assert (found["splits"], found["polygon_splits"]) == (2, 1)
    for part, names in (
        ("three_feet", [FOOTED]),
        ("patch", ["patch"]),
    ):
        own = found[part]
        assert own["logs"].keys() == set(names)
        log = own["logs"][names[0]]
        assert log["pushes"] == own["pushes"]
        assert sum(share for _, _, share in log["support"]) == pytest.approx(1.0, abs=0.01)
        assert log["optimality"] < 0.1
    feet_log, patch = found["three_feet"]["logs"][FOOTED], found["patch"]["logs"]["patch"]
    true = np.array(feet_log["true_feet"])
    assert true == pytest.approx(np.array([(10, 10, 1 / 3), (130, 10, 1 / 3), (10, 130, 1 / 3)]))
    assert feet_log["true_spin_torque"] == pytest.approx(
        np.hypot([40, 80, 40], [40, 40, 80]).mean(), 1e-3
    )
    assert feet_log["spin_torque"] == pytest.approx(feet_log["true_spin_torque"], rel=0.05)
    assert patch["true_feet"] is None
    for log in (feet_log, patch):
        assert log["weight"] == pytest.approx(5.0 * STRENGTH, rel=0.05)
        assert log["center_of_pressure"] == pytest.approx([50, 50], abs=3)
        low, high = log["intervals"]["weight"]
        assert low < high
    assert found["polygons"]["objects"].keys() == {"abs_rect1"}
    for part in ("three_feet", "patch"):
        assert found[part]["comparison"].keys() == {"wrench", "motion", "pose"}
    motion = found["three_feet"]["comparison"]["motion"]
    assert (
        motion["known_feet"]["median"]
        < motion["identified"]["median"]
        < motion["uniform"]["median"]
    )
    assert motion["fitted_ellipsoid"]["ratio"] == 1.0
    against = found["three_feet"]["against"]
    assert against.keys() == {"fitted_ellipsoid", "fitted_quartic", "known_feet"}
    assert found["patch"]["against"].keys() == {"fitted_ellipsoid", "fitted_quartic"}
    to_ellipsoid = against["fitted_ellipsoid"]["motion"]
    for name in ("ratio", "ratio_interval", "ratio_90", "ratio_90_interval"):
        assert to_ellipsoid[name] == motion["identified"][name]
    for rows in against.values():
        assert rows.keys() == {"wrench", "motion", "pose"}
        for row in rows.values():
            assert row["smallest"] <= row["ratio"] <= row["largest"]
            low, high = row["ratio_interval"]
            assert low < high
            assert row["splits_below_one"] in (0.0, 0.5, 1.0)
    assert "known_feet" not in found["patch"]["comparison"]["motion"]
    polygons = found["polygons"]
    assert polygons["comparison"].keys() == polygons["with_corners"].keys() == {"pose"}
    # The one polygon is all polygons.
    assert polygons["objects"] == {"abs_rect1": polygons["comparison"]["pose"]}
    assert (polygons["pushes"], polygons["corner_pushes"], polygons["left_out"]) == (16, 0, 0)
    assert polygons["length"] == {"abs_rect1": 45.0}
    about = found["about_a_foot"]
    assert about["distance"] == 5.0
    assert about["in_load_set"] > 2 * about["of_random_pushes"]
