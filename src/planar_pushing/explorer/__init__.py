"""The explorer: a page in the browser on which the user drags the parts of a scene."""

from planar_pushing.terms.extras import require_extra

require_extra("explore")
