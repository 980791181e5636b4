"""The places at which the numbers get hard, a module each."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
