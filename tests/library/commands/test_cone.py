"""The command `cone`."""

import json

import pytest

SCENE = "workflow/scenes/figure_03.yaml"


def test_cone_json(run):
    code, out, _ = run("cone", SCENE, "--json")
    told = json.loads(out)
    assert code == 0
    assert told["motion_cone"] == pytest.approx([-28.910274893814538, 138.05152762089722], abs=1e-9)
    assert told["pulls"] is True
