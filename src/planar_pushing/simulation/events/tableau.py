"""Coefficients of DOP853, from SciPy (Hairer, Norsett and Wanner I, Sec. II.10).

Twelve stages and the derivative at the end of the step give a result of order 8 and two estimates of its
error. Three more stages give dense output of order 7.
"""

from __future__ import annotations

import numpy as np
from scipy.integrate import DOP853

#: Number of stages of a step, and number including the derivative at its end and the dense output.
STEP, STAGES = 12, 16
#: Times of the stages in a step.
C = np.array([*DOP853.C, 1.0, *DOP853.C_EXTRA])
#: Weights of the previous stages in each stage; row 12 is the result of the step.
A = np.zeros((STAGES, STAGES))
A[:STEP, :STEP] = DOP853.A
A[STEP, :STEP] = DOP853.B
A[STEP + 1 :] = DOP853.A_EXTRA
#: Weights of the two estimates of the error, of orders 5 and 3.
ERRORS = np.array([DOP853.E5, DOP853.E3])
#: Weights of the last four coefficients of the dense output.
WEIGHTS = np.array(DOP853.D)
