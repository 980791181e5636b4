"""A support of a user's own class is simulated, and no file holds it."""

from __future__ import annotations

import json

import numpy as np
import pytest

import planar_pushing as pp
from mechanics.supports.cases import FRAME
from mechanics.supports.test_own_kinds import Own, scene
from planar_pushing.figures.timeline import plotted


@pytest.mark.parametrize(
    "own", [Own(FRAME), pp.Composite([(2.0, Own(FRAME))])], ids=["own", "member"]
)
def test_it_is_simulated_and_no_file_holds_it(own, tmp_path):
    push = {"pusher": pp.Pusher(velocity=(0.1, 1.0)), "duration": 0.2, "samples": 3}
    log, wanted = (pp.simulate(scene(each), **push) for each in (own, FRAME))
    assert np.array_equal(log["rod_angle"], wanted["rod_angle"])
    (effect,) = json.loads(log.attrs["scene"])["effects"]
    entry = (
        effect["support"]["members"][0]["support"]
        if own.__class__ is not Own
        else effect["support"]
    )
    (plate,) = FRAME.pieces().plates
    assert entry == {"shape": "Own", "pieces": {"plates": [plate.tolist()]}}
    assert pp.draw(scene(own), 1.4).figure
    with pytest.raises(pp.InvalidFile, match=r"support of your own class.* Composite of them"):
        plotted(log)
    with pytest.raises(
        pp.InvalidValue, match=r"support: .*allowed: the shapes of scene files: .*Composite"
    ):
        pp.save_scene(scene(own), tmp_path / "scene.yaml")
    assert not list(tmp_path.iterdir())
