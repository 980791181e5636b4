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


@pytest.mark.parametrize(("contact", "closed"), [
    ("{law: coulomb, friction_coefficient: 2}", "True (the edges belong"),
    ("{law: infinite_friction, at_zero_normal: none}", "False (the edges do not belong"),
])  # fmt: skip
def test_cone_in_words_has_units(run, tmp_path, contact, closed):
    path = tmp_path / "scene.yaml"
    slider, effects = "{rod_length: 2, rod_angle: 45}", "[{type: ring_friction}]"
    path.write_text(f"slider: {slider}\ncontact: {contact}\neffects: {effects}\n", encoding="utf-8")
    code, out, _ = run("cone", str(path))
    lines = dict(line.split(": ") for line in out.splitlines())
    assert code == 0
    assert list(lines)[:2] == ["friction_cone [degree]", "motion_cone [degree]"]
    assert lines["closed"] == f"{closed} to the motion cone)"


def test_a_side_is_refused_with_a_command_and_a_key(refused):
    refused(
        ["cone", "workflow/scenes/box_side.yaml"],
        "scene: 'a side that lies on the fence' given; allowed: a scene with a contact at one point; use "
        "planar-pushing solve, or give contact: {point: [x, y]} in the file\n",
    )
