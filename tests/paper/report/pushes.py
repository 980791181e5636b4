"""Numbers on measured pushes in the form of paper/measured_pushes.json, all of them made up."""

from __future__ import annotations

import numpy as np

OUTLINE = [[0.0, 0.0], [150.0, 0.0], [0.0, 150.0]]
FEET = {
    "30_90_30_30_30_90": [[30.0, 30.0], [90.0, 30.0], [30.0, 90.0]],
    "10_90_10_10_30_130": [[10.0, 10.0], [90.0, 30.0], [10.0, 130.0]],
    "10_130_10_10_10_130": [[10.0, 10.0], [130.0, 10.0], [10.0, 130.0]],
    "30_63.33_43.33_30_43.33_63.33": [[30.0, 30.0], [63.33, 43.33], [43.33, 63.33]],
}
#: Medians of each model, degrees or mm, by quantity.
ANGLES = {"known_feet": 6.0, "identified": 7.0, "uniform": 15.0, "known_feet_ellipsoid": 12.0,
          "uniform_ellipsoid": 14.0, "fitted_quartic": 8.0, "fitted_ellipsoid": 10.0}  # fmt: skip
QUANTITIES = {"wrench": 0.5, "motion": 1.0, "pose": 0.25}
#: Models without the feet of an object.
OTHERS = [name for name in ANGLES if "known" not in name]
#: Models without forces.
BY_POSES = [name for name in OTHERS if name != "fitted_quartic"]
#: Ratios of the identified pressure to a rival.
RATIOS = {
    "ratio": 0.85, "ratio_interval": [0.75, 1.25], "ratio_90": 0.95, "ratio_90_interval": [0.7, 1.5],
    "splits_below_one": 0.75, "smallest": 0.7, "largest": 1.3,
}  # fmt: skip
#: Those to the quartic, the ellipsoid, and the known feet.
AGAINST = {
    rival: {name: RATIOS | {"ratio": ratio} for name in QUANTITIES}
    for rival, ratio in (("fitted_quartic", 0.85), ("fitted_ellipsoid", 0.7), ("known_feet", 0.95))
}

#: An identified pressure that is worse than the ellipsoid.
WORSE = {"identified": {"median": 2.8, "percentile_90": 7.0, "ratio": 1.05,
                        "ratio_interval": [0.9, 1.2]}}  # fmt: skip


def compared(models, quantities=QUANTITIES, factor=1.0):
    """The comparison of a part: statistics by quantity and model."""
    reference = ANGLES["fitted_ellipsoid"]
    return {
        quantity: {
            name: {
                "median": factor * scale * ANGLES[name],
                "median_interval": [
                    0.8 * factor * scale * ANGLES[name],
                    1.1 * factor * scale * ANGLES[name],
                ],
                "percentile_90": 2.5 * factor * scale * ANGLES[name],
                "percentile_90_interval": [
                    2.0 * factor * scale * ANGLES[name],
                    3.0 * factor * scale * ANGLES[name],
                ],
                "ratio_90": ANGLES[name] / reference,
                "ratio_90_interval": [
                    0.8 * ANGLES[name] / reference,
                    1.2 * ANGLES[name] / reference,
                ],
                "ratio": ANGLES[name] / reference,
                "ratio_interval": [0.9 * ANGLES[name] / reference, 1.1 * ANGLES[name] / reference],
            }
            for name in models
        }
        for quantity, scale in quantities.items()
    }


def log(feet, support, outline, weight, pushes=50):
    """What a log tells: a support of points with fractions."""
    center = np.average([each[:2] for each in support], axis=0, weights=[f for *_, f in support])
    x, y = map(float, center)
    return {
        "pushes": pushes, "true_feet": feet, "outline": outline, "support": support, "feet": support,
        "weight": weight, "weight_interval": None if weight is None else [0.95 * weight, 1.05 * weight],
        "contact_friction": 0.25, "center_of_pressure": [x, y], "spin_torque": 44.0,
        "true_spin_torque": None if feet is None else 45.0,
        "intervals": {"center_of_pressure_x": [x - 3.0, x + 2.0],
                      "center_of_pressure_y": [y - 1.0, y + 4.0]},
    }  # fmt: skip


def _three_feet(places):
    """A log of three feet, each found as two points."""
    feet = [[x, y, f] for (x, y), f in zip(places, (0.25, 0.25, 0.5), strict=True)]
    found = [[x + s, y + 2.0, f / 2] for x, y, f in feet for s in (-3.0, 6.0)]
    return log(feet, found, OUTLINE, 4.5)


def measured_pushes():
    """Everything that the file holds."""
    face = [[10.0 + 25 * i, 10.0 + 25 * j, 1 / 15] for i in range(5) for j in range(5 - i)]
    pose = {"pose": QUANTITIES["pose"]}
    return {
        "source": {"three_feet": "one work", "polygons": "another work"},
        "command": "snakemake measured_pushes --config data=FOLDER", "seed": 0,
        "splits": 50, "polygon_splits": 1,
        "three_feet": {
            "selection": "every push with a force", "pushes": 200, "length": 50.0,
            "logs": {name: _three_feet(places) for name, places in FEET.items()},
            "comparison": compared(ANGLES), "against": AGAINST,
        },
        "patch": {
            "selection": "every push with a force", "pushes": 50, "length": 50.0,
            "logs": {"patch": log(None, face, OUTLINE, 4.25)},
            "comparison": compared(OTHERS, factor=1.5), "against": AGAINST,
        },
        "polygons": {
            "selection": "pushes that touch the object", "pushes": 340, "corner_pushes": 40,
            "length": {"abs_rect1": 37.0, "abs_hex": 40.0},
            "comparison": compared(BY_POSES, pose),
            "with_corners": compared(BY_POSES, pose, 1.25),
            "objects": {
                name: compared(BY_POSES, pose, factor)["pose"] | worse
                for name, factor, worse in (("abs_rect1", 1.0, {}), ("abs_hex", 1.1, WORSE))
            },
        },
        "about_a_foot": {
            "distance": 5.0, "tolerance": 0.2, "pushes": 60, "in_load_set": 0.75, "of_random_pushes": 0.25,
        },
    }  # fmt: skip
