"""Contacts by trial: lines of action of many forces of a set, met with each side."""

from __future__ import annotations

import numpy as np


def loads(rng, wrenches, count=4000):
    """Loads of a set, in the disc of its foot and on its rim, shape (count, 3)."""
    size = np.sqrt(np.concatenate([rng.uniform(0, 1, count // 2), np.ones(count - count // 2)]))
    angle = rng.uniform(0, 2 * np.pi, count)
    force = wrenches.radius * np.stack([size * np.cos(angle), size * np.sin(angle)], axis=-1)
    foot = np.zeros(2) if wrenches.foot is None else wrenches.foot
    torque = foot[0] * force[:, 1] - foot[1] * force[:, 0]
    return wrenches.offset + np.column_stack([force, torque])


def contacts(outline, wrenches):
    """Points, normals and least friction of the contacts of loads on the sides of an outline."""
    corners = np.array(outline, dtype=float)
    after = np.roll(corners, -1, axis=0)
    turns = np.sign((corners[:, 0] * after[:, 1] - corners[:, 1] * after[:, 0]).sum())
    for start, end in zip(corners, after, strict=True):
        along = (end - start) / np.linalg.norm(end - start)
        normal = turns * np.array([-along[1], along[0]])
        force = wrenches[:, :2]
        pushing, aside = force @ normal, np.abs(force @ along)
        # q x f = tau at q = start + s along
        offset = wrenches[:, 2] - (start[0] * force[:, 1] - start[1] * force[:, 0])
        rate = along[0] * force[:, 1] - along[1] * force[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            place = offset / rate
        right = (pushing > 1e-6) & (place >= 0) & (place <= np.linalg.norm(end - start))
        yield normal, start + place[right, None] * along, aside[right] / pushing[right]
