"""The checks, by topic; importing the package registers them all."""

from planar_pushing.evidence.claims.checks import any_support as any_support
from planar_pushing.evidence.claims.checks import cones as cones
from planar_pushing.evidence.claims.checks import dynamics as dynamics
from planar_pushing.evidence.claims.checks import limit_curves as limit_curves
from planar_pushing.evidence.claims.checks import numbers as numbers
from planar_pushing.evidence.claims.checks import ring as ring
