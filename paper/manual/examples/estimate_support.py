"""Estimate a box's support and friction from twenty noisy pushes, by least squares over simulations.

Part of the weight presses evenly on the base, the rest on the corners, and not alike on all. A finger
pushes each side at five places and in five directions; a camera sees how the box moves and turns.
"""

import numpy as np
from scipy.optimize import least_squares

import planar_pushing as pp

A, B = 1.5, 1.0  # half lengths of the box
PUSHES, LENGTH, NOISE = 20, 0.5, 0.002  # the noise is in lengths and radians
CORNERS = np.array([-A - B * 1j, A - B * 1j, A + B * 1j, -A + B * 1j])
NAMES = ("share of the corners", "excess on the right", "excess above", "friction")
TRUE = np.array([0.4, 0.3, -0.2, 0.35])
START, BOUNDS = np.array([0.5, 0.0, 0.0, 0.5]), ([0.01, -0.9, -0.9, 0.0], [0.99, 0.9, 0.9, 2.0])


def made_pushes(rng):
    """Contacts and inner normals as complex numbers in the frame of the box, and angles to the normals."""
    normal = np.tile([1, 1j, -1, -1j], PUSHES // 4)
    depth, width = np.where(normal.imag == 0, [[A], [B]], [[B], [A]])
    contact = (1j * width * rng.uniform(-0.8, 0.8, PUSHES) - depth) * normal
    return contact, normal, rng.uniform(-1.0, 1.0, PUSHES)


def support(parameters, turn):
    """The support in a body frame that is turned in the box."""
    share, right, above, _ = parameters
    places = np.column_stack([(CORNERS / turn).real, (CORNERS / turn).imag])
    loads = (1 + right * np.sign(CORNERS.real)) * (1 + above * np.sign(CORNERS.imag))
    return pp.Composite([(1 - share, pp.Polygon(places)), (share, pp.Points(places, loads))])


def moved(parameters, pushes):
    """Displacement and turn of the box after each push, in one batch of simulations."""
    contact, normal, angle = pushes
    rod = -contact / normal * 1j  # from the contact to the centre, the normal upwards
    supports = np.empty(PUSHES, object)
    supports[:] = [support(parameters, -each / abs(each)) for each in contact]
    slider = pp.Slider(rod_length=abs(rod), rod_angle=np.angle(rod))
    box = pp.SupportFriction(support=supports)
    scenes = pp.Scene(slider=slider, contact=pp.Coulomb(parameters[3]), effects=(box,))
    finger = pp.Pusher(velocity=(np.sin(angle), np.cos(angle)), shape="finger")
    found = pp.simulate_batch(scenes, finger, duration=LENGTH)
    step = found.position.values - np.column_stack([rod.real, rod.imag])
    return np.append(step, np.deg2rad(found.rod_angle - found.initial_rod_angle))


def estimate(seed):
    """Estimates and their standard errors, from pushes of a box with the true parameters."""
    rng = np.random.default_rng(seed)
    pushes = made_pushes(rng)
    seen = moved(TRUE, pushes) + rng.normal(0.0, NOISE, 3 * PUSHES)
    fit = least_squares(lambda x: (moved(x, pushes) - seen) / NOISE, START, "3-point", BOUNDS)
    return fit.x, np.sqrt(np.diag(np.linalg.inv(fit.jac.T @ fit.jac)))


if __name__ == "__main__":
    print("parameter              true  estimate  standard error")
    for name, true, found, error in zip(NAMES, TRUE, *estimate(seed=1), strict=True):
        print(f"{name:20}  {true:5.2f}  {found:8.4f}  {error:14.4f}")
