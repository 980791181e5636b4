"""Final poses that no push can cause are refused; those of pushes on any support are not."""

import numpy as np
import pytest
from pushes.written import SQUARE, turn

import planar_pushing as pp
from planar_pushing.pushes.formats.table import read_table

#: A square of side 90 mm, and a finger that pushes it over 14.75 mm.
BLOCK = 45.0 * np.array(SQUARE)
GIVEN = {
    "outline": BLOCK, "poses_before": [(0, 0, 0)], "finger_start": [(10, -60)],
    "finger_end": [(10, -35)], "finger_radius": 4.75,
}  # fmt: skip
DEEP = "a finger that ends {} deep in the object, in pushes 0"
TURNED = (
    "points of the object that move by {} on average, and a finger that ends at another side, "
    "in pushes 0"
)
QUARTER, HALF = 0.05 + np.pi / 2, 0.05 + np.pi


def cases():
    """Poses after, and what is said of them."""
    return {
        "a quarter turn": ((0, 14.5, QUARTER), TURNED.format(f"{mean(QUARTER):.4g}")),
        "a quarter turn back": ((0, 14.5, 0.05 - np.pi / 2), "points of the object that move by "),
        "half a turn": ((0, 14.5, HALF), TURNED.format(f"{mean(HALF):.4g}")),
        "at rest": ((0, 0, 0), DEEP.format("14.75")),
        "against the finger": ((0, -14.5, 0), DEEP.format("29.25")),
        "three times as far": ((0, 45, 0), "an object that ends 30.0"),
        "farther than itself": ((0, 260, 0), "an object that ends 24"),
        "aside by far": ((-40, 14.75, 0), "an object that moves by 42.63, in pushes 0"),
    }  # fmt: skip


def mean(angle):
    """Mean displacement of the square's points, by the cells of the module, summed in another way."""
    x = (np.arange(24) + 0.5) / 24 * 90 - 45
    points = np.array([(a, b) for a in x for b in x])
    return np.linalg.norm(points @ turn(angle).T + (0, 14.5) - points, axis=1).mean()


def scaled(factor, pose, move=(0.0, 0.0, 0.0)):
    """The push in other units, with the object's frame elsewhere in the world."""

    def place(points):
        return np.array(points) * factor @ turn(move[2]).T + move[:2]

    after = np.append(place([pose[:2]])[0], pose[2] + move[2])
    return {
        "outline": BLOCK * factor, "poses_before": [move], "poses_after": [after],
        "finger_start": place(GIVEN["finger_start"]), "finger_end": place(GIVEN["finger_end"]),
        "finger_radius": 4.75 * factor,
    }  # fmt: skip


@pytest.mark.parametrize("case", cases())
def test_impossible_poses_are_refused_with_their_push(case):
    pose, said = cases()[case]
    with pytest.raises(pp.InvalidValue) as error:
        pp.pushes_from_poses(**GIVEN, poses_after=[pose])
    assert error.value.given.startswith(said), str(error.value)
    assert error.value.remedy.endswith("leave the push out")
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("case", cases())
@pytest.mark.parametrize("factor", [1e-6, 1e-3, 1e5])
def test_units_and_frame_do_not_matter(case, factor):
    pose, _ = cases()[case]
    with pytest.raises(pp.InvalidValue, match=r"^pushes: .*, in pushes 0"):
        pp.pushes_from_poses(**scaled(factor, pose, (3.0 * factor, -7.0 * factor, 2.0)))
    possible = scaled(factor, (0.0, 14.0, 0.1), (3.0 * factor, -7.0 * factor, 2.0))
    assert pp.pushes_from_poses(**possible)["rotation"].values == pytest.approx([np.rad2deg(0.1)])


def test_every_route_refuses_them(tmp_path):
    good = pp.pushes_from_poses(**GIVEN, poses_after=[(0, 14.0, 0.1)])
    bad = good.copy(deep=True)
    bad["rotation"][:] = 100.0
    said = "a finger that ends at another side, in pushes 0"
    routes = (
        lambda: pp.concat_pushes([good, bad]), lambda: pp.identify(bad), lambda: pp.compare(bad),
        lambda: pp.save_pushes(bad, tmp_path / "bad.nc"),
    )  # fmt: skip
    for route in routes:
        with pytest.raises(pp.InvalidValue, match=said):
            route()
    pp.save_pushes(good, tmp_path / "bad.nc")
    bad.to_netcdf(tmp_path / "bad.nc", engine="h5netcdf")
    with pytest.raises(pp.InvalidFile, match=said):
        pp.load_pushes(tmp_path / "bad.nc")
    names = "x_before,y_before,angle_before,x_after,y_after,angle_after,x_start,y_start,x_end,y_end"
    (tmp_path / "bad.csv").write_text(
        f"{names}\n0,0,0,0,14,5,10,-60,10,-35\n0,0,0,0,14.5,183,10,-60,10,-35\n"
    )
    with pytest.raises(pp.InvalidFile, match=r"in pushes 1' given.*push 0 is the first row"):
        read_table(tmp_path / "bad.csv", outline=BLOCK, finger_radius=4.75)


