"""The command `draw`, with right and with wrong input."""

import pytest

SCENE = "workflow/scenes/figure_03.yaml"


def test_draw(run, tmp_path):
    path = tmp_path / "scene.svg"
    code, out, _ = run("draw", SCENE, "--pusher-angle", "-20", "-o", str(path))
    assert (code, out) == (0, f"written: {path}\n")
    assert path.read_text(encoding="utf-8").lstrip().startswith("<?xml")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["draw", SCENE, "--pusher-angle", "nan", "-o", "scene.svg"],
         "pusher_angle: nan given; allowed: a finite number of degrees"),
        (["draw", SCENE, "--pusher-magnitude", "0", "-o", "scene.svg"],
         "pusher_magnitude: 0.0 given; allowed: a finite number > 0"),
        (["draw", SCENE, "-o", "/dev/null/scene.svg"],
         "/dev/null/scene.svg: cannot be written"),
        (["draw", SCENE, "-o", "scene.doc"],
         "output: 'scene.doc' given; allowed: a name ending in .svg"),
        (["draw", SCENE, "--pusher-angle", "1", "--force-angle", "2", "-o", "scene.svg"],
         "pusher_angle, force_angle: (1.0, 2.0) given; allowed: one of them"),
    ],
)  # fmt: skip
def test_wrong_input(refused, arguments, said):
    refused(arguments, said)
