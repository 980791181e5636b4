"""The report: its numbers and tables, read from the results, and its typesetting as a PDF."""

from planar_pushing.terms.extras import require_extra

require_extra("report")
