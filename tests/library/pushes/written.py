"""Files of pushes in the published formats, written from what was pushed, and a small dataset."""

from __future__ import annotations

import numpy as np
import scipy.io
import xarray as xr

import planar_pushing as pp
from planar_pushing.pushes.logs.measured import Measured

SQUARE = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
TRIANGLE = [(0.0, 0.0), (150.0, 0.0), (0.0, 150.0)]


def touching(outline, points, normals, path, radius=0.0):
    """Measured pushes of a finger that touches an outline at points; only its path is known."""
    points, normals = (
        np.atleast_2d(np.asarray(points, float)),
        np.atleast_2d(np.asarray(normals, float)),
    )
    parts = np.asarray(path, float)
    parts = parts[None, None] if parts.ndim == 1 else parts
    parts = parts[None] if parts.ndim == 2 else parts
    count = len(points)
    parts = np.broadcast_to(parts, (count, *parts.shape[1:]))
    return Measured(
        outline=pp.Outline(outline), contact=points, normal=np.broadcast_to(normals, points.shape),
        finger=parts.sum(axis=1), displacement=np.zeros((count, 2)), rotation=np.zeros(count),
        radius=np.full(count, float(radius)), force=np.full((count, 2), np.nan), path=parts,
        noise=(0.0, 0.0, 0.0),
    )  # fmt: skip


def turn(angle):
    """Matrix that turns by an angle, radians."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s], [s, c]])


def small(**changes):
    """Three pushes of a square of 2 mm, with some variables changed; None takes one away."""
    count, units = 3, {"units": "mm"}
    found = {
        "pushed": ("push", ["square"] * count),
        "outline": (("object", "corner", "xy"), [SQUARE], units),
        "contact": (("push", "xy"), [(-0.5, -1.0), (0.0, -1.0), (1.0, 0.5)], units),
        "normal": (("push", "xy"), [(0.0, 1.0), (0.0, 1.0), (-1.0, 0.0)]),
        "finger_displacement": (("push", "xy"), [(0.0, 0.2), (0.1, 0.2), (-0.2, 0.0)], units),
        "finger_radius": ("push", [0.0] * count, units),
        "displacement": (("push", "xy"), [(0.0, 0.15), (0.0, 0.2), (-0.17, 0.02)], units),
        "rotation": ("push", [-4.0, 0.5, 6.0], {"units": "degree"}),
    } | changes
    kept = {name: each for name, each in found.items() if each is not None}
    return xr.Dataset(kept, {"object": ["square"], "xy": ["x", "y"]})


def world_poses(pushes, random):
    """Random poses before, and those after, of the pushes of a dataset; x, y and angle in radians."""
    count = pushes.sizes["push"]
    before = np.column_stack([random.uniform(-300, 300, (count, 2)), random.uniform(-3, 3, count)])
    moved = [turn(a) @ d for a, d in zip(before[:, 2], pushes["displacement"].values, strict=True)]
    turned = np.deg2rad(pushes["rotation"].values)
    return before, before + np.column_stack([np.array(moved), turned])


def finger_places(pushes, before, lead=0.0):
    """Centers of the finger in the world before and after; it begins a distance before the touch."""
    radius = pushes["finger_radius"].values[:, None]
    touch = pushes["contact"].values - radius * pushes["normal"].values
    motion = pushes["finger_displacement"].values
    start = touch - lead * motion / np.linalg.norm(motion, axis=1, keepdims=True)
    places = [
        [turn(pose[2]) @ each + pose[:2] for each, pose in zip(given, before, strict=True)]
        for given in (start, touch + motion)
    ]
    return np.array(places[0]), np.array(places[1])


def quaternion(angle):
    """w x y z of a rotation about the vertical."""
    return [np.cos(angle / 2), 0.0, 0.0, np.sin(angle / 2)]


def line(*numbers):
    return " ".join(f"{each:.12g}" for each in numbers)


def samples_of(force, start, turned, random):
    """Sensor samples: an offset, 29 weak ones as it settles, then the force, some weaker.

    The force keeps its direction in the object, which turns evenly from an angle from the tool on.
    """
    offset = random.normal(size=2) * 0.02
    strength = np.concatenate([[0.0], np.full(29, 0.3), np.tile([1.1, 0.9, 1.0, 0.2, 1.2], 14)])
    passed = np.linspace(0.0, 1.0, len(strength))
    x, y = np.array([turn(start + turned * each) @ force for each in passed]).T
    # The sensor's x is along (1, 1) of the tool and its y along (1, -1); it feels the reaction.
    sensor = -np.column_stack([x + y, x - y]) / np.sqrt(2)
    return offset + strength[:, None] * sensor


#: Mean of the samples above that are not weaker than their mean, 0.88.
STRENGTH = np.mean([1.1, 0.9, 1.0, 1.2])


def write_log(file, pushes, random, counted=True, offset=2.0):
    """A log of the triangle; its mean forces are STRENGTH times those of the dataset."""
    before, after = world_poses(pushes, random)
    start, end = finger_places(pushes, before, offset)
    lines = [str(len(before))] if counted else []
    for k in range(len(before)):
        for pose in (before[k], after[k]):
            lines.append(line(*pose[:2], 9.5, *quaternion(pose[2])))
        yaw = random.uniform(-3, 3)
        force, turned = pushes["force"].values[k], after[k, 2] - before[k, 2]
        samples = samples_of(force, before[k, 2] - yaw, turned, random)
        lines += [str(len(samples)), *(line(0.01 * i, *each) for i, each in enumerate(samples))]
        ways = np.linspace(0, 1, 5)
        tools = [
            line(0.2 * w, *(start[k] + w * (end[k] - start[k])), 20, *quaternion(yaw)) for w in ways
        ]
        lines += [str(len(tools)), *tools]
    file.write_text("\n".join(lines) + "\n")
    return lines


def write_mat(file, pushes, random, lead=1.0, **changed):
    """A MATLAB file of pushes of a round tip; the dataset is in mm, the file in m."""
    before, after = world_poses(pushes, random)
    start, end = finger_places(pushes, before, lead)
    names = ("init_pose_gt", "final_pose_gt", "init_tip_pt", "final_tip_pt")
    scales = [np.array([1e-3, 1e-3, 1.0])] * 2 + [1e-3] * 2
    values = [each * scale for each, scale in zip((before, after, start, end), scales, strict=True)]
    kinds = [(name, object) for name in names]
    records = np.empty((len(before), 1), dtype=kinds)
    for name, value in zip(names, values, strict=True):
        for k, row in enumerate(value):
            records[name][k, 0] = row[:, None]
    for name, value in changed.items():
        records[name][1, 0] = value
    scipy.io.savemat(file, {"record_all": records, "mu": 0.25})


def feet(weight=5.0):
    """Friction of the triangle on three feet, which balance about its center of mass."""
    support = pp.Points([(10, 10), (130, 10), (10, 130)], [1, 1, 1])
    return (pp.SupportFriction(support=support, weight=weight),)
