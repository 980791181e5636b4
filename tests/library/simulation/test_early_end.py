"""A run that ends early says so once, with time, reason and remedy; callers that ask themselves do not."""

from __future__ import annotations

import math
import warnings

import numpy as np
import pytest
from command_line import COMMAND
from simulation.scenes import NO_EDGE, SIDE_ENDS, STOPS, box, scene

import planar_pushing as pp
from planar_pushing.simulation.early_end import REASONS, quietly
from planar_pushing.simulation.fields import Stop
