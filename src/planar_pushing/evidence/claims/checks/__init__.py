"""The checks, by theme; importing the package registers them all."""

from planar_pushing.evidence.claims.checks import acceleration_centers as acceleration_centers
from planar_pushing.evidence.claims.checks import any_support as any_support
from planar_pushing.evidence.claims.checks import contact_laws as contact_laws
from planar_pushing.evidence.claims.checks import dynamics as dynamics
from planar_pushing.evidence.claims.checks import findings as findings
from planar_pushing.evidence.claims.checks import formulas as formulas
from planar_pushing.evidence.claims.checks import infinite_friction as infinite_friction
from planar_pushing.evidence.claims.checks import limit_curves as limit_curves
from planar_pushing.evidence.claims.checks import velocity_cones as velocity_cones
