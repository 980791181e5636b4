"""The explorer: a page in the browser on which a scene is dragged, and everything follows."""

from planar_pushing.terms.extras import require_extra

require_extra("explore")
