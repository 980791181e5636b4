"""Means over the pieces of a pressure: points, lines, rings, discs, and areas between straight edges."""

from __future__ import annotations

from math import sqrt

from planar_pushing.simulation.legacy.compiled import compiled, inlined
from planar_pushing.simulation.legacy.edges import LEAST, ends, mean_distance, mean_inverse
from planar_pushing.simulation.legacy.multipole import far
from planar_pushing.simulation.legacy.pressure import ATOMS, DISCS, EDGES, PLATES, RINGS, SEGMENTS
from planar_pushing.simulation.legacy.ring import polynomial, ring_wrench

NOTHING = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def added(total, share, piece, arm_x, arm_y):
    """Add a piece to the totals; `arm` is its center relative to the point of the total torque."""
    distance, unit_x, unit_y, torque, xx, xy, yy = piece
    return (
        total[0] + share * distance,
        total[1] + share * unit_x,
        total[2] + share * unit_y,
        total[3] + share * (torque + (arm_x * unit_x + arm_y * unit_y)),
        total[4] + share * xx,
        total[5] + share * xy,
        total[6] + share * yy,
    )


@compiled
def turned(x, y, distance, slope, torque, along, across):
    """A piece symmetric about its center, from D and its derivatives along the radius to (x, y).

    `along` is the second radial derivative of D, and `across` the first one divided by the distance.
    """
    far = sqrt(x * x + y * y)
    u_x, u_y = (x / far, y / far) if far > 0.0 else (0.0, 0.0)
    bend = along - across
    xx, xy, yy = across + bend * u_x * u_x, bend * u_x * u_y, across + bend * u_y * u_y
    return distance, -slope * u_x, -slope * u_y, torque, xx, xy, yy


#: Beyond this distance, in radii of the plate, `multipole.far` is used.
FAR = 1.7


@compiled
def near(edges, begin, stop, x, y):
    """The piece of a plate with edges `begin` to `stop`; (x, y) is relative to the plate's center."""
    distance, g_x, g_y, xx, xy, yy = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(begin, stop):
        m_x, m_y, t_x = edges[i, 0], edges[i, 1], edges[i, 2]
        t_y, half, jump = edges[i, 3], edges[i, 4], edges[i, 5]
        r_x, r_y, weight = m_x - x, m_y - y, 2.0 * half * jump
        mean, h, along, across = _edge(r_x * t_x + r_y * t_y, r_x * t_y - r_y * t_x, half)
        distance += weight * h * mean / 3.0
        g_x += weight * mean * t_y
        g_y -= weight * mean * t_x
        xx += weight * t_y * (across * t_y + along * t_x)
        xy += weight * t_y * (along * t_y - across * t_x)
        yy += weight * t_x * (across * t_x - along * t_y)
    return distance, g_x, g_y, distance + (x * g_x + y * g_y), xx, xy, yy


@compiled
def _edge(s, h, half):
    """Mean distance to an edge, h, and the means of r' / rho along and across it."""
    one, other = ends(s, h, half)
    both = one + other
    inverse = mean_inverse(s, h, half, one, other)
    return mean_distance(s, h, both, inverse), h, 2.0 * (s / both), h * inverse


@compiled
def of_atoms(pressure, x, y, blur):
    """Sum over the atoms, with the torque about p, and the atom at (x, y), or -1; it exerts no force.

    `blur` is the square of the distance within which an atom counts as at (x, y).
    """
    rows, first, hit = pressure.rows, pressure.starts[ATOMS], -1
    distance, unit_x, unit_y, torque, xx, xy, yy = NOTHING
    for i in range(first, pressure.starts[SEGMENTS]):
        q_x, q_y, share = rows[i, 0], rows[i, 1], rows[i, 2]
        r_x, r_y = q_x - x, q_y - y
        square = r_x * r_x + r_y * r_y
        apart = square > max(rows[i, 3], blur)
        hit = max(hit, -1 if apart else i - first)
        # The square root and the division are independent, so the processor overlaps them.
        away, bend = sqrt(square), (1.0 if apart else 0.0) / (square if apart else 1.0)
        f_x, f_y = share * (away * bend) * r_x, share * (away * bend) * r_y
        distance += share * away
        unit_x += f_x
        unit_y += f_y
        torque += (q_x - pressure.center_x) * f_x + (q_y - pressure.center_y) * f_y
        xx += bend * f_y * r_y
        xy -= bend * f_x * r_y
        yy += bend * f_x * r_x
    return (distance, unit_x, unit_y, torque, xx, xy, yy), hit


#: Below this ratio of the length to the sum of the distances of the ends, the torque is a power series.
SHORT = 0.1
#: ``(z / (1 - z^2) - atanh z) / z^3`` in powers of z^2, to 1e-17 below SHORT.
TORQUE = tuple((2 * k + 2) / (2 * k + 3) for k in range(9))


