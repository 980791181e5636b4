"""The command `compile`."""

from __future__ import annotations

import argparse
import signal
import time
from typing import Any

from planar_pushing.commands.words.arguments import Commands, command
from planar_pushing.terms.options import EffectSet, Method


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Compile the core for every set of effects now; the first use does it otherwise."
    command(commands, "compile", compile_core, about)


def compile_core(args: argparse.Namespace) -> dict[str, Any]:
    """Call every compiled function once; what is compiled is kept beside the sources."""
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor

    from planar_pushing.mechanics.compiled import CACHE

    start = time.perf_counter()
    # Ctrl-C ends the processes without a traceback each.
    with ProcessPoolExecutor(
        mp_context=multiprocessing.get_context("spawn"),
        initializer=signal.signal, initargs=(signal.SIGINT, signal.SIG_DFL),
    ) as pool:  # fmt: skip
        others = pool.submit(call_sliders)
        for _ in pool.map(call_all, reversed(EffectSet)):  # the longest first
            pass
        others.result()
    return {"compiled": str(CACHE), "seconds": round(time.perf_counter() - start, 1)}


def call_all(kinds: EffectSet) -> None:
    """Call every compiled function for a set of effects."""
    import planar_pushing as pp
    from planar_pushing.mechanics.wrench import ring_profile, ring_spin_ratios

    known: dict[str, Any] = {"support_friction": pp.RingFriction(), "inertia": pp.Inertia()}
    effects = tuple(known[kind] for kind in kinds.split("+"))
    slider = pp.Slider(rod_length=2.0, rod_angle=1.0)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=effects)
    share = None if len(effects) == 1 else 0.5
    pp.solve(scene, 1.0)
    pp.limit_curve(scene, 1.0)
    pp.motion_cone(scene)
    pp.conservative_motion_cone(scene)
    for function in (pp.spin_ratio, pp.motion_angle, pp.motion_centers):
        function(scene, 1.0, share)
    for effect in effects:
        pp.wrench(effect, (1.0, 0.0, 1.0))
    ring_profile(1.0)
    ring_spin_ratios(1.0)
    pusher = pp.Pusher(velocity=(0.0, 1.0))
    for method in Method:
        pp.simulate(scene, pusher=pusher, duration=1e-3, method=method)
    pp.simulate_batch(
        rod_length=2.0, rod_angle=1.0, friction_coefficient=1.0, velocity=(0.0, 1.0), duration=1e-3,
        effects=effects,
    )  # fmt: skip


def call_sliders() -> None:
    """Call what the study of sliders calls with supports that are no rings."""
    import planar_pushing as pp

    tripod = pp.Points([(1.0, 0.0), (-0.5, 0.8), (-0.5, -0.8)], [1.0, 1.0, 1.0])
    friction = pp.SupportFriction(support=tripod)
    slider = pp.Slider(rod_length=2.0, rod_angle=1.0)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(friction,))
    pp.solve(scene, 1.0)
    pp.limit_curve(scene, 1.0)
    pp.motion_cone(scene)
    pp.motion_centers(scene, 1.0)
    pp.wrench(friction, (1.0, 0.0, 1.0))
    pp.fit_ellipsoid(tripod)
    pp.simulate(scene, pusher=pp.Pusher(velocity=(0.0, 1.0)), duration=1e-3)
