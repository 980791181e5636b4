"""Steps of one mode: DOP853, and Radau while friction settles much faster than the slider moves.

Friction turns a twist towards its quasi-static direction within the time ``m v / W``. Where that is short
an explicit method is held to it long after the error would allow more.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from scipy.integrate import DOP853, DenseOutput, Radau

from planar_pushing.simulation.mode import Mode, State, System

#: Step times Jacobian near the bound of stability (Hairer and Wanner, Solving Ordinary Differential
#: Equations II, Sec. IV.2).
STIFF = 4.0
#: So many steps in a row have to agree before the method changes.
AGREE = 15


class Singular(Exception):
    """The step size fell below rounding."""


def steps(
    system: System, mode: Mode, time: float, state: State, end: float, rtol: float
) -> Iterator[tuple[float, State, DenseOutput]]:
    """Integrate a mode: end of each step, the state there, and the dense output.

    Raises
    ------
    Singular
        Where the motion cannot be continued in this mode.
    """
    atol = [rtol * scale for scale in system.scales()]
    explicit, stable = True, math.inf
    while time < end:
        solver = (DOP853 if explicit else Radau)(
            lambda t, y: mode.rates(t, y.tolist()), time, np.array(state), end,
            rtol=rtol, atol=atol,
        )  # fmt: skip
        agree = 0
        while solver.status == "running" and agree < AGREE:
            solver.step()
            if solver.status == "failed":
                raise Singular
            time, state = solver.t, solver.y.tolist()
            bound = solver.step_size * system.settling(time, state)
            changes = _stiffness(solver) > STIFF if explicit else bound < stable / 2
            agree = agree + 1 if changes else 0
            yield time, state, solver.dense_output()
        explicit, stable = not explicit, bound


def _stiffness(solver: DOP853) -> float:
    """Step times Jacobian, from the two stages at the end of the step."""
    last = solver.n_stages - 1
    inner = solver.y_old + solver.step_size * (solver.A[last, :last] @ solver.K[:last])
    apart = float(np.linalg.norm(solver.y - inner))
    change = float(np.linalg.norm(solver.K[last + 1] - solver.K[last]))
    return solver.step_size * change / apart if apart > 0 else 0.0
