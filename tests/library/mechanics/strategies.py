"""Random scenes: lengths and ratios spread evenly in their logarithm."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st
from mechanics.builders import make_scene

import planar_pushing as pp


def powers(low, high):
    """Positive numbers from 10^low to 10^high."""
    return st.floats(low, high).map(lambda exponent: 10.0**exponent)


lengths = st.one_of(st.just(0.0), powers(-3, 3))
moderate_lengths = powers(-1, 1)
rod_angles = st.floats(0.05, np.pi - 0.05)
coefficients = st.one_of(st.just(0.0), st.just(np.inf), powers(-1.5, 2))
force_angles = st.floats(-np.pi, np.pi)
pusher_angles = st.floats(-np.pi, np.pi)
magnitudes = powers(-2, 2)
rings = st.builds(pp.RingFriction, weight=powers(-1, 1))
masses = st.builds(pp.Inertia, mass=powers(-1, 1), gyration_radius=powers(-0.5, 0.5))

friction = st.tuples(rings)
inertia = st.tuples(masses)
both = st.tuples(rings, masses)
one_effect = st.one_of(friction, inertia)
effect_sets = st.one_of(friction, inertia, both)


@st.composite
def scenes(draw, length=moderate_lengths, contact=coefficients, effects=effect_sets):
    return make_scene(draw(length), draw(contact), draw(effects), draw(rod_angles))


def share_of(scene, share=0.37):
    """A share where the scene asks for one."""
    return share if len({effect.degree for effect in scene.effects}) == 2 else None
