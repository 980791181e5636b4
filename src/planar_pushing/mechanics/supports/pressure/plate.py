"""An area with uniform pressure between straight edges: a polygon, or cells of a pressure map.

By the divergence theorem, the means over the area are sums over the edges of the mean distance along each
edge times the jump of the pressure across it (manual: theory, any support). Far from the area these sums
cancel, and multipoles are used instead.
"""

from __future__ import annotations

from planar_pushing.mechanics.compiled import compiled
from planar_pushing.mechanics.supports.pressure.edges import ends, mean_distance, mean_inverse

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
