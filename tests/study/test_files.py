"""Scene files are read back as they were written, and files are replaced whole or not at all."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import planar_pushing as pp
from planar_pushing.study.files import load_scene_file
from planar_pushing.study.replacing import replacing
from planar_pushing.study.schemas import SCHEMAS, schema_text
from planar_pushing.study.study_file import load_study

POSITIVE = st.floats(1e-6, 1e6)
LAWS = st.one_of(
    st.builds(pp.Coulomb, st.floats(0, 1e6)),
    st.builds(pp.InfiniteFriction, st.sampled_from(["free", "none"])),
    st.builds(pp.PerfectlyRough),
)
EFFECTS = st.one_of(
    st.builds(pp.RingFriction, weight=POSITIVE),
    st.builds(pp.Inertia, mass=POSITIVE, gyration_radius=POSITIVE),
)
SLIDERS = st.builds(
    pp.Slider,
    rod_length=st.floats(0, 1e6),
    rod_angle=st.floats(0.5, 179.5).map(np.deg2rad),
    radius=POSITIVE,
)


@given(SLIDERS, LAWS, st.lists(EFFECTS, min_size=1, max_size=3))
def test_scene_round_trip(tmp_path_factory, slider, law, effects):
    scene = pp.Scene(slider=slider, contact=law, effects=tuple(effects))
    path = tmp_path_factory.mktemp("scene") / "scene.yaml"
    pp.save_scene(scene, path, title="Round trip")
    assert pp.load_scene(path) == scene
    assert load_scene_file(path).title == "Round trip"


def test_saved_angle_is_short(tmp_path):
    slider = pp.Slider(rod_length=2, rod_angle=np.deg2rad(35))
    scene = pp.Scene(slider=slider, contact=pp.PerfectlyRough(), effects=(pp.Inertia(),))
    pp.save_scene(scene, tmp_path / "scene.yaml")
    assert "rod_angle: 35.0" in (tmp_path / "scene.yaml").read_text()


def test_paper_study_holds_the_grid_of_the_paper():
    grid = load_study("workflow/config/paper.yaml").grid
    assert {0, 0.25, 0.5, 1, 2, 3, 5, 10} <= set(grid.rod_length)
    assert {15, 45, 90, 165} <= set(grid.rod_angle)
    assert {0, 0.25, 0.5, 1, 1.5, 2, 5, 10, 100, np.inf} <= set(grid.friction_coefficient)
    assert np.diff(grid.force_angle).max() <= 1
    assert np.diff(grid.pusher_angle).max() <= 1
    assert (grid.inertia_share[0], grid.inertia_share[-1]) == (0, 1)


def test_ranges_are_free_of_accumulated_rounding():
    shares = load_study("workflow/config/paper.yaml").grid.inertia_share
    assert shares == tuple(i / 20 for i in range(21))


@pytest.mark.parametrize("name", SCHEMAS)
def test_schema_is_that_of_the_model(name):
    stored = Path(f"workflow/schemas/{name}.schema.json").read_text(encoding="utf-8")
    assert stored == schema_text(name), "run make schemas"
    json.loads(stored)


def test_replacing_keeps_the_old_file_when_the_work_fails(tmp_path):
    path = tmp_path / "file.txt"
    path.write_text("old")

    def work():
        with replacing(path) as temporary:
            temporary.write_text("ne")
            raise RuntimeError("half way")

    with pytest.raises(RuntimeError, match="half way"):
        work()
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]
