"""A motion from event to event: extrapolation within a phase, and Newton's method to the end of it.

The integrator is Gragg's method with extrapolation (Hairer, Norsett and Wanner I, Sec. II.9). Numbers are
midpoints of balls; nothing is validated.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import count, islice, pairwise
from typing import NamedTuple

from flint import arb, fmpq

from pulling_by_pushing.oracle.balls import Undecided, Vector
from pulling_by_pushing.oracle.logs.phases import (
    SLIP_ENDS,
    STOPS,
    TOUCHES,
    Margins,
    Massive,
    Phase,
    PhaseMotion,
    Slider,
    State,
    line,
)
from pulling_by_pushing.oracle.modes import Mode

Point = tuple[arb, ...]
Rates = Callable[[Point], Point]
#: A stored instant this close to an event, as a fraction of the last time, is that of the event.
NEAR_EVENT = fmpq(1, 10**8)
#: Longest step, and the time after an event at which modes are listed, as fractions of the duration.
LONGEST_STEP, MODE_DELAY = fmpq(1, 16), fmpq(1, 2**24)
#: Maximum number of halvings of a step, and of Newton steps to an event.
STEP_HALVINGS, EVENT_STEPS = 64, 40
#: Step of a difference quotient, accuracy of an event, and rounding, as fractions of the duration.
DIFFERENCE_STEP, EVENT_ACCURACY, TIME_NOISE = (arb(2) ** -power for power in (56, 100, 110))
#: Unit steps in the logarithm of the speed after which a motion has decayed to zero to all digits.
DECAYS = 64
#: The mode that a policy prefers; then sticking precedes slip, and separation comes last.
PREFERRED_MODE = {
    "keep-contact": Mode.STICK,
    "separate": Mode.SEPARATE,
    "stick": Mode.STICK,
    "slip-right": Mode.SLIP_RIGHT,
    "slip-left": Mode.SLIP_LEFT,
}
MODE_ORDER = Mode.STICK, Mode.SLIP_RIGHT, Mode.SLIP_LEFT, Mode.SEPARATE


class Scheme(NamedTuple):
    """Maximum number of rows of extrapolation, half the order, and tolerance."""

    rows: int
    tolerance: arb


def _extrapolate(rates: Rates, start: Point, step: arb) -> Iterator[Point]:
    """The point after a step by methods of order 2, 4, 6, and so on."""
    slope, row = rates(start), list[Point]()
    for j in count(1):
        above, row = row, [_midpoint(rates, start, slope, step, 2 * j)]
        for i, coarser in enumerate(above, start=1):
            factor = arb(fmpq(j * j, (j - i) * (j - i)) - 1)
            row.append(line(row[-1], line(row[-1], coarser, -1), 1 / factor))
        yield row[-1]


def _midpoint(rates: Rates, start: Point, slope: Point, step: arb, parts: int) -> Point:
    """The point after a number of steps of the midpoint rule, the first of which is an Euler step."""
    size = (step / parts).mid()
    before, after = start, line(start, slope, size)
    for _ in range(parts - 1):
        before, after = after, line(before, rates(after), 2 * size)
    return after


def _step(rates: Rates, start: Point, step: arb, scheme: Scheme) -> Point | None:
    """The point after a step, or None if the extrapolation does not converge."""
    if step == 0:
        return start
    try:
        for before, after in pairwise(islice(_extrapolate(rates, start, step), scheme.rows)):
            differences = (abs(a - b) for a, b in zip(before, after, strict=True))
            if all(part < scheme.tolerance for part in differences):
                return after
    except Undecided:
        pass
    return None


def _advance(
    rates: Rates, start: Point, step: arb, scheme: Scheme, halvings: int = STEP_HALVINGS
) -> Point:
    """The point after a step, in as many parts as it requires."""
    after = _step(rates, start, step, scheme)
    if after is None:
        if halvings == 0:
            raise Undecided("the extrapolation does not converge: the motion is not smooth")
        half = (step / 2).mid()
        middle = _advance(rates, start, half, scheme, halvings - 1)
        after = _advance(rates, middle, half, scheme, halvings - 1)
    return after


def _most_negative(margins: Margins) -> int | None:
    values = [float(margin) for _, margin in margins]
    return values.index(min(values)) if values and min(values) < 0 else None


def _find_event(
    rates: Rates,
    margins: Callable[[Point], Margins],
    end: Point,
    step: arb,
    unit: arb,
    scheme: Scheme,
) -> tuple[int, Point] | None:
    """The event of the most negative margin at the end of a step, and the point at which it vanishes.

    None if Newton's method leaves the step, the margin does not fall from positive to negative, or another
    one is negative. `unit` is that of the step.
    """
    index = _most_negative(margins(end))
    assert index is not None

    def margin(point: Point, ahead: arb) -> arb:
        return margins(_advance(rates, point, (ahead * unit).mid(), scheme))[index][1]

    point, shift = end, arb(0)
    for _ in range(EVENT_STEPS):
        value = margins(point)[index][1]
        change = (-value * DIFFERENCE_STEP / (margin(point, DIFFERENCE_STEP) - value)).mid()
        shift += change
        if not -2 * step < shift * unit < step:
            return None
        point = _advance(rates, point, (change * unit).mid(), scheme)
        if abs(change) < EVENT_ACCURACY:
            others = (value for i, (_, value) in enumerate(margins(point)) if i != index)
            falls = margin(point, -16 * EVENT_ACCURACY) > 0 > margin(point, 16 * EVENT_ACCURACY)
            inside = -step - EVENT_ACCURACY * unit < shift * unit < EVENT_ACCURACY * unit
            if falls and inside and all(value > -TIME_NOISE for value in others):
                return margins(point)[index][0], point
            return None
    return None


class Piece(NamedTuple):
    """A constant velocity of the fence from a time to another one."""

    start: fmpq
    end: fmpq
    velocity: Vector


class Instant(NamedTuple):
    """State, phase and motion at a stored instant; number of consistent modes; event or -1; its time."""

    state: State
    phase: Phase
    motion: PhaseMotion
    solutions: int
    event: int
    time: arb


@dataclass
class Course:
    """A motion through the phases that a policy selects.

    Attributes
    ----------
    times : list of fmpq
        The stored instants.
    state, phase : State, Phase
        The present ones.
    rest : State or None
        The state at the end of the phase in which the slider comes to rest, once that is near.
    """

    slider: Slider
    pieces: list[Piece]
    times: list[fmpq]
    policy: str
    scheme: Scheme
    state: State
    phase: Phase = field(init=False)
    rest: State | None = None
    instants: dict[int, Instant] = field(default_factory=dict)

    @property
    def duration(self) -> fmpq:
        """Time at which the last piece of the fence's motion ends."""
        return self.pieces[-1].end

    def follow(self) -> list[Instant]:
        """The motion at all stored instants; at the start of a piece it is that just afterwards."""
        last, before = self.times[-1], self.pieces[0].velocity
        for piece in self.pieces:
            final = piece is self.pieces[-1]
            if piece.start > last:
                break
            self._enter(piece, before)
            for i, time in enumerate(self.times):
                if piece.start <= time < piece.end or (final and time == piece.end):
                    self._reach(time)
                    if i not in self.instants:
                        count = len(self.slider.phases(self.state, piece.velocity))
                        self.instants[i] = self._instant(self.state, count)
            self._reach(
                min(piece.end, last * (1 + NEAR_EVENT))
            )  # an event can be just after the last instant
            before = piece.velocity
        return [self.instants[i] for i in range(len(self.times))]

    def _enter(self, piece: Piece, before: Vector) -> None:
        """Begin a piece of the fence's motion; a jump of its velocity is an impact on a mass in contact."""
        state, fence = self.state, piece.velocity
        if isinstance(self.slider, Massive):
            jump = line(before, fence, -1)
            slip_rate, gap_rate = line((state.along_rate, state.gap_rate), jump, 1)
            state = state._replace(along_rate=slip_rate, gap_rate=gap_rate)
            if state.gap == 0 and not (slip_rate == 0 and gap_rate == 0):
                state = self.slider.impact(state, fence, self._choose)
        self._begin(self.slider.phases(state, fence), state)

    def _begin(self, phases: list[Phase], state: State) -> None:
        self.phase, self.state, self.rest = self._preferred_phase(phases), state, None

    def _preferred_phase(self, phases: list[Phase]) -> Phase:
        mode = self._choose([phase.mode for phase in phases])
        return next(phase for phase in phases if phase.mode is mode)

    def _choose(self, modes: list[Mode]) -> Mode:
        """The mode that the policy selects."""
        if not modes:
            raise Undecided("no contact mode is consistent")
        return next(mode for mode in [PREFERRED_MODE[self.policy], *MODE_ORDER] if mode in modes)

    def _rates(self, state: Point) -> State:
        return self.slider.rates(State(*state), self.phase)

    def _margins(self, state: Point) -> Margins:
        return self.slider.move(State(*state), self.phase).margins

    def _state_after(self, state: State, step: arb) -> State:
        return State(*_advance(self._rates, state, step.mid(), self.scheme))

    def _instant(
        self, state: State, solutions: int, event: int = -1, time: arb | None = None
    ) -> Instant:
        motion = self.slider.move(state, self.phase)
        return Instant(
            state, self.phase, motion, solutions, event, state.time if time is None else time
        )

    def _reach(self, time: fmpq) -> None:
        """Integrate to a time, through the events before it."""
        unit = arb(self.duration)
        longest = (LONGEST_STEP * unit).mid()
        size = longest
        while (remaining := (time - self.state.time).mid()) > 0:
            self.rest = self.rest or self._look_for_rest(size)
            if self.rest is not None and self.rest.time < time + NEAR_EVENT * self.times[-1]:
                self._change(STOPS, self.rest)
                continue
            step = remaining if remaining < size + TIME_NOISE * unit else size
            after = _step(self._rates, self.state, step, self.scheme)
            if after is not None and _most_negative(self._margins(after)) is None:
                self.state = State(*after)
                if step is remaining:
                    self.state = self.state._replace(time=arb(time))
                if self.state.gap == 0 and not self.state.angle.sin() > 0:
                    raise Undecided("the slider's center reaches the fence")
                size = arb.min(longest, 2 * size).mid()
                continue
            event = None
            if after is not None:
                event = _find_event(self._rates, self._margins, after, step, unit, self.scheme)
            if event is not None:
                self._change(event[0], State(*event[1]))
                size = longest
                continue
            size = (step / 2).mid()
            if size < longest / 2**STEP_HALVINGS:
                raise Undecided(f"the motion is not smooth at the time {float(self.state.time)}")

    def _change(self, event: int, state: State) -> None:
        """Begin the phase after an event, and store the instant next to it.

        It is consistent a moment later, where the margin of the phase that ends is negative, unless the
        velocity jumps at the event.
        """
        slider, fence, last = self.slider, self.phase.fence, self.times[-1]
        near = [
            i for i, time in enumerate(self.times) if abs(time - state.time) < NEAR_EVENT * last
        ]
        if len(near) != 1:
            time = float(state.time)
            raise Undecided(f"{len(near)} stored instants are next to the event at {time}")
        later = None
        if event == TOUCHES:
            state = later = state._replace(gap=arb(0))
        if isinstance(slider, Massive):
            if event == TOUCHES:
                state = later = slider.impact(state, fence, self._choose)
            elif event == SLIP_ENDS:
                state = later = state._replace(along_rate=arb(0))
            elif event == STOPS:
                later = state
        phases = slider.phases(
            later or self._state_after(state, arb(MODE_DELAY * self.duration)), fence
        )
        self._begin(phases, state)
        stored = self._state_after(state, self.times[near[0]] - state.time)
        if event == TOUCHES:
            stored = stored._replace(gap=arb(0))
        self.instants[near[0]] = self._instant(stored, len(phases), event, state.time)

    def _look_for_rest(self, step: arb) -> State | None:
        """The state in which a motion near its end decays to rest, or None.

        The logarithm of the speed is the variable: in it, the direction of the motion converges. The slip
        can end shortly before the rest; both events then have one stored instant.
        """
        slider, phase, fence, start = self.slider, self.phase, self.phase.fence, self.state
        stands = fence[0] == fence[1] == 0 or phase.mode is Mode.SEPARATE
        if not isinstance(slider, Massive) or slider.body is None or not stands:
            return None

        def pace(state: State, rates: State) -> arb:
            """Rate of the logarithm of the speed."""
            energy = slider.energy(state.angle, slider.velocity(state, fence), state.spin)
            return (
                (rates.support_loss + rates.contact_loss - rates.work) / (2 * energy)
                if energy > 0
                else arb(0)
            )

        def time_to_rest(state: State) -> arb:
            """Time to the rest if the speed decreases in proportion to it."""
            return (1 / pace(state, slider.rates(state, phase))).mid()

        def physical(z: Point) -> State:
            """The state of a point whose velocities are relative to the table and over the speed."""
            u, v, spin = ((-z[-1]).exp() * part for part in z[3:6])
            point: Point = *z[:3], *line((u, v), fence, -1), spin, *z[6:-1]
            return State(*point)

        def rates(z: Point) -> Point:
            by_time, size = slider.rates(physical(z), phase), z[-1].exp()
            speed = pace(physical(z), by_time)
            if not speed > 0:
                raise Undecided("the speed does not decrease while the motion decays")
            changes = (a * size / speed + b for a, b in zip(by_time[3:6], z[3:6], strict=True))
            before, after = ([a / speed for a in part] for part in (by_time[:3], by_time[6:]))
            return *before, *changes, *after, arb(1)

        def margins(z: Point) -> Margins:
            signs = slider.move(physical(z), phase).margins
            return tuple((event, margin * z[-1].exp()) for event, margin in signs)

        if not time_to_rest(start) < 4 * step:
            return None
        z: Point = *start[:3], *slider.velocity(start, fence), *start[5:], arb(0)
        while z[-1] < DECAYS:
            after = _advance(rates, z, arb(1), self.scheme)
            if _most_negative(margins(after)) is not None:
                if not time_to_rest(physical(z)) < NEAR_EVENT * self.times[-1]:
                    return None
                slip_end = _find_event(rates, margins, after, arb(1), arb(1), self.scheme)
                if slip_end is None or slip_end[0] != SLIP_ENDS:
                    raise Undecided("the contact changes while the motion decays")
                after = *slip_end[1][:3], fence[0], *slip_end[1][4:]
                phase = self._preferred_phase(slider.phases(physical(after), fence))
            z = after
        last = physical(z)
        time = (last.time + time_to_rest(last)).mid()
        return State(*last[:3], -fence[0], -fence[1], arb(0), *last[6:-1], time)
