"""Contact modes: each consistent one meets its conditions, and each absent one fails one (Secs. 2-5)."""

from planar_pushing.evidence.golden.residual.contact_modes.residuals import residuals as residuals
