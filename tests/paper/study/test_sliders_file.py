"""Each mistake in a study file with supports ends in one message: file, key, value, allowed, remedy."""

from pathlib import Path

import pytest

from planar_pushing import InvalidFile
from pulling_by_pushing.study.study_file import load_study

TEXT = Path("workflow/config/sliders_smoke.yaml").read_text(encoding="utf-8")
TEXT = TEXT.replace("../scenes", str(Path("workflow/scenes").resolve()))
BOX = "vertices: [[-0.8, -0.6], [0.8, -0.6], [0.8, 0.6], [-0.8, 0.6]]"


def test_paths_are_relative_to_the_file():
    found = load_study("workflow/config/sliders_smoke.yaml")
    assert found.simulations == {"tripod": "workflow/scenes/tripod.yaml"}


@pytest.mark.parametrize(
    ("written", "instead", "said"),
    [
        ("shape: ring", "shape: rings",
         "supports.ring.shape: 'rings' given; allowed: 'ring', 'points', 'segment', 'disc', 'annulus', "
         "'polygon', 'pressure_map', 'composite', 'rectangle', 'regular_polygon'; did you mean ring?"),
        (BOX, "vertices: [[0, 0], [1, 0]]",
         "supports.box.vertices: ((0.0, 0.0), (1.0, 0.0)) given; allowed: at least three vertices; "),
        ("weights: [1, 1, 1]", "weights: [1, 1]",
         "supports.tripod.weights: (1.0, 1.0) given; allowed: 3 weights; "),
        ("weights: [1, 1, 1]", "weights: [1, 1, heavy]", "supports.tripod.weights[2]: 'heavy' given; "),
        ("{shape: ring, radius: 1}", "{shape: points, positions: [[1, 0]], weights: [1]}",
         "supports.ring: {'shape': 'points', 'positions': [[1, 0]], 'weights': [1]} given; allowed: a "
         "support with more than one point, since a single point resists no rotation; change the value"),
        ("{shape: ring, radius: 1}",
         "{shape: points, positions: [[0.1, 0.2], [0.1, 0.2], [0.1, 0.2]], weights: [0.3, 0.3, 0.1]}",
         "supports.ring: {'shape': 'points', 'positions': [[0.1, 0.2], [0.1, 0.2], [0.1, 0.2]], 'weights': "
         "[0.3, 0.3, 0.1]} given; allowed: a support with more than one point, since a single "
         "point resists no rotation; change the value"),
        ("{shape: ring, radius: 1}", "{shape: ring, radius: 0.000001}",
         "grid.rod_length: 2.0 given; allowed: at most 1e+06 times the extent of supports.ring, 1e-06; "
         "shorten the rod"),
        ("  ring: {", "  a ring: {",
         "supports.a ring: 'a ring' given; allowed: a name of letters, digits and underscores, "
         "which becomes a file's name; change the value"),
        ("center_x: [-1, 0, 1]", "center_x: [1, 0]",
         "grid.center_x: [1, 0] given; allowed: a list of increasing numbers, or {start, stop, step} with "
         "a step > 0 that divides the range, or a list that holds such ranges; change the value"),
        ("title:", "effects: [inertia]\ntitle:",
         "effects: ['inertia'] given; allowed: the keys slider, support_friction, inertia, supports, "
         "title, grid, scenes, model_errors, model_estimates, simulations, fine_grids, figures, chunks, "
         "gather, golden; remove the key"),
        ("  center_x", "  effects: [inertia]\n  center_x",
         "grid.effects: 'inertia' given; allowed: effects that the study has parameters for; add the key "
         "inertia, or remove the entry"),
        ("{rod_length: 2, rod_angle: 45}", "{rod_angle: 45}",
         "slider.rod_length: missing; allowed: a length > 0, for support_curves; add it"),
        ("tripod.yaml", "figure_08.yaml", "simulations.tripod: "),
        ("simulations:", "golden: nowhere\nsimulations:", "golden: "),
    ],
)  # fmt: skip
def test_study_error(tmp_path, written, instead, said):
    assert written in TEXT
    path = tmp_path / "file.yaml"
    path.write_text(TEXT.replace(written, instead, 1), encoding="utf-8")
    with pytest.raises(InvalidFile) as caught:
        load_study(path)
    assert str(caught.value).startswith(f"{path}: {said}")
    assert "\n" not in str(caught.value)


def test_a_study_without_a_support_is_refused(tmp_path):
    start, end = TEXT.index("supports:"), TEXT.index("# Angles")
    path = tmp_path / "file.yaml"
    path.write_text(TEXT[:start] + "supports: {}\n" + TEXT[end:], encoding="utf-8")
    with pytest.raises(InvalidFile, match="allowed: a mapping of at least one name to a support"):
        load_study(path)


def test_a_grid_of_more_points_than_a_memory_holds_is_refused(tmp_path):
    path = tmp_path / "file.yaml"
    fine = "{start: 0, stop: 9.9999, step: 0.0001}"
    text = TEXT.replace("[-1, 0, 1]", fine).replace("[0, 0.5]", fine)
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InvalidFile, match="points of supports given; allowed: 10000000000"):
        load_study(path)
