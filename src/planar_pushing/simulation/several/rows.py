"""Runs with several contacts as rows of a log: a pusher with walls, or a finger at two places."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.core.motion.kinematics.run import LOG_ROW, LogRow
from planar_pushing.mechanics.contact import ContactMode, Law, in_numbers
from planar_pushing.mechanics.kernels.arrays import flag_attributes
from planar_pushing.mechanics.kernels.columns import Columns
from planar_pushing.mechanics.outline import Outline
from planar_pushing.simulation.early_end import REASONS
from planar_pushing.simulation.fields import Stop
from planar_pushing.simulation.log import FLAGS
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.runs import PARTS, STEPS
from planar_pushing.simulation.several.events import EventRun
from planar_pushing.simulation.several.instants import Instants
from planar_pushing.simulation.several.movers import (
    POINT_RADIUS,
    Mover,
    Pose,
    Shape,
    Touch,
    rests,
)
from planar_pushing.simulation.several.paths import path_of
from planar_pushing.simulation.several.places import FingerPlace
from planar_pushing.simulation.several.readings import force_of, gap_of, mode_of
from planar_pushing.simulation.several.run import Row
from planar_pushing.simulation.several.steps import StepRun
from planar_pushing.simulation.walls import Wall
from planar_pushing.terms import quantities
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Event, Method
from planar_pushing.terms.options import Shape as PusherShape
from planar_pushing.terms.units import Units, with_units

#: Smallest tolerance of a step: below it, rounding errors of the contacts decide.
FINEST = 1e-11


class SeveralRows:
    """A run with several contacts from an instant on; iteration yields its rows in the units of the scene.

    Parameters
    ----------
    problem : Problem
        Of one scene without inertia, whose outline is known.
    walls : sequence of Wall
        In the fence frame.
    times : array_like
        Increasing times that are logged, the first at or after the beginning.
    method : Method
    step : float, optional
        Maximum length of a step of time-stepping.
    start : ndarray, optional
        The row of a log from which the run goes on; by default it begins at time 0.
    """

    def __init__(
        self,
        problem: Problem,
        walls: Sequence[Wall],
        times: npt.ArrayLike,
        method: Method,
        step: float | None = None,
        start: Array | None = None,
    ) -> None:
        slider, scene = problem.scene.slider, problem.scene
        self.problem, self.method = problem, method
        self.times = np.asarray(times, float)
        self.step = float(problem.duration) / STEPS if step is None else step
        outline = slider.outline_in_body()
        if outline is None:
            raise InvalidValue("outline", None, "the outline of the object", "give it to scene_at")
        self.outline: Outline = outline
        shape, path_breaks = Shape(self.outline), path_of(problem.pusher, float(problem.duration))
        gap, angle = float(problem.gap), float(slider.rod_angle)
        length = float(slider.rod_length)
        self.is_finger = problem.shape == PusherShape.FINGER
        law: Law = Law(*(float(number) for number in scene.law))
        origin, radius = (0.0, -gap), float(np.asarray(problem.pusher.radius))
        normal: tuple[float, float] | None = (0.0, 1.0)
        if self.is_finger:
            drawn = max(radius, POINT_RADIUS * shape.size)
            origin, normal = (0.0, -gap - drawn / math.cos(float(slider.pocket))), None
        pusher = Mover(law, origin, radius, normal, path_breaks[0])
        others = [
            Mover(in_numbers(wall.law), wall.position, 0.0, wall.unit_normal, rests)
            for wall in walls
        ]
        self.movers = [pusher, *others]
        pose = Pose(length * math.cos(angle), length * math.sin(angle), angle)
        policies = problem.on_ambiguity
        breaks = [*path_breaks[1], *(time for time, _ in policies if time > 0.0)]
        instants = Instants(scene, self.movers, policies)
        kind = StepRun if method == Method.TIME_STEPPING else EventRun
        self.run: StepRun | EventRun = kind(shape, instants, self.movers, pose, breaks)
        self.stop = Stop.NO
        self.place = FingerPlace(self.outline)
        if start is not None:
            self._start_from(start)

    def _start_from(self, numbers: Array) -> None:
        """Go on from a row of a log."""
        row, length = LogRow(numbers), float(self.problem.scene.slider.rod_length)
        sums = [row.slip, row.work, row.contact_dissipated, row.load_work, *numbers[LOG_ROW:]]
        pose = Pose(float(row.position.x), float(row.position.y), float(row.angle))
        self.run.start_from(float(row.time), pose, np.array(sums), int(row.mode))
        self.run.instants.evaluations = int(row.evaluations)
        self.place.along, self.place.normal = float(row.contact_position), float(row.contact_normal)
        self.place.measure_from((-length, 0.0))

    @property
    def stopped(self) -> str:
        """Reason why the run ended early; empty otherwise."""
        return "" if self.stop == Stop.NO else REASONS[self.stop].text

    def between(self, low: float, high: float) -> Array:
        """Finer instants strictly between two."""
        inner = np.linspace(low, high, PARTS + 1)
        return inner[(inner > low) & (inner < high)]

    def require_apart(self) -> None:
        """Refuse walls that the object penetrates at the start, and those that hold the pusher."""
        run, size = self.run, self.run.shape.size
        for number, mover in enumerate(self.movers[1:]):
            touches = run.shape.touches(number, mover, run.pose, 0.0, -1e-6 * size)
            if touches:
                deepest = min(touch.gap for touch in touches)
                raise InvalidValue(
                    "walls", f"an overlap of {-deepest:.6g} of wall {number} with the object",
                    "walls that the object does not penetrate at the start",
                    "move the wall or the object; the normal of a wall is toward the object",
                )  # fmt: skip

    def __iter__(self) -> Iterator[Array]:
        run = self.run
        steps: bool = self.method == Method.TIME_STEPPING
        run.advance(self.times.tolist(), self.step if steps else max(self.problem.rtol, FINEST))
        rows = np.zeros((len(run.log), LOG_ROW + run.instants.resisting))
        for numbers, row in zip(rows, run.log, strict=True):
            self._write(numbers, row)
        self._write_events(rows)
        self._write_places(rows)
        if run.stopped:
            self.stop = run.stop
            Columns(LogRow, rows[-1:]).stopped[:] = run.stop
        yield rows

    def _write(self, numbers: Array, row: Row) -> None:
        """Write an instant, without its place on the outline."""
        log, pose = LogRow.places, row.pose
        c, s = math.cos(pose.angle), math.sin(pose.angle)
        v_x, v_y, omega = row.twist
        (x, y), _ = self.movers[0].path(row.time)
        speed = math.hypot(v_x, v_y)
        values = {
            "time": row.time, "position": (pose.x, pose.y), "angle": pose.angle,
            "twist": (c * v_x - s * v_y, s * v_x + c * v_y, omega),
            "pusher": (x, y - float(self.problem.gap)),
            "slip": row.totals.slipped[0], "gap": gap_of(self.run, row, 0), "force": force_of(row, 0),
            "mode": mode_of(row, 0), "solutions": row.solutions, "pivot": -1, "event": Event.NONE,
            "ratio": self._ratio(omega, speed), "contact_dissipated": row.totals.rubbed,
            "work": row.totals.work[0], "load_work": row.totals.load_work,
            "evaluations": row.evaluations,
            "flush": not self.is_finger and sum(touch.mover == 0 for touch in row.touches) > 1,
        }  # fmt: skip
        for name, value in values.items():
            numbers[log[name]] = value
        numbers[LOG_ROW:] = row.totals.dissipated

    def _ratio(self, omega: float, speed: float) -> float:
        if omega == 0.0:
            return 0.0
        turn = float(self.problem.scene.slider.radius) * omega
        return turn / speed if speed else math.copysign(math.inf, omega)

    def _write_events(self, rows: Array) -> None:
        """Write why the modes have changed."""
        events, log = Columns(LogRow, rows).event, self.run.log
        for i, (one, two) in enumerate(itertools.pairwise(log)):
            closed = [[mode for mode in row.modes if mode > 0] for row in (one, two)]
            sticks = [modes.count(ContactMode.STICK) for modes in closed]
            if self.method == Method.TIME_STEPPING or closed[0] == closed[1]:
                continue
            event = Event.LEAVES_CONE if sticks[1] < sticks[0] else Event.SLIP_ENDS
            if len(closed[0]) != len(closed[1]):
                is_new = len(closed[1]) > len(closed[0])
                event = Event.TOUCHES if is_new else Event.FORCE_ENDS
            events[i + 1] = event

    def _write_places(self, rows: Array) -> None:
        """Write the place of the pusher's contact: on the outline of a finger, along a fence."""
        columns = Columns(LogRow, rows)
        columns.contact_piece[:] = -1.0
        for i, row in enumerate(self.run.log):
            touches = [touch for touch in row.touches if touch.mover == 0]
            if touches and self.is_finger:
                columns.contact_piece[i] = self.place.follow(row)
            elif touches:
                self.place.along = self._place_of_force(row, touches)
            columns.contact_position[i] = self.place.along
            columns.contact_normal[i] = self.place.normal

    def _place_of_force(self, row: Row, touches: list[Touch]) -> float:
        """Where the force acts along a fence, from its point under the contact at time 0."""
        c, s = math.cos(row.pose.angle), math.sin(row.pose.angle)
        (x, _), _ = self.movers[0].path(row.time)
        places = [row.pose.x + c * t.point[0] - s * t.point[1] - x for t in touches]
        pushes = [
            max(f[0] * t.normal[0] + f[1] * t.normal[1], 0.0)
            for t, f in zip(row.touches, row.forces, strict=True)
            if t.mover == 0
        ]
        total = sum(pushes)
        if total == 0.0:
            return places[0]
        return sum(push * place for push, place in zip(pushes, places, strict=True)) / total


