"""The command `draw`, with right and with wrong input."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.drawing import draw
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.plane import direction
from planar_pushing.scenes.files import load_scene_file

SCENE = "workflow/scenes/figure_03.yaml"
BOTH = "workflow/scenes/figure_12.yaml"


def test_draw(run, tmp_path):
    path = tmp_path / "scene.svg"
    code, out, _ = run("draw", SCENE, "--pusher-angle", "-20", "-o", str(path))
    assert (code, out) == (0, f"written: {path}\n")
    assert path.read_text(encoding="utf-8").lstrip().startswith("<?xml")


def test_the_limit_curve_is_drawn_where_it_is_asked_for(run, tmp_path):
    sizes = []
    for more in ([], ["--limit-curve"]):
        path = tmp_path / f"scene{len(more)}.svg"
        assert run("draw", "workflow/scenes/stool.yaml", *more, "-o", str(path))[0] == 0
        sizes.append(path.stat().st_size)
    assert sizes[1] > sizes[0] + 1000


def test_a_side_on_the_fence_is_drawn_without_a_limit_curve(run, tmp_path):
    scene, path = "workflow/scenes/box_side.yaml", tmp_path / "side.svg"
    code, out, _ = run("draw", scene, "--pusher-angle", "120", "-o", str(path))
    assert (code, out) == (0, f"written: {path}\n")
    code, _, err = run("draw", scene, "--limit-curve", "-o", str(path))
    assert code == 2
    assert err.startswith(
        "planar-pushing draw: limit_curve: 'a side that lies on the fence' given; "
    )
    assert err.count("\n") == 1


@pytest.fixture
def sketched(run, tmp_path, monkeypatch):
    """The sketch that the command draws."""
    found = []
    monkeypatch.setattr(draw, "draw_on", lambda figure, sketch: found.append(sketch))

    def sketch(*arguments):
        assert run("draw", *arguments, "-o", str(tmp_path / "scene.svg"))[0] == 0
        return found[-1]

    return sketch


@pytest.mark.parametrize("angle", [27.0, 90.0, 153.0, 150.0 - 360.0, 90.0 + 7200.0, 90.0 - 7200.0])
def test_the_force_that_is_asked_for_is_drawn(sketched, angle):
    solution = sketched(SCENE, "--force-angle", str(angle)).solution
    assert solution.mode is ContactMode.STICK
    off = np.rad2deg(np.arctan2(*solution.force[::-1])) - angle
    assert (off + 180) % 360 == pytest.approx(180, abs=1e-9)


def test_the_push_is_that_of_the_file_unless_another_is_given(sketched):
    own = load_scene_file("workflow/scenes/slipping.yaml").simulate.pieces[0].angle
    for arguments, angle in (((), own), (("--pusher-angle", "70"), 70.0)):
        pusher = sketched("workflow/scenes/slipping.yaml", *arguments).pusher
        assert pusher == pytest.approx(direction(np.deg2rad(angle)))
    assert sketched(SCENE).pusher == pytest.approx([0.0, 1.0])


def test_a_finger_is_drawn_as_one(sketched, tmp_path):
    text = Path("workflow/scenes/slipping.yaml").read_text(encoding="utf-8")
    path = tmp_path / "finger.yaml"
    path.write_text(f"{text}  pusher_shape: finger\n", encoding="utf-8")
    assert sketched(str(path)).side == (-np.inf, np.inf)
    assert sketched(str(path)).finger_radius == 0
    assert sketched("workflow/scenes/slipping.yaml").side is None
    path.write_text(f"{text}  pusher_shape: finger\n  pusher_radius: 0.3\n", encoding="utf-8")
    assert sketched(str(path)).finger_radius == 0.3


def test_a_perfectly_rough_contact_transmits_every_force(run, tmp_path):
    scene = pp.load_scene(SCENE)
    path = tmp_path / "rough.yaml"
    pp.save_scene(replace(scene, contact=pp.PerfectlyRough()), path)
    code, _, _ = run("draw", str(path), "--force-angle", "200", "-o", str(tmp_path / "scene.svg"))
    assert code == 0


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["draw", SCENE, "--pusher-angle", "nan", "-o", "scene.svg"],
         "pusher_angle: nan given; allowed: a finite number of degrees"),
        (["draw", SCENE, "--force-angle", "200", "-o", "scene.svg"],
         "force_angle: 200.0 given; allowed: degrees in the friction cone, [26.56505118, 153.4349488]; "
         "give a force that the contact transmits"),
        (["draw", BOTH, "--force-angle", "90", "-o", "scene.svg"],
         "force_angle: 90.0 given; allowed: a scene with one effect"),
        (["draw", BOTH, "--limit-curve", "-o", "scene.svg"],
         "limit_curve: 'RingFriction and Inertia' given; allowed: a scene whose forces do not depend on "
         "the magnitude of its motion; leave the limit curve out, or list one effect\n"),
        (["draw", SCENE, "-o", "scene.doc"],
         "output: 'scene.doc' given; allowed: a name ending in .svg"),
        (["draw", SCENE, "--pusher-angle", "1", "--force-angle", "2", "-o", "scene.svg"],
         "pusher_angle, force_angle: (1.0, 2.0) given; allowed: one of them"),
    ],
)  # fmt: skip
def test_wrong_input(refused, arguments, said):
    refused(arguments, said)
