"""Steps of one mode: DOP853, and Radau while friction settles much faster than the slider moves.

Friction turns a twist towards its quasi-static direction within the time ``m v / W``. Where that is short
an explicit method is held to it long after the error would allow more.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy.integrate import DOP853, DenseOutput, Radau

from planar_pushing.simulation.mode import Mode, State, System

#: Step times rate of settling at which DOP853 is near its bound of stability, and safely within it.
STIFF, SMOOTH = 3.0, 0.3
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
    stiff = False
    while time < end:
        solver = (Radau if stiff else DOP853)(
            lambda t, y: mode.rates(t, y.tolist()), time, np.array(state), end,
            rtol=rtol, atol=atol,
        )  # fmt: skip
        agree = 0
        while solver.status == "running" and agree < AGREE:
            solver.step()
            if solver.status == "failed":
                raise Singular
            time, state = solver.t, solver.y.tolist()
            yield time, state, solver.dense_output()
            bound = solver.step_size * system.settling(time, state)
            agree = agree + 1 if (bound < SMOOTH if stiff else bound > STIFF) else 0
        stiff = not stiff
