"""Hard cases: where the numbers get hard, each with its reference, its error and its condition."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
