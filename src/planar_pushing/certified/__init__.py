"""Physics in ball arithmetic, on a route that shares nothing with the mechanics."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
