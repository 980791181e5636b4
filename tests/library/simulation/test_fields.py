"""Fields of a log: their places in the rows of the core, and their units; codes that two places name."""

import numpy as np
import pytest
from mechanics.builders import make_scene

import planar_pushing as pp
from planar_pushing.core.motion.kinematics import system
from planar_pushing.core.motion.kinematics.run import LOG_ROW, LogRow
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.simulation.fields import (
    COMPUTED,
    FIELDS,
    PLACED,
    arrays,
    logged_fields,
    scales_of,
)
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.options import Event

FILM = pp.Viscous(support=pp.Disc(1.0), coefficient=0.1)


def test_a_row_is_scaled_by_the_radius_and_the_unit_of_force():
    width = LOG_ROW + 2
    (scales,) = scales_of(np.array([3.0]), np.array([0.5]), width)
    assert set(scales) == {1.0, 3.0, 0.5, 1.5}
    assert scales[LOG_ROW:].tolist() == [1.5, 1.5]
    columns = Columns(LogRow, scales)
    assert columns.twist.tolist() == [3.0, 3.0, 1.0]
    assert columns.pusher.tolist() == [3.0, 3.0]
    assert columns.force.tolist() == [0.5, 0.5]
    assert (columns.time, columns.mode) == (1.0, 1.0)


def test_every_number_of_a_row_is_read_by_one_field():
    """Twice only where a field is computed from the numbers of another; `stopped` becomes a text."""
    sources = [
        source
        for name, source, *_ in FIELDS
        if name not in {**COMPUTED, **PLACED}
        or name in ("rod_angle", "contact_normal", "dissipated", "evaluations")
    ]
    assert sorted(["stopped", *sources]) == sorted(["", *LogRow.places])


@pytest.mark.parametrize("effects", [
    (pp.Inertia(mass=1.0), pp.RingFriction(weight=2.0), pp.RingFriction(weight=3.0)),
    (pp.RingFriction(weight=2.0), pp.Inertia(mass=1.0), FILM),
], ids=["friction", "viscous"])  # fmt: skip
def test_energies_are_those_of_the_effects_in_their_order(effects):
    scene = make_scene(2.0, 0.5, effects)
    problem = Problem(scene=scene, pusher=pp.Pusher(velocity=(0.0, 1.0)), duration=1.0)
    rows = np.zeros((1, LOG_ROW + 2))
    rows[0, LOG_ROW:] = 5.0, 7.0
    found = arrays(rows, problem, logged_fields(problem, "event-driven"))["dissipated"][0]
    resists = [not isinstance(effect, pp.Inertia) for effect in effects]
    assert found[resists].tolist() == [5.0, 7.0]
    assert not found[np.logical_not(resists)].any()


def test_events_have_the_codes_of_the_core():
    """The layers that name them do not import one another."""
    names = {
        "SLIDER_CENTER_REACHES_FENCE": "CENTER_DOWN", "MOTION_CENTER_AT_POINT": "CENTER_AT_POINT",
        "NORMAL_VELOCITY_REVERSES": "NORMAL_REVERSES",
        "TANGENTIAL_VELOCITY_REVERSES": "TANGENTIAL_REVERSES",
    }  # fmt: skip
    causes = [event for event in Event if event is not Event.NONE]
    assert [getattr(system, names.get(e.name, e.name)) for e in causes] == causes
    assert len(causes) == system.CAUSES
