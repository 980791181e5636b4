"""Motion over time with friction alone: it follows from the rod angle, also where the slider pivots."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from flint import arb, arb_mat, ctx

from pulling_by_pushing.oracle.balls import Undecided, Vector, cross, dot, sign
from pulling_by_pushing.oracle.body import Body, Matrix, Row
from pulling_by_pushing.oracle.exact import ring_radius
from pulling_by_pushing.oracle.logs.phases import (
    KINK,
    LEAVES_CONE,
    NO_FOOT,
    SENSE,
    SLIP_ENDS,
    STRAIGHT,
    TOUCHES,
    ZERO_VECTOR,
    Margins,
    Phase,
    PhaseMotion,
    Slider,
    State,
    turn,
)
from pulling_by_pushing.oracle.modes import Mode

#: Maximum number of Newton steps; halvings and bits in the search for a first guess.
SLIDING_STEPS, SEEK_HALVINGS, SEEK_BITS = 16, 40, 64
System = Callable[[Row], tuple[Row, Matrix]]


def newton(system: System, guess: Row) -> Row:
    """The root of a smooth system, which returns its values and its Jacobian, next to a guess.

    Raises
    ------
    Undecided
        If Newton's method does not converge.
    """
    root, close = guess, arb(2) ** (2 - ctx.prec // 2)
    for _ in range(SLIDING_STEPS):
        values, slopes = system(root)
        matrix = arb_mat([[part.mid() for part in row] for row in slopes])
        try:
            step = matrix.solve(arb_mat([[part.mid()] for part in values]))
        except ZeroDivisionError:
            raise Undecided("the equations of a motion are singular") from None
        size = max(abs(part) for part in root)
        root = [(part - step[i, 0]).mid() for i, part in enumerate(root)]
        if all(abs(step[i, 0]) < close * size for i in range(len(root))):
            return root
    raise Undecided("the equations of a motion are not solved")


class Ray(NamedTuple):
    """Motion under a force along an edge of the friction cone.

    Attributes
    ----------
    contact : tuple of arb
        Velocity of the contact, whose component along the edge is 1.
    spin, force : arb
        Rotation, and size of the force.
    margin : arb
        A number that is positive while a pivot lasts, or until the motion becomes one.
    foot : int
    """

    contact: Vector
    spin: arb
    force: arb
    margin: arb
    foot: int = NO_FOOT


@dataclass(frozen=True, eq=False, kw_only=True)
class Sliding(Slider):
    """A slider that only friction resists.

    Attributes
    ----------
    guesses : dict
        The last solution for each mode, with the index of the nearest foot.
    """

    body: Body
    guesses: dict[Mode, tuple[int, Row]] = field(default_factory=dict)

    def move(self, state: State, phase: Phase) -> PhaseMotion:
        fence, mode, foot, side = phase
        if mode is Mode.SEPARATE:
            return PhaseMotion(
                ZERO_VECTOR,
                ZERO_VECTOR,
                arb(0),
                arb(0),
                ((TOUCHES, state.gap),) if fence[1] > 0 else (),
            )
        if mode is Mode.STICK:
            spin, force = self._stick(state.angle, fence)
            low, high = self.cone(force)
            margins: Margins = (LEAVES_CONE, low), (LEAVES_CONE, high)
            if side:
                margins = (*margins, (KINK, side * self._center_outside(state.angle, fence, spin)))
            return PhaseMotion(fence, force, spin, dot(force, fence), margins)
        ray, (x, y) = self._ray(state.angle, mode, foot), self.edge(mode)
        scale = fence[1] / ray.contact[1]
        contact, force = ((scale * ray.contact[0]).mid(), fence[1]), (ray.force * x, ray.force * y)
        slip_rate = SENSE[mode] * (contact[0] - fence[0])
        margins = (KINK, ray.margin), (SLIP_ENDS, slip_rate)
        return PhaseMotion(contact, force, (scale * ray.spin).mid(), dot(force, contact), margins)

    def phases(self, state: State, fence: Vector) -> list[Phase]:
        if state.gap > 0:
            return [Phase(fence, Mode.SEPARATE)]
        if fence[0] == fence[1] == 0:
            raise Undecided("a fence at rest is not supported with friction alone")
        left, right = (self.ray(state.angle, mode) for mode in (Mode.SLIP_RIGHT, Mode.SLIP_LEFT))
        from_right, from_left = sign(cross(right.contact, fence)), sign(cross(left.contact, fence))
        approach = sign(fence[1])
        phases = [] if approach > 0 else [Phase(fence, Mode.SEPARATE)]
        if from_right > 0 > from_left:
            spin, _ = self._stick(state.angle, fence)
            side = sign(self._center_outside(state.angle, fence, spin))
            phases.append(Phase(fence, Mode.STICK, side=side))
        if approach and sign(left.contact[1]) == approach == from_left:
            phases.append(Phase(fence, Mode.SLIP_RIGHT, left.foot))
        if approach and sign(right.contact[1]) == approach == -from_right:
            phases.append(Phase(fence, Mode.SLIP_LEFT, right.foot))
        return phases

    def _center_outside(self, angle: arb, contact: Vector, spin: arb) -> arb:
        """A number that is positive while the motion center is outside a ring; 0 for other supports."""
        radius, rod = ring_radius(self.body), self.rod(angle)
        if radius is None:
            return arb(0)
        x, y = contact[0] - spin * rod[1], contact[1] + spin * rod[0]
        return (x * x + y * y - (radius * spin) ** 2).mid()

    @property
    def _feet(self) -> range:
        """Indices of the points of the support."""
        assert self.body.support is not None
        return range(len(self.body.support.points))

    def ray(self, angle: arb, mode: Mode) -> Ray:
        """Motion under the force of a slip, about a foot if one can carry what this requires."""
        e_rod = turn(self.edge(mode), -angle)
        for foot in self._feet:
            ray = self._pivot(angle, e_rod, foot)
            if ray.margin > 0:
                return ray
        try:
            ray = self._ray(angle, mode, NO_FOOT)
            solved = bool(ray.margin > 0)
        except Undecided:
            solved = False
        if not solved:
            self.guesses[mode] = self._nearest_foot(self._seek(e_rod))
            ray = self._ray(angle, mode, NO_FOOT)
        self.guesses[mode] = self._nearest_foot(self._lift(*self.guesses[mode])[0])
        return ray

    def _stick(self, angle: arb, fence: Vector) -> tuple[arb, Vector]:
        """Rotation and force if the contact moves as the fence does."""
        u_rod = turn(fence, -angle)

        def system(z: Row) -> tuple[Row, Matrix]:
            value, slopes = self.wrench([*u_rod, z[0]])
            return [value[2]], [[slopes[2][2]]]

        try:
            (spin,) = newton(system, self.guesses[Mode.STICK][1])
        except (KeyError, Undecided):
            (spin,) = newton(system, [self._turn(u_rod)])
        self.guesses[Mode.STICK] = NO_FOOT, [spin]
        return spin, turn(self.wrench([*u_rod, spin])[0][:2], angle)

    def _turn(self, u_rod: Vector) -> arb:
        """The rotation without a torque, to some digits; the torque increases with the rotation."""

        def torque(spin: arb) -> arb:
            return self.wrench([*u_rod, spin])[0][2]

        with ctx.workprec(SEEK_BITS):
            low, high = arb(-1.1), arb(1.3)  # halvings then avoid symmetric motions about a foot
            while torque(low) > 0:
                low *= 2
            while torque(high) < 0:
                high *= 2
            for _ in range(SEEK_HALVINGS):
                middle = (low + high) / 2
                low, high = (middle, high) if torque(middle) < 0 else (low, middle)
            return ((low + high) / 2).mid()

    def _seek(self, e_rod: Vector) -> Row:
        """The motion under a force along an edge, to some digits; the force turns with the motion."""
        with ctx.workprec(SEEK_BITS):
            low, high = -arb.pi() / 2, arb.pi() / 2
            for _ in range(SEEK_HALVINGS):
                middle = (low + high) / 2
                u = turn(e_rod, middle)
                q = [*u, self._turn(u)]
                is_behind = cross(e_rod, self.wrench(q)[0]) < 0
                low, high = (middle, high) if is_behind else (low, middle)
            along = dot(u, e_rod)
            return [(part / along).mid() for part in q]

    def _pivot(self, angle: arb, e_rod: Vector, foot: int) -> Ray:
        """The motion about a foot, whose force leaves no torque, and no force across the edge."""
        arm, share = self.body.foot(foot), self.body.share(foot)
        lever = cross(e_rod, arm)
        spin = (1 / lever).mid()
        u_rod = (spin * arm[1]).mid(), (-spin * arm[0]).mid()
        x, y, torque = self.wrench([*u_rod, spin], foot)[0]
        across = cross(e_rod, (x, y))
        h = [(torque * e - across * r) / lever for e, r in zip(e_rod, arm, strict=True)]
        size = dot(e_rod, (x + h[0], y + h[1]))
        margin = 1 - dot(h, h) / share**2
        return Ray(turn(u_rod, angle), spin, size.mid(), margin.mid(), foot)

    def _ray(self, angle: arb, mode: Mode, foot: int) -> Ray:
        """The pivot about a foot, or the motion next to the last one."""
        e_rod = turn(self.edge(mode), -angle)
        if foot != NO_FOOT:
            return self._pivot(angle, e_rod, foot)
        if mode not in self.guesses:
            self.guesses[mode] = self._nearest_foot(self._seek(e_rod))
        nearest, guess = self.guesses[mode]

        def system(z: Row) -> tuple[Row, Matrix]:
            q, slopes, foot_force, rate = self._lift(nearest, z)
            value, response = self.wrench(q, nearest)
            force = [a + b for a, b in zip(value, foot_force, strict=True)]
            by_z = [[dot(row, column) for column in zip(*slopes, strict=True)] for row in response]
            for row, part in zip(by_z, rate, strict=True):
                row[1] += part
            across = [cross(e_rod, column) for column in zip(by_z[0], by_z[1], strict=True)]
            along = [dot(e_rod, column) for column in zip(slopes[0], slopes[1], strict=True)]
            values = [dot(e_rod, q[:2]) - 1, force[2], cross(e_rod, force)]
            return values, [along, by_z[2], across]

        z = newton(system, guess)
        self.guesses[mode] = nearest, z
        q, _, foot_force, _ = self._lift(nearest, z)
        value = self.wrench(q, nearest)[0]
        size = dot(e_rod, (value[0] + foot_force[0], value[1] + foot_force[1]))
        return Ray(turn(q[:2], angle), q[2], size.mid(), arb(1) if nearest == NO_FOOT else z[0])

    def _nearest_foot(self, q: Sequence[arb]) -> tuple[int, Row]:
        """The nearest foot, its speed and direction, and the rotation; without feet the motion itself."""

        def velocity(foot: int) -> Vector:
            x, y = self.body.foot(foot)
            return q[0] - q[2] * y, q[1] + q[2] * x

        if not self._feet or abs(q[2]) < STRAIGHT:
            return NO_FOOT, list(q)
        nearest = min(self._feet, key=lambda foot: float(dot(velocity(foot), velocity(foot)).mid()))
        x, y = velocity(nearest)
        return nearest, [dot((x, y), (x, y)).sqrt().mid(), arb.atan2(y, x).mid(), q[2]]

    def _lift(self, nearest: int, z: Row) -> tuple[Row, Matrix, Row, Row]:
        """The motion and its Jacobian, and the force on the nearest foot with its rate by the direction.

        The force has that direction also where the speed is negative, so that the equations remain smooth
        while the center of rotation passes the foot.
        """
        if nearest == NO_FOOT:
            unit = [[arb(i == k) for k in range(3)] for i in range(3)]
            return z, unit, [arb(0)] * 3, [arb(0)] * 3
        speed, direction, spin = z
        (x, y), share, (s, c) = (
            self.body.foot(nearest),
            self.body.share(nearest),
            direction.sin_cos(),
        )
        q = [(speed * c + spin * y).mid(), (speed * s - spin * x).mid(), spin]
        slopes = [[c, -speed * s, arb(y)], [s, speed * c, arb(-x)], [arb(0), arb(0), arb(1)]]
        force, rate = [c, s, x * s - y * c], [-s, c, x * c + y * s]
        return q, slopes, [share * part for part in force], [share * part for part in rate]
