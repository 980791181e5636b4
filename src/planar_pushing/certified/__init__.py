"""Physics in ball arithmetic, computed independently of the mechanics."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
