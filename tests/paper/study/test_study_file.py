"""Each mistake in a study file ends in one message: file, key, value, allowed, remedy."""

import pytest

from planar_pushing import InvalidFile
from pulling_by_pushing.study.study_file import load_study

AXIS = (
    "a list of increasing numbers, or {start, stop, step} with a step > 0 that divides the range, "
    "or a list that holds such ranges"
)


def message(tmp_path, text):
    path = tmp_path / "config/file.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InvalidFile) as caught:
        load_study(path)
    assert str(caught.value).startswith(f"{path}: ")
    told = str(caught.value).removeprefix(f"{path}: ")
    return told.replace(f"{tmp_path / 'config'}/", "").replace(f"{tmp_path}/", "../")


@pytest.mark.parametrize(
    ("written", "instead", "said"),
    [
        ("rod_length: [0, 1, 2, 5]", "rod_length: []",
         f"grid.rod_length: [] given; allowed: {AXIS}, and at least one number; change the value"),
        ("rod_length: [0, 1, 2, 5]", "rod_length: 3",
         f"grid.rod_length: 3 given; allowed: {AXIS}; change the value"),
        ("rod_length: [0, 1, 2, 5]", "rod_length: [0, 2, 1]",
         f"grid.rod_length: [0, 2, 1] given; allowed: {AXIS}; change the value"),
        ("rod_length: [0, 1, 2, 5]", "rod_length: [0, one]",
         "grid.rod_length[1]: 'one' given; allowed: a finite number >= 0; change the value"),
        ("force_angle: {start: 0, stop: 360, step: 15}", "force_angle: {start: 0, stop: 360, step: 0}",
         f"grid.force_angle: {{'start': 0, 'stop': 360, 'step': 0}} given; allowed: {AXIS}, "
         "and at least one number; change the value"),
        ("force_angle: {start: 0, stop: 360, step: 15}", "force_angle: {start: 0, stop: 360, step: 7}",
         f"grid.force_angle: {{'start': 0, 'stop': 360, 'step': 7}} given; allowed: {AXIS}, "
         "and at least one number; change the value"),
        ("force_angle: {start: 0, stop: 360, step: 15}", "force_angle: {start: 0, stop: 360}",
         f"grid.force_angle: {{'start': 0, 'stop': 360}} given; allowed: {AXIS}; change the value"),
        ("[0, 1.5, 2, inf]", "[-1, 2, inf]",
         "grid.friction_coefficient[0]: -1 given; allowed: a number >= 0, or inf; change the value"),
        ("rod_angle: [45, 90]", "rod_angle: [0, 90]",
         "grid.rod_angle[0]: 0 given; allowed: degrees in the open interval (0, 180); "
         "keep the slider above the fence"),
        ("inertia: {mass: 1, gyration_radius: 1}", "inertia: {mass: 1, gyration_radius: 2}",
         "inertia.gyration_radius: 2.0 given; allowed: the radius of the ring, 1.0, "
         "which the paper's bound assumes; change it"),
        ("grid:\n", "golden: nowhere\ngrid:\n",
         "golden: 'nowhere' given; allowed: a folder of golden data; leave the key out"),
        ("inertia: {mass: 1, gyration_radius: 1}\n", "",
         "grid.effects: 'inertia' given; allowed: effects that the study has parameters for; "
         "add the key inertia, or remove the entry"),
        ("../scenes/figure_03.yaml, force_angle: 36", "nowhere.yaml, force_angle: 36",
         "scenes.figure_03.file: nowhere.yaml: no such file; give the path of a YAML file"),
        ("../scenes/figure_03.yaml, force_angle: 36", "../scenes/box_side.yaml, pusher_angle: 36",
         "scenes.figure_03.file: ../scenes/box_side.yaml has a side on the fence; allowed: contacts at one "
         "point; name another scene, or list this one under simulations"),
        ("force_angle: 54", "force_angle: 54, pusher_angle: 3",
         "scenes.figure_02: {'file': '../scenes/figure_02.yaml', 'force_angle': 54, "
         "'pusher_angle': 3} given; allowed: exactly one of pusher_angle and force_angle; "
         "change the value"),
        ("../scenes/figure_02.yaml", "none.yaml",
         "scenes.figure_02.file: none.yaml: no such file; give the path of a YAML file"),
        ("effects: [support_friction, inertia, support_friction+inertia]", "effects: []",
         "grid.effects: [] given; allowed: a list with at least one entry; change the value"),
        ("effects: [support_friction, inertia", "effects: [friction, inertia",
         "grid.effects[0]: 'friction' given; allowed: 'support_friction', 'inertia' or "
         "'support_friction+inertia'; did you mean support_friction?"),
        ("slipping: ../scenes/slipping", "slipping: nowhere",
         "simulations.slipping: nowhere.yaml: no such file; give the path of a YAML file"),
        ("slipping: ../scenes/slipping", "slipping: ../scenes/figure_08",
         "simulations.slipping: ../scenes/figure_08.yaml given; allowed: scene files with the "
         "section simulate; add it to the file"),
        ("  slipping: .", "  a/b: .",
         "simulations.a/b.[key]: 'a/b' given; allowed: a name of letters, digits and underscores, "
         "which becomes a file's name; change the value"),
        ("figures:\n", "chunks: {cones: {rod_length: 3}}\nfigures:\n",
         "chunks.cones: unknown, or not computed; allowed: limit_curves, curves, motion_cones, "
         "contact_modes, mode_maps, acceleration_centers, center_regions; remove it"),
        ("figures:\n", "chunks: {motion_cones: {mode: 3}}\nfigures:\n",
         "chunks.motion_cones: ['mode'] given; allowed: effects, rod_length, rod_angle, "
         "friction_coefficient; name some of these"),
        ("figures:\n", "chunks: {motion_cones: {}}\nfigures:\n",
         "chunks.motion_cones: [] given; allowed: effects, rod_length, rod_angle, "
         "friction_coefficient; name some of these"),
        ("figures:\n", "chunks: {motion_cones: {rod_length: 0.5}}\nfigures:\n",
         "chunks.motion_cones.rod_length: 0.5 given; allowed: an integer >= 1; change the value"),
        ("figures:\n", "gather: {motion_cones: false}\nfigures:\n",
         "gather.motion_cones: unknown; allowed: none, as there are no chunks; remove it, or give its "
         "chunks"),
        ("figures:\n", "chunks: {motion_cones: {rod_length: 2}}\ngather: {motion_cones: 3}\nfigures:\n",
         "gather.motion_cones: 3 given; allowed: true or false; change the value"),
    ],
)  # fmt: skip
def test_study_error(tmp_path, study_text, written, instead, said):
    assert written in study_text
    assert message(tmp_path, study_text.replace(written, instead, 1)) == said


def test_many_errors_are_cut_short(tmp_path, study_text):
    said = message(tmp_path, study_text.replace("[0, 1, 2, 5]", "[a, b, c, d, e, f, g]", 1))
    assert said.count("\n") == 5
    assert said.endswith("and 2 more")
