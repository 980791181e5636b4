"""What the checks of the claims are made of."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
