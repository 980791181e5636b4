"""Scene files are read back as they were written; each mistake in one ends in one message."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import planar_pushing as pp
from planar_pushing import InvalidFile, load_scene
from planar_pushing.scenes.contacts_files import load_any_file, save_contacts_file
from planar_pushing.scenes.contacts_model import ContactsFile
from planar_pushing.scenes.files import load_scene_file, save_scene_file
from pulling_by_pushing.study.study_file import load_study

POSITIVE = st.floats(1e-6, 1e6)

LAWS = st.one_of(
    st.builds(pp.Coulomb, st.floats(0, 1e6)),
    st.builds(pp.InfiniteFriction, st.sampled_from(["free", "none"])),
    st.builds(pp.PerfectlyRough),
)

#: Lengths from a hundredth to a hundred, so that every ratio of two is in the domain.
LENGTH = st.floats(1e-2, 1e2)
EFFECTS = st.one_of(
    st.builds(pp.RingFriction, weight=POSITIVE),
    st.builds(pp.Inertia, mass=POSITIVE, gyration_radius=LENGTH),
)

SLIDERS = st.builds(
    pp.Slider,
    rod_length=st.floats(0, 1e4),
    rod_angle=st.floats(0.5, 179.5).map(np.deg2rad),
    radius=LENGTH,
)

SCENES = sorted(Path("workflow/scenes").glob("*.yaml"))

SCENE = """\
title: A scene
slider: {rod_length: 5, rod_angle: 45, radius: 1}
contact: {law: coulomb, friction_coefficient: 2}
effects:
  - {type: ring_friction, weight: 1}
  - {type: inertia, mass: 1, gyration_radius: 1}
