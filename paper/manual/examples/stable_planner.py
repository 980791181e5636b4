"""Push a box to a goal pose with a fence along its long side: an arc, a straight line and an arc.

The box moves with the fence as long as each push is stable, so that the path needs no feedback.
"""

import sys
from itertools import product

import numpy as np

import planar_pushing as pp

BOX = pp.Polygon.rectangle(0.3, 0.2)  # meters; the fence is along the first side, which is below
FRICTION = pp.SupportFriction(support=BOX, weight=pp.weight(1.2, 0.3))
SCENE = pp.scene_at(side=0, effects=(FRICTION,), contact=pp.Coulomb(0.5), outline=BOX)
START, GOAL = (0.0, 0.0), (0.6 + 0.3j, np.pi / 6)  # x + iy in meters, and angle, of the box
MARGIN = 1.05  # by which arcs are wider than the tightest stable ones


def tightest_radius(centers, sense):
    """Least distance of a stable center on the line through the box's center along the fence."""
    crossings = []
    for curve in centers.curves:
        x, y = curve.centers[np.isfinite(curve.centers).all(axis=1)].T
        k = np.flatnonzero(np.diff(np.sign(y)) * (curve.sense == sense))
        crossings.extend(x[k] - y[k] * (x[k + 1] - x[k]) / (y[k + 1] - y[k]))
    return MARGIN * min(map(abs, crossings))


def path(start, goal, radii):
    """The shortest path: twists of the box, ahead at unit speed, and their durations.

    A radius is positive for an arc to the left: if the box moves along the unit vector u, the center of its
    arc is at r i u from the box. From the center of the first arc to that of the last one it is the line,
    along u, and the difference of the radii, along i u.
    """
    paths = []
    (z, out), (w, into) = ((z, 1j * np.exp(1j * angle)) for z, angle in (start, goal))
    for first, last in product(radii, repeat=2):
        apart = w + last * 1j * into - z - first * 1j * out
        if abs(apart) >= abs(last - first):
            line = np.sqrt(abs(apart) ** 2 - (last - first) ** 2)
            u = apart / (line + (last - first) * 1j)
            arcs = [
                abs(r) * (np.sign(r) * np.angle(b / a) % (2 * np.pi))
                for r, a, b in ((first, out, u), (last, u, into))
            ]
            twists = np.array([(0, 1, 1 / first), (0, 1, 0), (0, 1, 1 / last)])
            paths.append((sum(arcs) + line, twists, [arcs[0], line, arcs[1]]))
    return min(paths, key=lambda candidate: candidate[0])[1:]


def moved(pose, twist, duration):
    """Pose of a box that moves with its fence, ahead at unit speed: a rotation about a center."""
    (z, angle), turn = pose, twist[2] * duration
    ahead = 1j * np.exp(1j * angle + 0.5j * turn)
    return z + ahead * duration * np.sinc(turn / (2 * np.pi)), angle + turn


def draw(centers, twists, durations, name):
    """Draw the stable centers, and the box along the path; its lower side is the one on the fence."""
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4))
    pp.plot_stable_centers(centers, ax=left)
    pose, corners = START, np.array(BOX.vertices) @ [1, 1j]
    for twist, duration in zip(twists, durations, strict=True):
        for part in np.linspace(0, duration, 2 + int(duration / 0.12)):
            z, angle = moved(pose, twist, part)
            box = z + np.append(corners, corners[0]) * np.exp(1j * angle)
            right.plot(box.real, box.imag, "0.6", lw=0.8)
            right.plot(box[:2].real, box[:2].imag, "k", lw=2)
        pose = moved(pose, twist, duration)
    right.set(aspect="equal", xlabel="x (m)", ylabel="y (m)")
    figure.savefig(name)


if __name__ == "__main__":
    centers = pp.stable_centers(SCENE)
    radii = tightest_radius(centers, "counterclockwise"), -tightest_radius(centers, "clockwise")
    print(f"radius of arcs: {radii[0]:.4f} m to the left, {-radii[1]:.4f} m to the right")
    twists, durations = path(START, GOAL, radii)
    poses = [START]
    for twist, duration, stable in zip(twists, durations, pp.stable(SCENE, twists), strict=True):
        poses.append(moved(poses[-1], twist, duration))
        (z, angle), turn = poses[-1], np.rad2deg(twist[2] * duration)
        print(f"push {duration:.4f} m, turn {turn:7.2f} degrees, stable: {stable}; ", end="")
        print(f"box at ({z.real:.3f}, {z.imag:.3f}) m, {np.rad2deg(angle):.2f} degrees")
    if len(sys.argv) > 1:
        draw(centers, twists, durations, sys.argv[1])