def wall_variables(run: SeveralRows, count: int, units: Units | None) -> dict[str, xr.Variable]:
    """Modes, forces, gaps and slips of walls in the first rows of a log, with the axes of `force`."""
    log, walls = run.run.log[:count], range(1, len(run.movers))
    modes = [[mode_of(row, wall) for wall in walls] for row in log]
    forces = [[force_of(row, wall) for wall in walls] for row in log]
    slips = [[row.totals.slipped[wall] for wall in walls] for row in log]
    values = {
        "wall_mode": np.array(modes, "i1"),
        "wall_force": np.array(forces, float),
        "wall_slip": np.array(slips, float),
        "wall_gap": np.array(
            [[gap_of(run.run, row, wall) for wall in walls] for row in log], float
        ),
    }
    dims = {
        "wall_force": ("time", "wall", "xy"),
        "wall_point": ("wall", "xy"), "wall_normal": ("wall", "xy"),
    }  # fmt: skip
    fixed = run.movers[1:]
    values["wall_point"] = np.array([wall.start for wall in fixed])
    values["wall_normal"] = np.array([wall.normal for wall in fixed], float)
    variables = {}
    for name, numbers in values.items():
        attributes = with_units(quantities.attributes(quantities.WALLS, name), units)
        if name == "wall_mode":
            attributes |= flag_attributes(FLAGS["mode"])
        variables[name] = xr.Variable(dims.get(name, ("time", "wall")), numbers, attributes)
    return variables
