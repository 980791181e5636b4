"""Parts of the checks of the claims."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
