"""Walls at rest that an object meets while it is pushed."""

import numpy as np
import pytest

import planar_pushing as pp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
FEET = pp.SupportFriction(support=pp.Points([(1, 1), (-1, 1), (-1, -1), (1, -1)]))
FLOOR = pp.Wall((0, 0), (0, 1), pp.Coulomb(0.2))
METHODS = [{}, {"method": "time-stepping", "step": 0.01}]


def box(mu=0.3, point=(-1, 0.7), effects=(FEET,)):
    """A square that is pushed at a point of a side."""
    return pp.scene_at(point, outline=SQUARE, contact=pp.Coulomb(mu), effects=list(effects))


def along_the_wall(**options):
    """The box that a finger pushes against the floor and then along it."""
    pusher = pp.Pusher(velocity=[(0, (1, -0.2)), (2.6, (1, 0))], shape="finger", frame="world")
    given = {"duration": 4.0, "object_pose": (0, 1.3, np.deg2rad(8.0)), "walls": [FLOOR]}
    return pp.simulate(box(), pusher, **(given | options))


def energy_error(log):
    """Work of the pusher less the energies dissipated."""
    return float(log.work[-1] - log.contact_dissipated[-1] - log.dissipated[-1].sum())


class TestBoxAlongAWall:
    def test_events_are_where_they_are_expected(self):
        log = along_the_wall()
        arrives = float(log.time[(log.wall_mode[:, 0] > 0).values.argmax()])
        assert arrives == pytest.approx(0.949367, abs=2e-6)
        at = log.sel(time=2.6, method="nearest")
        assert at.object_position.values == pytest.approx([2.5123106, 1.0], abs=1e-6)
        assert log.object_position.values[-1] == pytest.approx([3.9123106, 1.0], abs=1e-6)
        assert float(log.time[-1]) == 4.0
        assert float(log.object_angle[-1]) == pytest.approx(0.0, abs=1e-6)
        modes = [int(log["mode"].sel(time=time, method="nearest")) for time in (0.5, 1.5, 2.3, 3.5)]
        assert modes == [pp.ContactMode.SLIP_LEFT] * 3 + [pp.ContactMode.STICK]
        lies = log.time[(np.abs(log.object_angle) < 1e-6).values.argmax()]
        assert float(lies) == pytest.approx(2.177679, abs=0.04)

    def test_steps_approach_events(self):
        exact = along_the_wall(duration=1.8)
        errors = []
        for step in (0.02, 0.01, 0.005):
            log = along_the_wall(duration=1.8, method="time-stepping", step=step)
            errors.append(abs(float(log.object_angle[-1] - exact.object_angle[-1])))
        assert errors[2] < 0.6 * errors[1] < 0.5 * errors[0]
        assert errors[2] < 0.02

    @pytest.mark.parametrize(("options", "error"), list(zip(METHODS, (1e-9, 1e-2), strict=True)))
    def test_the_work_is_dissipated(self, options, error):
        assert energy_error(along_the_wall(**options)) == pytest.approx(0.0, abs=error)

    def test_a_wall_that_is_far_changes_nothing(self):
        pusher = pp.Pusher(velocity=(1, -0.2), shape="finger", radius=0.1, frame="world")
        given = {"duration": 2.0, "object_pose": (0, 1.3, 0.1)}
        free = pp.simulate(box(), pusher, **given)
        far = pp.Wall((0, -50), (0, 1), pp.Coulomb(0.2))
        walled = pp.simulate(box(), pusher, walls=[far], **given)
        for name in (
            "object_position",
            "object_angle",
            "force",
            "slip",
            "work",
            "contact_position",
        ):
            ends = [log[name].values[-1] for log in (free, walled)]
            assert ends[1] == pytest.approx(ends[0], abs=1e-6), name
        assert (walled.wall_mode == pp.ContactMode.SEPARATE).all()
        gaps = walled.object_position[:, 1] + 50.0 - walled.wall_gap[:, 0]
        assert (gaps > 1.0 - 1e-9).all()

    def test_a_fence_pushes_against_a_wall(self):
        scene = pp.scene_at(side=0, outline=SQUARE, contact=pp.Coulomb(0.3), effects=[FEET])
        ceiling = pp.Wall((0, 2.0), (0, -1), pp.Coulomb(0.3))
        fence = pp.Pusher(velocity=(0, 1.0), frame="world")
        with pytest.warns(pp.EarlyEndWarning, match="jammed"):
            log = pp.simulate(scene, fence, duration=2.0, object_pose=(0, 0, 0), walls=[ceiling])
        assert float(log.time[-1]) == pytest.approx(1.0, abs=1e-6)
        assert log.object_position.values[-1] == pytest.approx([0.0, 1.0], abs=1e-6)

    def test_the_log_is_written_to_a_file(self, tmp_path):
        path = tmp_path / "log.nc"
        log = along_the_wall(path=path, samples=11)
        assert path.exists()
        assert log.wall_force.dims == ("time", "wall", "xy")
        assert log.attrs["stopped"] == ""

    def test_waypoints_end_with_the_run(self):
        """At the last waypoint the pusher still moves as until then."""
        way = [(0, (0, 0)), (2.6, (2.6, -0.52)), (4, (4, -0.52))]
        pusher = pp.Pusher(waypoints=way, shape="finger", frame="world")
        given = {"duration": 4.0, "object_pose": (0, 1.3, np.deg2rad(8.0)), "walls": [FLOOR]}
        log = pp.simulate(box(), pusher, **given)
        assert int(log["mode"][-1]) == pp.ContactMode.STICK
        assert log.force.values[-1] == pytest.approx(log.force.values[-2], abs=1e-9)

    def test_until_ends_the_run(self):
        log = along_the_wall(duration=0.5, until=pp.Until(rotation=np.deg2rad(3.0)))
        assert abs(float(log.object_angle[-1]) - 8.0) == pytest.approx(3.0, abs=1e-6)
        assert len(log.wall_mode) == len(log.time)


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"object_pose": None}, "object_pose"),
        ({"walls": [3]}, "a sequence of Wall"),
        ({"walls": [pp.Wall((0, 0.5), (0, 1), pp.Coulomb(0.2))]}, "an overlap of"),
        ({"walls": [pp.Wall((0, 0), (0, -1), pp.Coulomb(0.2))]}, "an overlap of"),
    ],
)
def test_wrong_walls_are_refused_in_one_line(changed, said):
    with pytest.raises(pp.InvalidValue) as caught:
        along_the_wall(**changed)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("scene", "said"),
    [
        (box(effects=(FEET, pp.Inertia())), "inertia"),
        (pp.Scene(
            slider=pp.Slider(rod_length=1.0, rod_angle=1.5), contact=pp.Coulomb(0.3), effects=(FEET,)
        ), "outline"),
    ],
)  # fmt: skip
def test_scenes_that_walls_cannot_have_are_refused(scene, said):
    pusher = pp.Pusher(velocity=(1, 0), shape="finger", frame="world")
    with pytest.raises(pp.InvalidValue, match=said):
        pp.simulate(scene, pusher, duration=1.0, object_pose=(0, 3, 0), walls=[FLOOR])


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (((0, 0), (0, 0), pp.Coulomb(0.2)), "a nonzero vector"),
        (((0, np.nan), (0, 1), pp.Coulomb(0.2)), "two finite numbers"),
        (((0, 0), (0, 1), 0.2), "Coulomb, InfiniteFriction or PerfectlyRough"),
    ],
)
def test_a_wrong_wall_is_refused(arguments, said):
    with pytest.raises(pp.InvalidValue, match=said):
        pp.Wall(*arguments)
