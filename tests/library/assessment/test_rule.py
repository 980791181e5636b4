"""The rule: an effect can be left out if 8 times its estimate is within the tolerance."""

import numpy as np
import pytest
from assessment.random_pushes import EFFECTS, corner_change, random_push

from planar_pushing.assessment.estimate import FACTOR, estimate_pose_change, jump_times
from planar_pushing.assessment.estimate import outline_circles as circles_of
from planar_pushing.assessment.variants import with_candidates

TOLERANCES = (1e-4, 3e-4, 1e-3, 3e-3, 1e-2)


def estimates_and_changes(rng, count):
    """Estimate and change of the pose, in meters, of each effect over random pushes."""
    answers = {name: [] for name in EFFECTS}
    for _ in range(count):
        push = random_push(rng)
        bare, circles = push.log(push.scene), circles_of(push.scene)
        for name in EFFECTS:
            full = with_candidates(push.scene, [push.others[name]])
            log = push.log(full)
            if bare.stopped or log.stopped:
                continue
            estimate = estimate_pose_change(
                bare, push.scene, full.effects[-1], circles, jump_times(push.pusher)
            )
            answers[name].append((estimate.total, corner_change(bare, log, push.corners)))
    return {name: np.array(rows).T for name, rows in answers.items()}


def missed(estimate, change):
    """How many effects are left out at a tolerance although they change more."""
    return sum(int(((FACTOR * estimate <= limit) & (change > limit)).sum()) for limit in TOLERANCES)


def left_out(estimate):
    """How many effects the rule leaves out, over all tolerances."""
    return sum(int((FACTOR * estimate <= limit).sum()) for limit in TOLERANCES)


def check(answers):
    for name, (estimate, change) in answers.items():
        assert missed(estimate, change) == 0, name
        assert left_out(estimate) > 0, name
        assert (change <= FACTOR * estimate).all(), name


def test_no_effect_is_missed_in_random_pushes():
    check(estimates_and_changes(np.random.default_rng(11), 30))


@pytest.mark.slow
def test_no_effect_is_missed_in_a_thousand_random_pushes():
    check(estimates_and_changes(np.random.default_rng(64), 1000))
