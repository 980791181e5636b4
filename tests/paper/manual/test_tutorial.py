"""The cells of the tutorial run in their order, and find what its text says."""

import re
from code import InteractiveConsole
from pathlib import Path

import matplotlib
import numpy as np
import pytest

pytestmark = pytest.mark.slow

TEXT = Path("paper/manual/tutorial.md").read_text(encoding="utf-8")
CELL = re.compile(r"^```\{code-cell\} ipython3\n(.*?)^```$", re.MULTILINE | re.DOTALL)
#: Lines that fit on a screen.
SCREEN = 25


@pytest.fixture(scope="module")
def names(tmp_path_factory):
    """What the cells leave behind."""
    found = {}
    with matplotlib.rc_context(), pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("tutorial"))
        matplotlib.use("agg")
        for code in CELL.findall(TEXT):
            exec(compile(code, "tutorial.md", "exec"), found)
        found["plt"].close("all")
    return found


def test_the_cells_run_when_they_are_pasted_into_python(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    console = InteractiveConsole()
    with matplotlib.rc_context():
        matplotlib.use("agg")
        for code in CELL.findall(TEXT):
            for line in [*code.splitlines(), ""]:
                console.push(line)
            printed = capsys.readouterr()
            assert not printed.err, code
            assert len(printed.out.splitlines()) <= SCREEN, code
        console.locals["plt"].close("all")


def test_the_box_turns_as_its_text_says(names):
    solution = names["pp"].solve(names["carton"], np.pi / 2, 0.05)[0]
    assert solution.mode.name == "STICK"
    # The wrench of the base, summed over a grid, balances the force of the finger.
    x, y = np.meshgrid((np.arange(300) + 0.5) / 1000 - 0.15, (np.arange(200) + 0.5) / 1000 - 0.1)
    v_x, v_y, spin = names["carton"].to_object(solution.twist, "twist")
    force = np.stack([v_x - spin * y, v_y + spin * x])
    force *= 1.2 * 9.80665 * 0.3 / np.hypot(*force)
    assert np.mean(force, axis=(1, 2)) == pytest.approx(solution.force, abs=2e-4)
    assert f"{solution.force[1]:.1f} N" in TEXT
    assert f"{solution.twist[2]:.2f} rad/s" in TEXT
    assert not names["turned"].attrs["stopped"]


def test_the_finger_rolls_along_the_mug_before_it_slips(names):
    pushed = names["pushed"]
    # The equation of two states of a ring with a round wall, solved with elliptic integrals.
    assert pushed.object_position[-1].values == pytest.approx([-0.0222303647, 0.0680912296])
    assert pushed.object_angle[-1].item() == pytest.approx(49.388399592)
    assert not pushed.parted.any()
    slips = pushed.time[pushed.slip.values != 0][0].item()
    assert slips == pytest.approx(1.12, abs=0.03)
    assert names["velocity"] == pytest.approx((0.0063775648, 0.0534726706))


def test_a_push_along_the_normal_sticks(names):
    (solution,) = names["pp"].solve(names["ring"], np.pi / 2)
    assert solution.mode.name == "STICK"
    assert solution.twist[2] < 0


def test_pulling_has_three_solutions(names):
    assert [mode.name for mode in names["pulled"].modes] == ["SEPARATE", "STICK", "SLIP_LEFT"]
    assert names["pp"].motion_cone(names["ring"]).right < 0


def test_the_threshold_of_friction_is_near_1_27(names):
    least = names["friction_of_rings"][names["cones"].right.isel(rod=2) < 0].min()
    assert least.item() == pytest.approx(1.3)  # the first of the grid beyond it
    assert names["cones"].right.size == 644


def test_infinite_friction_slips_and_perfect_roughness_adheres(names):
    pp, push = names["pp"], np.deg2rad(165)
    assert pp.motion_cone(names["rough"]).degrees[1] == pytest.approx(138.83997216476)
    assert [mode.name for mode in pp.solve(names["rough"], push).modes] == ["SLIP_RIGHT"]
    assert [each.adhesive for each in pp.solve(names["glued"], push)] == [True]


def test_over_time_the_policy_decides(names):
    towed, left = names["towed"], names["left"]
    assert not towed.gap.sel(time=slice(None, 2.04)).any()
    assert towed.gap.sel(time=slice(2.06, None)).min() > 0
    assert left.gap[-1] > towed.gap[-1] > 0.1
    assert set(towed.solutions.sel(time=slice(0.41, 2.04)).values) == {3}


def test_a_hard_retreat_cannot_pull(names):
    pp = names["pp"]
    counts = [len(pp.solve(names["heavy"], np.deg2rad(-5), size)) for size in (0.1, 1.0, 10.0)]
    assert counts == [3, 1, 1]


def test_the_box_and_the_stool(names):
    pp = names["pp"]
    assert np.round(pp.motion_cone(names["box"]).degrees, 6).tolist() == [23.12516, 156.87484]
    assert names["solution"].pivot == 2
    assert names["loaded"].center_of_pressure == pytest.approx((0.24, 0.02))


def test_the_finger_leaves_the_side_at_its_end(names):
    end = names["end"]
    found = end.time.item(), end.rod_angle.item(), end.contact_position.item()
    assert np.round(found, 4).tolist() == [2.7612, 145.7377, 1.0]


def test_the_scene_is_kept(names):
    assert names["pp"].load_scene(names["kept"]) == names["box"]
