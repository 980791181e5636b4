"""The course of many quasi-static scenes: step, locate the end of a mode, choose the next one.

Under a constant fence velocity the rotation is a continuous function of the rod angle alone. A lane thus
never turns back, a mode ends at an angle, and the time to get there is an integral over the angle.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from planar_pushing.mechanics import response
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.mechanics.options import Policy
from planar_pushing.mechanics.plane import Array
from planar_pushing.simulation import lockstep
from planar_pushing.simulation.lanes import (
    Index,
    Lanes,
    Motion,
    first_share,
    slipping,
    sticking,
)

#: The mode that follows is chosen this far (radians) past the end of the last one, where margins are
#: larger than what rounding leaves of them.
AHEAD, RESOLVED = 1e-7, 1e-12
#: Past a kink the motion centre is this far off the ring, and where it only touches the ring it stays on
#: the outside: there its distance is smaller than what the solver leaves of it.
LOOK, TOUCHING = 1e-4, 1e-7
#: Weight of the kink's margin: less than a millionth past it the motion is smooth enough, and a
#: motion centre that only touches the ring makes no events.
KINK = 1e-4
#: More steps or changes of mode than any smooth course takes.
LIMIT = 10_000
NO_MODE = -1
Modes = npt.NDArray[np.int64]
Found = npt.NDArray[np.bool_]
CONTACT = (ContactMode.STICK, ContactMode.SLIP_RIGHT, ContactMode.SLIP_LEFT)
PREFERENCES: dict[str, tuple[ContactMode, ...]] = {
    Policy.KEEP_CONTACT: (*CONTACT, ContactMode.SEPARATE),
    Policy.STAY_IN_MODE: (*CONTACT, ContactMode.SEPARATE),
    Policy.SEPARATE: (ContactMode.SEPARATE, *CONTACT),
}


@dataclass(slots=True)
class Course:
    """Where each lane is; arrays of shape (lanes,), advanced in place by `run`.

    Attributes
    ----------
    time, angle, slip : ndarray
        Slip is accumulated over the contact's duration, in radii.
    contact_time : ndarray
        How long the contact has lasted.
    mode : ndarray of int
        Values of `ContactMode`, or `NO_MODE` where no mode is consistent.
    choices : ndarray of int
        Number of modes that were consistent when the mode was chosen.
    changes, evaluations : ndarray of int
    lies : ndarray of bool
        Whether the ring's centre has come down to the fence, where a lane stays.
    """

    lanes: Lanes
    preference: tuple[ContactMode, ...]
    rtol: float
    angle: Array
    time: Array = field(init=False)
    slip: Array = field(init=False)
    contact_time: Array = field(init=False)
    size: Array = field(init=False)
    guesses: dict[ContactMode, Array] = field(init=False)
    inner: Array = field(init=False)
    inside: Array = field(init=False)
    beyond: Array = field(init=False)
    ended: Found = field(init=False)
    lies: Found = field(init=False)
    mode: Modes = field(init=False)
    choices: Modes = field(init=False)
    changes: Modes = field(init=False)
    evaluations: Modes = field(init=False)

    def __post_init__(self) -> None:
        count = len(self.angle)
        self.time, self.slip, self.contact_time = np.zeros((3, count))
        self.inner, self.inside, self.beyond = np.zeros((3, count))
        self.ended, self.lies = np.zeros((2, count), dtype=bool)
        self.mode, self.choices, self.changes, self.evaluations = np.zeros((4, count), dtype=int)
        self.guesses = {mode: np.full(count, 0.5) for mode in CONTACT}
        self.guesses[ContactMode.STICK] = first_share(self.lanes.length)
        self._choose(np.arange(count), self.angle, np.zeros(count))
        speed = self.lanes.speed
        self.size = 0.1 * np.maximum(1.0, self.lanes.length) / np.where(speed > 0, speed, 1.0)

    def motion(self, index: Index, mode: ContactMode, angle: Array) -> Motion:
        """Motion of some lanes in one mode, which ends where the ring's centre comes down."""
        lanes = self.lanes.take(index)
        guess = self.guesses[mode][index]
        if mode is ContactMode.STICK:
            motion, found = sticking(lanes, angle, guess)
        else:
            motion, found = slipping(lanes, angle, mode, guess)
        self.guesses[mode][index] = found
        return motion._replace(margin=np.minimum(motion.margin, np.sin(angle)))

    def _smooth(self, index: Index, mode: ContactMode, angle: Array) -> Motion:
        """The same; the margin also ends where the motion centre crosses the ring, which is a kink."""
        motion = self.motion(index, mode, angle)
        kink = KINK * (self.inner[index] * motion.inner + TOUCHING)
        return motion._replace(margin=np.minimum(motion.margin, kink))

    def _consistent(self, index: Index, angle: Array) -> Found:
        """Whether each of the modes in order of preference is consistent; shape (modes, lanes)."""
        lanes = self.lanes.take(index)
        self.evaluations[index] += len(CONTACT)
        tests = {ContactMode.SEPARATE: lanes.pusher[:, 1] <= 0}
        for mode in CONTACT:
            here = np.nonzero(lanes.speed > 0)[0]
            margin = np.full(len(index), -np.inf)
            margin[here] = self.motion(index[here], mode, angle[here]).margin
            tests[mode] = margin > (-RESOLVED if mode is ContactMode.STICK else RESOLVED)
        return np.stack([tests[mode] for mode in self.preference])

    def _choose(self, index: Index, angle: Array, look: Array) -> None:
        """Give each lane the first consistent mode in the order of preference.

        On which side of the ring its motion centre is, is seen at a distance `look` from the angle.
        """
        consistent = self._consistent(index, angle)
        first = np.array(self.preference)[np.argmax(consistent, axis=0)]
        self.choices[index] = consistent.sum(axis=0)
        self.mode[index] = np.where(consistent.any(axis=0), first, NO_MODE)
        for mode in CONTACT:
            here = np.nonzero(self.mode[index] == mode)[0]
            if len(here):
                inner = self.motion(index[here], mode, angle[here] + look[here]).inner
                self.inner[index[here]] = np.where(inner < -TOUCHING, -1.0, 1.0)

    def run(self, until: Array) -> None:
        """Advance every lane to its own time; where no mode is consistent it stays behind."""
        for _ in range(LIMIT):
            late = (self.time < until) & ~self.lies
            rest = late & (self.mode == ContactMode.SEPARATE)
            self.time[rest] = until[rest]
            lasting = [
                (mode, np.nonzero(late & ~self.ended & (self.mode == mode))[0]) for mode in CONTACT
            ]
            for mode, index in lasting:
                if len(index):
                    self._advance(index, mode, until[index])
            if not any(len(index) for _, index in lasting):
                if not self.ended.any():
                    return
                self._end_modes()
        raise AssertionError(f"more than {LIMIT} steps")

    def _advance(self, index: Index, mode: ContactMode, until: Array) -> None:
        """One trial step of the lanes that are in a mode."""
        left = until - self.time[index]
        last = self.size[index] >= left
        size = np.where(last, left, self.size[index])
        step = lockstep.trial(
            lambda angle: self._smooth(index, mode, angle), self.angle[index], size, self.rtol
        )
        self.evaluations[index] += len(step.angles)
        proposed = lockstep.next_size(size, step.error)
        accepted = step.error <= 1
        self.size[index] = np.where(
            accepted & last, np.maximum(proposed, self.size[index]), proposed
        )
        ended = accepted & (step.margins[1:] < -lockstep.SLACK).any(axis=0)
        done = accepted & ~ended
        self._move(index[done], step.angle[done], size[done], step.slip[done])
        self.time[index[done & last]] = until[done & last]
        self.ended[index] = ended
        self.inside[index], self.beyond[index] = lockstep.bracket(step)

    def _move(self, index: Index, angle: Array, time: Array, slip: Array) -> None:
        self.angle[index] = angle
        self.time[index] += time
        self.contact_time[index] += time
        self.slip[index] += slip

    def _end_modes(self) -> None:
        """Change the mode of every lane whose mode has ended; waiting for all keeps the arrays long."""
        groups = [(mode, np.nonzero(self.ended & (self.mode == mode))[0]) for mode in CONTACT]
        for mode, index in groups:
            if len(index):
                self._end_mode(index, mode)
        self.ended[:] = False

    def _end_mode(self, index: Index, mode: ContactMode) -> None:
        """Take each lane to the angle where its margin vanishes, and choose the mode that follows."""
        start, inside, beyond = self.angle[index], self.inside[index], self.beyond[index]
        # At its start the margin is zero; the mode was chosen this far ahead.
        ahead = start + np.clip(beyond - start, -AHEAD, AHEAD)
        inside = np.where(inside == start, ahead, inside)

        def excess(part: Array, row: Array) -> Array:
            lane = row.astype(int)
            angle = inside[lane] + part * (beyond[lane] - inside[lane])
            return -self._smooth(index[lane], mode, angle).margin

        rows = np.arange(len(index), dtype=float)
        part = response.root(excess, np.zeros(len(index)), np.ones(len(index)), (rows,))
        angle = inside + part * (beyond - inside)
        time, slip = lockstep.passage(lambda a: self._smooth(index, mode, a), start, angle)
        self._move(index, angle, time, slip)
        self.evaluations[index] += len(lockstep.NODES)
        way = np.sign(beyond - inside)
        self.lies[index] = np.sin(angle + AHEAD * way) < 0
        stands = ~self.lies[index]
        index, ahead, look = index[stands], (angle + AHEAD * way)[stands], (LOOK * way)[stands]
        before = self.mode[index]
        self._choose(index, ahead, look)
        self.changes[index] += self.mode[index] != before
