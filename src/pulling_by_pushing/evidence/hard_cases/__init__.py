"""Hard cases: numerically difficult inputs, each with its reference, error and condition number."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
