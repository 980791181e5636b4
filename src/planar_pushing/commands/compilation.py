"""The command `compile`."""

from __future__ import annotations

import argparse
import gc
import logging
import multiprocessing
import signal
import sys
import threading
import time
from collections.abc import Callable
from contextlib import ExitStack
from typing import Any

from planar_pushing.commands.words.arguments import Commands, command
from planar_pushing.terms.options import Method, Shape


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = (
        "Compile simulations ahead of time for the kinds of sliders in the paper and the examples."
    )
    command(commands, "compile", compile_simulations, about)


def compile_simulations(args: argparse.Namespace) -> dict[str, Any]:
    """Simulate each kind of slider once; the machine code is cached next to the sources."""
    from concurrent.futures import ProcessPoolExecutor, as_completed

    from tqdm import tqdm

    from planar_pushing.simulation.machine_code import folder

    start = time.perf_counter()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    context = multiprocessing.get_context("spawn")
    with ExitStack() as pools:
        jobs = []
        for half in HALVES:
            pool = pools.enter_context(ProcessPoolExecutor(1, context, _begin))
            jobs += [pool.submit(_call, kind, call) for kind, calls in half for call in calls]
        try:
            for job in tqdm(as_completed(jobs), "compiling", len(jobs), disable=None, leave=False):
                job.result()
        except BaseException:  # including Ctrl-C; the running calls would take another minute
            for child in multiprocessing.active_children():
                child.terminate()
            raise
    return {"compiled": str(folder()), "seconds": round(time.perf_counter() - start, 1)}


def _begin() -> None:
    """Prepare a process so that a signal ends it without a traceback or a stale lock."""
    from tqdm import tqdm

    signal.signal(signal.SIGINT, signal.SIG_DFL)
    tqdm.set_lock(threading.RLock())
    logging.getLogger("planar_pushing").setLevel(
        logging.ERROR
    )  # hide messages about the compilation
    gc.set_threshold(100_000)  # the compiler creates millions of objects


def _call(kind: str, call: Callable[[Any], None]) -> None:
    """Call functions with a scene that has the effects named by a kind."""
    import planar_pushing as pp

    square = pp.Polygon([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    effects: dict[str, Any] = {
        "ring": pp.RingFriction(),
        "inertia": pp.Inertia(),
        "box": pp.SupportFriction(support=square),
        "mass": pp.Inertia(center=(0.1, 0.0)),
    }
    slider = pp.Slider(rod_length=2.0, rod_angle=1.0)
    listed = tuple(effects[name] for name in kind.split("+"))
    call(pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=listed))


def under_fence(scene: Any) -> None:
    """Simulate a scene under a fence, alone and in a batch."""
    _simulate(scene, Shape.FENCE)


def under_finger(scene: Any) -> None:
    """Simulate a scene under a finger, alone and in a batch."""
    _simulate(scene, Shape.FINGER)


def _simulate(scene: Any, shape: Shape) -> None:
    import planar_pushing as pp

    pp.simulate(scene, pusher=pp.Pusher(velocity=(0.0, 1.0), shape=shape), duration=1e-3)
    pp.simulate_batch(scene, pusher=pp.Pusher(velocity=(0.0, 1.0), shape=shape), duration=1e-3)


def by_steps(scene: Any) -> None:
    """Simulate a scene under a fence by time-stepping."""
    import planar_pushing as pp

    fence = pp.Pusher(velocity=(0.0, 1.0))
    pp.simulate(scene, pusher=fence, duration=1e-3, method=Method.TIME_STEPPING)


#: The calls for each kind of slider; a box represents every support other than a ring.
RINGS, BOXES = (under_fence, by_steps), (under_fence, under_finger)
#: Work for each of two processes, balanced in time. Functions of a kind share most of the code that they
#: call, which is compiled once per process.
HALVES = (
    (("box+mass", BOXES), ("ring", RINGS)),
    (("ring+inertia", RINGS), ("box", BOXES), ("inertia", RINGS)),
)
