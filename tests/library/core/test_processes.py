"""The core at work: only the effects that a scene has, in threads, and in processes that fork."""

from __future__ import annotations

import os
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from core.building import CORE
from mechanics.builders import make_scene

import planar_pushing as pp
from planar_pushing.mechanics.force.limit_curve import curve_of_unit_motions
from planar_pushing.mechanics.kernels import calls as kernels

SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
FEET = pp.Points([(1, 0), (-1, 1), (-1, -1)])
#: Supports of each scene, whether it has inertia, and the modules that it needs of those that serve one
#: kind of effect or piece.
SCENES = {
    "ring": ((None,), False, {"ring"}),
    "inertia": ((), True, set()),
    "ring and inertia": ((None,), True, {"ring"}),
    "square": ((SQUARE,), False, {"pieces", "lines", "multipole"}),
    "square and inertia": ((SQUARE,), True, {"pieces", "lines", "multipole"}),
    "feet": ((FEET,), False, {"pieces", "pivot"}),
    "disc": ((pp.Disc(0.7),), False, {"pieces", "circles", "ring"}),
    "ring and feet": ((None, FEET), False, {"ring", "pieces", "pivot"}),
}
OF_ONE_KIND = {"ring", "pieces", "lines", "multipole", "circles", "pivot"}
#: It asks for feet that barely move, and calls nothing if there are none.
ASKS = "refine_psi"


def scene_of(name, law=1.4):
    supports, massive, _ = SCENES[name]
    effects = [
        pp.RingFriction() if each is None else pp.SupportFriction(support=each) for each in supports
    ]
    return make_scene(2.0, law, [*effects, *[pp.Inertia()] * massive])


def every_function(scene):
    more = {"force_ratio": 2.0} if len({each.degree for each in scene.effects}) == 2 else {}
    for angle in (-0.2, 1.0, 2.9):
        pp.solve(scene, angle)
        pp.solve(scene, angle, derivatives=True)
        pp.spin_ratio(scene, angle, **more)
        pp.motion_centers(scene, angle, **more)
        curve_of_unit_motions(scene, angle)
    pp.motion_cone(scene)


@pytest.mark.parametrize("name", SCENES)
def test_an_absent_effect_is_not_evaluated(name, monkeypatch):
    monkeypatch.setattr(kernels, "COMPILED", None)
    scene, files = scene_of(name), set()
    assert scene.rows.data.size  # the terms of plates are computed once, before

    def watch(frame, event, argument):
        if event == "call" and frame.f_code.co_name != ASKS:
            files.add(frame.f_code.co_filename)

    sys.setprofile(watch)
    try:
        every_function(scene)
    finally:
        sys.setprofile(None)
    modules = {path.stem for path in map(Path, files) if CORE in path.parents}
    assert {"kernels", "modes", "psi"} <= modules
    assert modules & OF_ONE_KIND == SCENES[name][2]


# Threads and processes


def pushes():
    """The bytes of the solutions of some hundred pushes of a slider with everything."""
    random = np.random.default_rng(3)
    effects = pp.SupportFriction(support=FEET), pp.RingFriction(), pp.Inertia()
    law = pp.Coulomb(10 ** random.uniform(-1, 1, 100))
    found = pp.solve(make_scene(2.0, law, effects), random.uniform(-3, 3, 100))
    return b"".join(getattr(found, name).tobytes() for name in ("mode", "force", "twist", "center"))


def test_threads_share_the_core():
    """Each call has memory of its own, and many at once give what one alone does."""
    alone = pushes()
    with ThreadPoolExecutor(8) as pool:
        assert set(pool.map(lambda _: pushes(), range(24))) == {alone}


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")
@pytest.mark.filterwarnings("ignore:.*multi-threaded.*:DeprecationWarning")
def test_a_forked_process_has_the_core():
    """Also after threads: no lock of a compiler is held in the child."""
    with ThreadPoolExecutor(2) as pool:
        alone = pool.submit(pushes).result()
    read, write = os.pipe()
    child = os.fork()
    if not child:
        try:
            os.write(write, b"same" if pushes() == alone else b"other")
        finally:
            os._exit(0)
    os.close(write)
    with os.fdopen(read, "rb") as pipe:
        assert pipe.read() == b"same"
    assert os.waitpid(child, 0)[1] == 0
