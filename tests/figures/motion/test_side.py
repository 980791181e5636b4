"""The side that a finger pushes, in pictures of motion."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.figures.motion.animation import resampled
from planar_pushing.figures.motion.timeline import contact, plotted, rod_end
from planar_pushing.figures.motion.trajectory import box
from simulation.runs import heading, run


@pytest.fixture(params=[(-1.0, 0.25), (-np.inf, np.inf)], ids=["ends", "endless"])
def log(request):
    slider = pp.Slider(rod_length=2.0, rod_angle=1.2, side=request.param)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(0.1), effects=(pp.RingFriction(),))
    return run(
        scene,
        pp.Pusher(velocity=heading(68), shape="finger"),
        0.5,
        samples=9,
        method="time-stepping",
    )


def test_the_finger_is_on_the_side_while_the_contact_lasts(log):
    data = plotted(log)
    one, other = np.moveaxis(data.path_side.values, 1, 0)
    along, arm = other - one, contact(data) - one
    height = (along[:, 0] * arm[:, 1] - along[:, 1] * arm[:, 0]) / np.hypot(*along.T)
    assert -height == pytest.approx(log.gap.values, abs=1e-12)
    assert np.ptp(np.hypot(*along.T)) == pytest.approx(0, abs=1e-12)


def test_the_side_is_fixed_to_the_slider(log):
    data = plotted(log)
    for end in np.moveaxis(data.path_side.values, 1, 0):
        for place in (rod_end(data), data.path_position.values):
            assert np.ptp(np.hypot(*(end - place).T)) == pytest.approx(0, abs=1e-12)


def test_a_side_is_drawn_between_its_ends_and_around_the_finger_without(log):
    first, last = plotted(log).path_side.values[0, :, 0]
    beyond = 0.45 * 3.0
    reach = log.contact_position.values.max() + beyond
    assert (first, last) == pytest.approx((-1.0, 0.25) if log.parted.any() else (-beyond, reach))


def test_frames_and_their_box_hold_the_side(log):
    data = resampled(plotted(log), 4)
    left, right, low, high = box(data)
    assert (data.path_side.values >= (left, low)).all()
    assert (data.path_side.values <= (right, high)).all()
