"""Machine code of simulations: where it is cached, and which effects' functions it contains.

Numba generates machine code for each list of effects, and names the functions in it.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numba

from planar_pushing.mechanics.scene import Scene
from planar_pushing.simulation.events import driver as events
from planar_pushing.simulation.legacy import compiled
from planar_pushing.simulation.steps import driver as steps
from planar_pushing.simulation.systems.setup import KINDS, kinds_of
from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.options import EffectKind, Method

#: Modules that contain the formulas of each effect.
FORMULAS = {
    EffectKind.SUPPORT_FRICTION: (
        "planar_pushing.simulation.legacy.own_ring",
        "planar_pushing.simulation.legacy.any_support",
        "planar_pushing.simulation.legacy.disc",
        "planar_pushing.simulation.legacy.edges",
        "planar_pushing.simulation.legacy.moments",
        "planar_pushing.simulation.legacy.multipole",
        "planar_pushing.simulation.legacy.pieces",
        "planar_pushing.simulation.legacy.ring",
        "planar_pushing.simulation.legacy.table",
    ),
    EffectKind.INERTIA: ("planar_pushing.simulation.legacy.mass",),
}
#: Kernel of each method.
KERNELS: dict[Method, Any] = {
    Method.EVENT_DRIVEN: events.advance,
    Method.TIME_STEPPING: steps.advance,
}


def folder() -> Path:
    """Folder in which the machine code is cached."""
    return compiled.CACHE


def require_machine_code() -> None:
    """Refuse a process without the compiler.

    Raises
    ------
    PlanarPushingError
        If nothing is compiled.
    """
    if numba.config.DISABLE_JIT:
        raise PlanarPushingError("there is no machine code to inspect; unset NUMBA_DISABLE_JIT")


def count_functions(scene: Scene, method: Method) -> dict[EffectKind, int]:
    """Count each effect's functions in the machine code with which a scene has been simulated."""
    kernel = KERNELS[method]
    codes = [each for each in kernel.overloads if _is_system_of(scene, each[0])]
    names = set[str]().union(*(linked(kernel, each) for each in codes))
    return {
        kind: sum(name.startswith(tuple(map(_mangled, modules))) for name in names)
        for kind, modules in FORMULAS.items()
    }


def linked(kernel: Any, signature: Any) -> set[str]:
    """Mangled names of the functions in the machine code of a kernel, without their types.

    Numba keeps the names in code that it has read from its cache, and prints code that it has just
    compiled.
    """
    kept = kernel.overloads[signature].referenced_envs
    text = " ".join(each.env_name for each in kept) if kept else kernel.inspect_llvm(signature)
    return set(re.findall(r"_ZN08NumbaEnv(\w+?)B\d+v\d+", text))


def _mangled(module: str) -> str:
    return "".join(f"{len(part)}{part}" for part in module.split("."))


def _is_system_of(scene: Scene, argument: Any) -> bool:
    """Whether the first argument of a kernel matches the kind of a scene's system."""
    kinds = numba.typeof(kinds_of(scene)).types
    return argument.instance_class is KINDS[scene.stores_energy] and argument.types[:4] == kinds