def test_the_number_is_that_of_the_given_push():
    """Also if a push before it is left out."""
    given = {key: [*value] * 3 for key, value in GIVEN.items() if isinstance(value, list)}
    given["finger_end"][0] = (10, -55)
    after = [(0, 0, 0), (0, 14, 0.1), (0, 14.5, HALF)]
    rest = {"outline": BLOCK, "finger_radius": 4.75, "poses_after": after, "skip_missed": True}
    with pytest.raises(pp.InvalidValue, match="at another side, in pushes 2'"):
        pp.pushes_from_poses(**given | rest)


def test_the_given_noise_widens_what_is_accepted():
    """By five standard deviations beyond 5 percent of the size: 14.75 mm deep needs 2.05 mm of noise."""
    at_rest = GIVEN | {"poses_after": [(0, 0, 0)]}
    for noise, accepted in (((2.0, 0, 0), False), ((2.1, 0, 0), True), ((0, 2.7, 0), True)):
        if accepted:
            assert pp.pushes_from_poses(**at_rest, noise=noise)["displacement"].values.tolist() == [
                [0, 0]
            ]
            continue
        with pytest.raises(pp.InvalidValue, match=r"at most 14.5, for errors of measurement"):
            pp.pushes_from_poses(**at_rest, noise=noise)


def test_known_feet_give_the_exact_work():
    """A turn about a foot that carries all costs nothing; the same turn with even loads does."""
    spin = {
        "outline": BLOCK, "poses_before": [(0, 0, 0)], "finger_start": [(40, -45)],
        "finger_end": [(40, -20)],
    }  # fmt: skip
    # By 40 degrees about the origin the finger's place is on the side at y = -45 again.
    pose = (0.0, 10.0, np.deg2rad(40.0))
    feet = [(0, 0), (40, 40), (-40, 40), (40, -40), (-40, -40)]
    loads = np.array([1.0, 0, 0, 0, 0])
    after = [
        np.linalg.norm(turn(pose[2]) @ foot + pose[:2] - foot) for foot in np.array(feet, float)
    ]
    assert np.mean(after) > 25.0 + 4.5 > after[0]
    assert pp.pushes_from_poses(**spin, poses_after=[pose], feet=feet, foot_weights=loads).sizes[
        "push"
    ]
    assert pp.pushes_from_poses(**spin, poses_after=[pose], feet=feet).sizes["push"]
    assert pp.pushes_from_poses(**spin, poses_after=[pose]).sizes["push"]
    said = f"an object that moves by {np.mean(after):.4g}, in pushes 0"
    with pytest.raises(pp.InvalidValue, match=said):
        pp.pushes_from_poses(**spin, poses_after=[pose], feet=feet, foot_weights=np.ones(5))
    with pytest.raises(pp.InvalidValue, match=f"an object that moves by {min(after[1:]):.4g}"):
        pp.pushes_from_poses(**spin, poses_after=[pose], feet=feet[1:4])


SHAPES = {
    "square": BLOCK, "long": BLOCK * (1.0, 0.4), "triangle": np.array([(0, 0), (90, 0), (0, 90)]) - 30.0,
    "ell": 45.0 * np.array([(-1, -1), (1, -1), (1, 0), (0, 0), (0, 1), (-1, 1)]),
}  # fmt: skip


@pytest.mark.filterwarnings("ignore:support:planar_pushing.SceneWarning")  # any support
@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("spot", [0.02, pytest.param(0.1, marks=pytest.mark.slow), 0.3])
def test_pushes_on_any_support_are_accepted(name, spot):
    """Also where a small disc off the middle carries all, the finger is smooth, and pushes are long."""
    middle = np.array([(5.0, 2.0), (-15.0, -18.0)])
    for x, y in middle:
        support = pp.SupportFriction(support=pp.Disc(45.0 * spot, center=(x, y)))
        for distance in (3.0, 20.0):
            found = pp.simulate_pushes(
                (support,), SHAPES[name], 8, seed=2, contact=pp.Coulomb(0.05), distance=distance,
                finger_radius=2.0, noise=(0.2, 0.5, 0.0),
            )  # fmt: skip
            assert found.sizes["push"] == 8