"""


@pytest.mark.filterwarnings("ignore::planar_pushing.SceneWarning")  # of random numbers
@given(SLIDERS, LAWS, st.lists(EFFECTS, min_size=1, max_size=3))
def test_scene_round_trip(tmp_path_factory, slider, law, effects):
    scene = pp.Scene(slider=slider, contact=law, effects=tuple(effects))
    path = tmp_path_factory.mktemp("scene") / "scene.yaml"
    pp.save_scene(scene, path, title="Round trip")
    assert pp.load_scene(path) == scene
    assert load_scene_file(path).title == "Round trip"


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_file_round_trip(tmp_path, path):
    file = load_any_file(path)
    save = save_contacts_file if isinstance(file, ContactsFile) else save_scene_file
    save(file, tmp_path / "scene.yaml")
    assert load_any_file(tmp_path / "scene.yaml") == file


def test_saved_angle_is_short(tmp_path):
    slider = pp.Slider(rod_length=2, rod_angle=np.deg2rad(35))
    scene = pp.Scene(slider=slider, contact=pp.PerfectlyRough(), effects=(pp.Inertia(),))
    pp.save_scene(scene, tmp_path / "scene.yaml")
    assert "rod_angle: 35.0" in (tmp_path / "scene.yaml").read_text()


@pytest.mark.parametrize("side", [(-0.5, 2.0), (-np.inf, 2.0), (-0.25, np.inf)], ids=str)
def test_a_side_comes_back(tmp_path, side):
    slider = pp.Slider(rod_length=2, rod_angle=1.0, radius=1.0, side=side)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=(pp.Inertia(),))
    pp.save_scene(scene, tmp_path / "scene.yaml")
    assert load_scene(tmp_path / "scene.yaml").slider.side == side


def test_a_side_without_an_end_is_not_written(tmp_path):
    slider = pp.Slider(rod_length=2, rod_angle=1.0)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.5), effects=(pp.Inertia(),))
    pp.save_scene(scene, tmp_path / "scene.yaml")
    assert "side" not in (tmp_path / "scene.yaml").read_text()


@pytest.mark.parametrize("side", ["[0.5, 1]", "[-1, .nan]", "[-1, far]", "[-1]", "3"])
def test_a_side_that_does_not_hold_the_contact(tmp_path, side):
    said = message(tmp_path, SCENE.replace("radius: 1", f"radius: 1, side: {side}", 1))
    assert said.startswith("slider.side: ")
    assert said.endswith("which is between them, the one toward -x first")


def message(tmp_path, text):
    path = tmp_path / "file.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InvalidFile) as caught:
        load_scene(path)
    assert str(caught.value).startswith(f"{path}: ")
    return str(caught.value).removeprefix(f"{path}: ")


@pytest.mark.parametrize(
    ("written", "instead", "said"),
    [
        ("friction_coefficient: 2", "friction_coefficient: inf",
         "contact.friction_coefficient: 'inf' given; allowed: a number in [0, 1e+09]; use the law of "
         "infinite friction where no coefficient is large enough"),
        ("mass: 1", "mass: heavy",
         "effects[1].mass: 'heavy' given; allowed: a finite number > 0; leave the effect out of the scene "
         "if the slider has no inertia"),
        ("rod_angle: 45", "rod_angle: 180",
         "slider.rod_angle: 180 given; allowed: degrees in the open interval (0, 180); "
         "keep the slider above the fence"),
        ("rod_length", "rod_lenght",
         "slider.rod_lenght: 5 given; allowed: the keys rod_length, rod_angle, radius, side, flush, "
         "outline; did you mean rod_length?"),
        ("title", "color",
         "color: 'A scene' given; allowed: the keys title, slider, contact, effects, simulate, "
         "placement, units; remove the key"),
        ("rod_length: 5, ", "",
         "slider.rod_length: missing; allowed: a value for this key; add it"),
        ("law: coulomb", "law: coulom",
         "contact.law: 'coulom' given; allowed: 'coulomb', 'infinite_friction', 'perfectly_rough'; "
         "did you mean coulomb?"),
        ("law: coulomb, ", "",
         "contact: {'friction_coefficient': 2} given; allowed: a mapping with the key 'law'; "
         "change the value"),
        ("slider: {rod_length: 5, rod_angle: 45, radius: 1}", "slider: 5",
         "slider: 5 given; allowed: a mapping with the keys rod_length, rod_angle, radius, side, flush, "
         "outline; change the value"),
        ("contact: {law: coulomb, friction_coefficient: 2}", "contact: rough",
         "contact: 'rough' given; allowed: a mapping; change the value"),
        ("title: A scene", "title: 3", "title: 3 given; allowed: text; change the value"),
        ("weight: 1", "weight: " + 400 * "1",
         f"effects[0].weight: {117 * '1'}... given; allowed: a finite number > 0; leave the effect "
         "out of the scene if the support is frictionless"),
        ("title: A scene", r'title: "a\0b"',
         "title: 'a\\x00b' given; allowed: text without control characters; change the value"),
        ("radius: 1}\ncontact", "radius: 1, radius: 2}\ncontact",
         "not YAML: line 2, column 51: found duplicate key \"radius\" with value \"2\" "
         "(original value: \"1\"); correct the line"),
        ("title: A scene", "title: [",
         "not YAML: line 3, column 1: expected ',' or ']', but got '<scalar>'; correct the line"),
    ],
)  # fmt: skip
def test_scene_error(tmp_path, written, instead, said):
    assert written in SCENE
    assert message(tmp_path, SCENE.replace(written, instead, 1)) == said


def test_empty_effects(tmp_path):
    text = SCENE[: SCENE.index("effects:")] + "effects: []\n"
    said = "effects: [] given; allowed: a list with at least one entry; change the value"
    assert message(tmp_path, text) == said


@pytest.mark.parametrize("text", ["", "[]", "3"])
def test_no_keys(tmp_path, text):
    keys = "title, slider, contact, effects, simulate, placement, units"
    assert message(tmp_path, text) == f"holds no keys; allowed: {keys}; write them as key: value"


def test_missing_file(tmp_path):
    with pytest.raises(InvalidFile, match="no such file; give the path of a YAML file"):
        load_scene(tmp_path / "none.yaml")


def test_unreadable_file(tmp_path):
    with pytest.raises(InvalidFile, match=r"cannot be read \(Is a directory\); give a YAML"):
        load_scene(tmp_path)


@pytest.mark.parametrize(("load", "file", "kind"), [
    (load_scene, "workflow/config/smoke.yaml", "study file"),
    (load_scene, "workflow/config/sliders_smoke.yaml", "study file"),
    (load_study, "workflow/scenes/figure_03.yaml", "scene file"),
])  # fmt: skip
def test_a_file_of_another_kind_is_named(load, file, kind):
    with pytest.raises(InvalidFile, match=f"; this is a {kind}; give a file with these keys"):
        load(file)


def test_not_text(tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InvalidFile, match="is not text in UTF-8; give a YAML text file"):
        load_scene(path)


@pytest.mark.parametrize(("name", "given"), [
    ("title", 5), ("title", None), ("title", b"pull"), ("path", 5), ("path", None), ("path", "a\0b"),
    ("scene", "scene.yaml"), ("scene", "array"),
], ids=str)  # fmt: skip
def test_what_cannot_be_saved_is_refused_and_nothing_written(tmp_path, name, given):
    slider = pp.Slider(rod_length=np.array([1.0, 2.0]) if given == "array" else 2.0, rod_angle=1.0)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(pp.Inertia(),))
    values = {"scene": scene, "path": tmp_path / "scene.yaml", "title": "pull"}
    values |= {} if given == "array" else {name: given}
    with pytest.raises(pp.InvalidValue) as caught:
        pp.save_scene(**values)
    assert caught.value.name == name
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("given", [5, None, b"scene.yaml"])
def test_a_scene_is_loaded_from_a_path(given):
    with pytest.raises(pp.InvalidValue, match=r"path: .* given; allowed: the path of a file"):
        load_scene(given)