@inlined
def of_segments(total, pressure, x, y):
    """Add the segments to the totals, whose torque is about p."""
    rows, p_x, p_y = pressure.rows, pressure.center_x, pressure.center_y
    for i in range(pressure.starts[SEGMENTS], pressure.starts[RINGS]):
        q_x, q_y, t_x = rows[i, 0], rows[i, 1], rows[i, 2]
        t_y, half, share = rows[i, 3], rows[i, 4], rows[i, 5]
        r_x, r_y = q_x - x, q_y - y
        local = segment(r_x * t_x + r_y * t_y, r_x * t_y - r_y * t_x, half)
        total = added(total, share, _placed(local, t_x, t_y), q_x - p_x, q_y - p_y)
    return total


@compiled
def segment(s, h, half):
    """The piece of a segment with its midpoint at (s, h), in coordinates along and across it."""
    one, other = ends(s, h, half)
    both = one + other
    inverse = mean_inverse(s, h, half, one, other)
    distance, torque = mean_distance(s, h, both, inverse), _torque(s, h, half, both, inverse)
    product = max(one * other, LEAST)
    tt, tn = _bend(abs(s), h, half, one, other) / product, -2.0 * (s / both) * h / product
    return distance, 2.0 * (s / both), h * inverse, torque, tt, tn, inverse - tt


@compiled
def _torque(s, h, half, both, inverse):
    """``h^2 (z / (1 - z^2) - atanh z) / l`` with z = l / (rho1 + rho2), about the midpoint."""
    z, x = 2.0 * half / both, abs(s)
    if z < SHORT:
        return h * (h / both) * (z * z) * polynomial(TORQUE, z * z)
    return (both / 2.0 - x) * (both / 2.0 + x) / both - h * h * inverse / 2.0


@compiled
def _bend(s, h, half, one, other):
    """``(s2 rho1 - s1 rho2) / l`` of the ends, without cancellation; s >= 0."""
    before, after = s - half, s + half
    near, far = min(one, other), max(one, other)
    if before > 0.0:
        return 2.0 * s * h * h / (after * near + before * far)
    return (after * near - before * far) / (2.0 * half)


@compiled
def _placed(local, t_x, t_y):
    """Rotate a piece from the axes of a segment to those of the body; the normal is (t_y, -t_x)."""
    distance, t, n, torque, tt, tn, nn = local
    xx = tt * t_x * t_x + 2.0 * tn * t_x * t_y + nn * t_y * t_y
    xy = (tt - nn) * t_x * t_y + tn * (t_y * t_y - t_x * t_x)
    yy = tt * t_y * t_y - 2.0 * tn * t_x * t_y + nn * t_x * t_x
    return distance, t * t_x + n * t_y, t * t_y - n * t_x, torque, xx, xy, yy


@inlined
def of_rings(total, pressure, x, y):
    """Add the rings to the totals, whose torque is about p."""
    rows, p_x, p_y = pressure.rows, pressure.center_x, pressure.center_y
    for i in range(pressure.starts[RINGS], pressure.starts[DISCS]):
        q_x, q_y, radius, share = rows[i, 0], rows[i, 1], rows[i, 2], rows[i, 3]
        total = added(total, share, ring(x - q_x, y - q_y, radius), q_x - p_x, q_y - p_y)
    return total


@compiled
def ring(x, y, radius):
    """The piece of a uniform ring: Eqs. (2)-(3) at the spin ratio R / c."""
    c = sqrt(x * x + y * y) / radius
    force, torque, slope = ring_wrench(c, 1.0)
    along = slope if c < 1.0 else slope / (c * c * c)
    across = force / c if c > 0.0 else 0.5
    distance = radius * (torque + c * force)
    return turned(x, y, distance, force, radius * torque, along / radius, across / radius)


@inlined
def of_plates(total, pressure, x, y):
    """Add the polygons and the cells of pressure maps to the totals, whose torque is about p."""
    rows, p_x, p_y = pressure.rows, pressure.center_x, pressure.center_y
    first = pressure.starts[PLATES]
    for i in range(first, pressure.starts[EDGES]):
        q_x, q_y, radius, share = rows[i, 0], rows[i, 1], rows[i, 2], rows[i, 3]
        r_x, r_y = x - q_x, y - q_y
        if r_x * r_x + r_y * r_y < (FAR * radius) ** 2:
            piece = near(rows, int(rows[i, 4]), int(rows[i, 5]), r_x, r_y)
        else:
            piece = far(pressure.multipoles, pressure.series + i - first, r_x, r_y, radius)
        total = added(total, share, piece, q_x - p_x, q_y - p_y)
    return total
