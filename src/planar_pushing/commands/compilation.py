"""The command `compile`."""

from __future__ import annotations

import argparse
import time
from typing import Any

from planar_pushing.commands.arguments import Commands, command


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Compile the core for every set of effects now; the first use does it otherwise."
    command(commands, "compile", compile_core, about)


def compile_core(args: argparse.Namespace) -> dict[str, Any]:
    """Call every compiled function once; what is compiled is kept beside the sources."""
    import planar_pushing as pp
    from planar_pushing.mechanics.compiled import CACHE
    from planar_pushing.mechanics.wrench import ring_profile, ring_spin_ratios

    start = time.perf_counter()
    friction, inertia = pp.RingFriction(), pp.Inertia()
    slider = pp.Slider(rod_length=2.0, rod_angle=1.0)
    for effects in ((friction,), (inertia,), (friction, inertia)):
        scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=effects)
        _solve(scene, None if len(effects) == 1 else 0.5)
        _simulate(scene)
    for effect in (friction, inertia):
        pp.wrench(effect, (1.0, 0.0, 1.0))
    ring_profile(1.0)
    ring_spin_ratios(1.0)
    return {"compiled": CACHE, "seconds": round(time.perf_counter() - start, 1)}


def _solve(scene: Any, share: float | None) -> None:
    import planar_pushing as pp

    pp.solve(scene, 1.0)
    pp.limit_curve(scene, 1.0)
    pp.motion_cone(scene)
    pp.conservative_motion_cone(scene)
    for function in (pp.spin_ratio, pp.motion_angle, pp.motion_centers):
        function(scene, 1.0, share)


def _simulate(scene: Any) -> None:
    import planar_pushing as pp

    for method in ("event-driven", "time-stepping"):
        pp.simulate(scene, pusher=pp.Pusher(velocity=(0.0, 1.0)), duration=1e-3, method=method)
