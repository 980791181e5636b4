"""The pictures of README show the motions that their words name, and are those stored."""

import re
from pathlib import Path

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.simulate import simulate_file
from pulling_by_pushing.figures import front
from pulling_by_pushing.figures.front_box import MOTIONS, box_motions

#: The animation takes as long as its frames are many.
FILES = [
    pytest.param(path, marks=pytest.mark.slow if path == front.ANIMATION else ())
    for path in front.FILES
]


@pytest.mark.parametrize("path", FILES, ids=str)
def test_the_stored_pictures_are_those_that_are_made(path):
    stored, new = path.read_bytes(), front.FILES[path]()
    assert front.difference(new, stored) <= front.LEVEL_TOLERANCE
    assert len(stored) < 1e6


def test_every_seventh_frame_of_the_animation_is_the_stored_one(monkeypatch):
    """From the first one to the last one, with the one in the middle, whose colors all take."""
    rows, pictures = range(0, front.FRAMES, 7), front.pictures
    monkeypatch.setattr(front, "pictures", lambda motions, _: pictures(motions, rows))
    stored, new = (
        list(front.frames(each)) for each in (front.ANIMATION.read_bytes(), front.animation())
    )
    assert len(stored) == front.FRAMES == rows[-1] + 1
    assert rows[len(rows) // 2] == front.FRAMES // 2
    for row, frame in zip(rows, new, strict=True):
        assert np.sqrt(np.mean((frame - stored[row]) ** 2)) <= front.LEVEL_TOLERANCE
    assert front.ANIMATION.stat().st_size < 1e6


def test_another_picture_differs(tmp_path, monkeypatch, capsys):
    """Also one whose number of frames differs; and `--write` stores it."""
    animation, box = (path.read_bytes() for path in (front.ANIMATION, front.BOX))
    assert front.difference(animation, box) == np.inf
    path = tmp_path / "box.png"
    monkeypatch.setattr(front, "FILES", {path: lambda: box})
    for more, code, said in (([], 1, "differs"), (["--write"], 1, "differs"), ([], 0, "unchanged")):
        assert front.main(more) == code
        assert f"box.png: {said}" in capsys.readouterr().out
    assert path.read_bytes() == box


def test_the_fence_retreats_and_the_ring_follows():
    motion = front.motion_of(front.PULLING, 7)
    assert not motion.path_gap.values.any()
    assert np.all(np.diff(motion.path_pusher.values[:, 1]) < 0)
    away = -motion.path_pusher.values[-1, 1]
    assert away == pytest.approx(3.5 * np.sin(np.deg2rad(35)), rel=1e-12, abs=0)


def test_a_contact_that_leaves_its_mode_is_refused(monkeypatch, tmp_path):
    path = tmp_path / "long.yaml"
    text = front.PULLING.scene.read_text(encoding="utf-8")
    path.write_text(text.replace("duration: 3.5", "duration: 4"), encoding="utf-8")
    assert simulate_file(load_scene_file(path)).gap.values[-1] > 0
    with pytest.raises(pp.InvalidFile, match="SEPARATE, STICK; allowed: STICK; correct the scene"):
        front.motion_of(front.PULLING._replace(scene=path))


def test_the_box_moves_as_its_words_say():
    motions = box_motions()
    assert set(motions) == set(MOTIONS)
    for mode, data in motions.items():
        assert set(data.path_mode.values) == {mode}
        moved = np.hypot(*(data.path_position[-1] - data.path_position[0]).values)
        assert (moved > 0.01) == (mode is not pp.ContactMode.SEPARATE)
        assert (abs(data.path_slip[-1].item()) > 0.01) == (mode is pp.ContactMode.SLIP_LEFT)


def test_the_coefficient_in_the_title_is_that_of_the_scene():
    (coefficient,) = re.findall(r"friction (\d+)", front.PULLING.title)
    assert front.PULLING.scene.is_file()
    assert pp.load_scene(front.PULLING.scene).contact == pp.Coulomb(float(coefficient))
    assert pp.load_scene(Path(front.SLIP.scene)).contact == pp.InfiniteFriction()
