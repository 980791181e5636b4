"""Figure 14."""

import numpy as np
from numpy.testing import assert_allclose

from planar_pushing.mechanics.contact import ContactMode


def test_only_a_slider_at_rest_has_no_motion_centre(plotted):
    kept, lost = (plotted["figure_14"].isel(policy=number) for number in (0, 1))
    assert np.isfinite(kept.path_center).all()
    gone = lost.path_mode.values == ContactMode.SEPARATE
    assert (np.isnan(lost.path_center.values).all(axis=-1) == gone).all()


def test_the_contact_is_kept_and_lost(plotted):
    kept, lost = (plotted["figure_14"].isel(policy=number) for number in (0, 1))
    before = kept.time.values < 0.5
    assert (kept.path_mode == ContactMode.STICK).all()
    assert (kept.path_gap == 0).all()
    assert (lost.path_mode.values[~before] == ContactMode.SEPARATE).all()
    assert (np.diff(lost.path_gap.values[~before]) > 0).all()
    assert_allclose(kept.path_rod_angle[before], lost.path_rod_angle[before], rtol=0, atol=1e-12)
    assert (kept.path_solutions.values[~before] > 1).all()
