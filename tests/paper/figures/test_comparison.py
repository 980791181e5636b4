"""Errors of models on measured pushes: `plot_comparison`, and the figures of the report."""

from itertools import combinations

import numpy as np
import pytest
import xarray as xr
from drawing.test_colors import contrast, distance, lightness
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from report.pushes import measured_pushes

import planar_pushing as pp
from planar_pushing.drawing import comparison
from planar_pushing.drawing.canvas.marks import Area, Dot, Line
from planar_pushing.drawing.comparison import LOOKS, looks
from planar_pushing.terms.errors import InvalidFile, InvalidValue
from pulling_by_pushing.figures.evidence import measured_errors, measured_pressures
from pulling_by_pushing.figures.figure import view
from pulling_by_pushing.figures.measured import PUSHES_FILE, read_pushes


def compared(
    models=("known_feet", "uniform", "mine_too", "fitted_ellipsoid"), quantities=("motion", "pose")
):
    """A comparison as `compare` returns it, with known numbers; wrenches were not measured."""
    names = ["wrench", *quantities]
    shape = (len(names), len(models))
    median = np.arange(1.0, 1.0 + np.prod(shape)).reshape(shape)
    median[0] = np.nan
    ratio = median / median[:, -1:]
    ends = np.array([0.9, 1.2])
    cell = ("quantity", "model")
    return xr.Dataset(
        {
            "median": (cell, median), "percentile_90": (cell, 3 * median), "ratio": (cell, ratio),
            "median_interval": ((*cell, "bound"), median[..., None] * ends),
            "ratio_interval": ((*cell, "bound"), ratio[..., None] * ends),
        },
        {"quantity": names, "model": list(models)}, {"pose_units": "mm", "angle_units": "degree"},
    )  # fmt: skip


def drawn(ax):
    """Median, interval and 90th percentile of each row, from its marks."""
    found = {}
    for line in ax.lines:
        x, row = np.asarray(line.get_xdata(), float), int(line.get_ydata()[0])
        kind = line.get_marker()
        if kind == "|":
            found.setdefault(row, {})["most"] = x[0]
        elif kind != "None":
            found.setdefault(row, {})["median"] = x[0]
        elif line.get_linewidth() > 2:
            found.setdefault(row, {})["ends"] = x.tolist()
    return found


def ratios(ax):
    return {round(each.xy[1]): each.get_text() for each in ax.texts if each.get_text() != "ratio"}


def test_a_panel_for_each_quantity_that_has_values():
    axes = pp.plot_comparison(compared())
    assert [ax.get_title() for ax in axes] == ["motion from force (degrees)", "final pose (mm)"]
    assert [label.get_text() for label in axes[0].get_yticklabels()] == [
        "known feet", "uniform pressure", "mine too", "fitted ellipsoid"
    ]  # fmt: skip
    assert not any(label.get_text() for label in axes[1].get_yticklabels())


def test_marks_are_the_numbers():
    data = compared()
    for ax, quantity in zip(pp.plot_comparison(data), ("motion", "pose"), strict=True):
        one = data.sel(quantity=quantity)
        found = drawn(ax)
        for row in range(one.sizes["model"]):
            median = float(one["median"][row])
            assert found[row]["median"] == median
            assert found[row]["most"] == 3 * median
            assert found[row]["ends"] == pytest.approx([0.9 * median, 1.2 * median], rel=1e-12)
        assert ax.get_ylim()[0] > ax.get_ylim()[1]  # the first model stands on top


def test_ratios_are_written_with_their_intervals():
    data = compared()
    axes = pp.plot_comparison(data)
    assert ratios(axes[0])[0] == "0.62 (0.56\N{EN DASH}0.75)"  # 5 / 8
    data["ratio_interval"][:] = 1.0
    assert ratios(pp.plot_comparison(data)[0])[3] == "1.00"
    assert ratios(pp.plot_comparison(data.drop_vars("ratio_interval"))[0])[0] == "0.62"


def test_a_model_without_a_value_has_no_row():
    data = compared()
    data["median"].loc[{"quantity": "motion", "model": "known_feet"}] = np.nan
    axes = pp.plot_comparison(data)
    assert len(axes[0].get_yticks()) == 3
    assert len(axes[1].get_yticks()) == 4


def test_axes_of_ones_own():
    figure = Figure()
    given = figure.subplots(1, 2)
    assert pp.plot_comparison(compared(), given) == list(given)
    assert all(ax.get_yticklabels()[0].get_text() == "known feet" for ax in given)
    one = pp.plot_comparison(compared().sel(quantity=["pose"]), given[0])
    assert one == [given[0]]


def test_the_comparison_of_simulated_pushes_is_drawn():
    support = pp.SupportFriction(support=pp.Points([(-30, -30), (30, -30), (0, 30)], [1, 1, 1]))
    square = [(-50, -50), (50, -50), (50, 50), (-50, 50)]
    pushes = pp.simulate_pushes((support,), square, 16, noise=None, seed=1)
    found = pp.compare(pushes, ["uniform"], resamples=20)
    axes = pp.plot_comparison(found)
    assert all(isinstance(ax, Axes) for ax in axes)
    medians = [each["median"] for each in drawn(axes[-1]).values()]
    shown = found["median"].sel(quantity="pose").values
    assert medians == pytest.approx(shown[np.isfinite(shown)], rel=1e-12)


@pytest.mark.parametrize(
    ("given", "ax", "said"),
    [
        ("a", None, "dataset: 'str' given; allowed: a dataset returned by compare; call compare on pushes"),
        (xr.Dataset(), None, "dataset: 'one without median' given; allowed: a dataset returned by compare"),
        (compared().drop_vars("model"), None, "'one without model' given"),
        (compared() * np.nan, None, "dataset: 'no errors' given; allowed: errors of a model"),
        (compared(), Figure().subplots(), "ax: '1 axes' given; allowed: 2 axes, for motion, pose"),
        (compared(), [1, 2], "ax: '2 axes' given"),
    ],
)  # fmt: skip
def test_wrong_input_is_one_line(given, ax, said):
    with pytest.raises(InvalidValue) as caught:
        pp.plot_comparison(given, ax)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


# -- looks -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("one", "other"), [*combinations(LOOKS.values(), 2)])
def test_models_differ_in_gray_and_for_a_deuteranope(one, other):
    assert abs(lightness(one.color) - lightness(other.color)) >= 3 or one.marker != other.marker
    assert distance(one.color, other.color) >= 10
    assert one.name != other.name


def test_models_have_contrast_and_every_model_of_compare_a_look():
    from planar_pushing.pushes.models import MODELS

    assert list(LOOKS) == list(MODELS)
    assert all(contrast(each.color) >= 3 for each in LOOKS.values())
    others = looks(["a", "b", "c"])
    assert (
        len({each.color for each in others.values()} | {each.color for each in LOOKS.values()})
        == 10
    )


# -- pressures ---------------------------------------------------------------------------------------


def circles(marks, kind):
    """Middle and radius of the discs or rings among marks."""
    found = []
    for mark in marks:
        points = (
            mark.rings[0]
            if kind is Area and isinstance(mark, Area)
            else getattr(mark, "points", None)
        )
        if isinstance(mark, kind) and points is not None and len(points) == 49:
            middle = points[:-1].mean(axis=0)
            found.append((*middle, np.hypot(*(points[0] - middle))))
    return np.array(found).reshape(-1, 3)


def of_panel(picture, number):
    return [mark for ax, mark, _ in picture.drawn if ax is picture.axes[number]]


def test_areas_are_fractions_of_the_weight(pictures, plotted):
    logs = list(measured_pressures.logs(plotted["measured_pressures"]).values())
    assert len(pictures["measured_pressures"].axes) == len(logs) + 1
    for number, log in enumerate(logs):
        marks = of_panel(pictures["measured_pressures"], number)
        for key, kind, color in (
            ("support", Area, None),
            ("true_feet", Line, measured_pressures.TRUE),
        ):
            shown = circles([m for m in marks if color in (None, getattr(m, "color", None))], kind)
            given = np.array(log[key] or []).reshape(-1, 3)
            assert shown[:, :2] == pytest.approx(given[:, :2], abs=1e-9)
            whole = measured_pressures.FULL * 150.0
            assert shown[:, 2] ** 2 == pytest.approx(whole**2 * given[:, 2], rel=1e-9)


def test_centers_and_intervals_are_enlarged_within_their_frame(pictures, plotted):
    data = plotted["measured_pressures"]
    zoom = measured_pressures.enlargement(data)
    assert zoom >= 1
    for number, log in enumerate(measured_pressures.logs(data).values()):
        marks = of_panel(pictures["measured_pressures"], number)
        low, high = measured_pressures._window(log)
        true, found = (
            np.array(
                [
                    m.position
                    for m in marks
                    if isinstance(m, Dot) and (m.shape == "pressure") == cross
                ]
            )
            for cross in (True, False)
        )
        assert true[0] == pytest.approx(measured_pressures.reference(log))
        assert found[0] == pytest.approx(log["center_of_pressure"])
        assert found[1] - true[1] == pytest.approx(zoom * (found[0] - true[0]))
        bars = [
            m.points
            for m in marks
            if isinstance(m, Line) and m.color == measured_pressures.IDENTIFIED and m.width > 0.8
        ]
        assert len(bars) == 2
        for axis, (bar, name) in enumerate(zip(bars, "xy", strict=True)):
            ends = np.array(log["intervals"][f"center_of_pressure_{name}"])
            assert bar[:, axis] - found[1][axis] == pytest.approx(zoom * (ends - found[0][axis]))
            assert ((bar >= low) & (bar <= high)).all()


def test_a_far_center_is_enlarged_less(plotted):
    data = measured_pushes()
    whole = measured_pressures.enlargement(data)
    data["patch"]["logs"]["patch"]["center_of_pressure"] = [75.0, 50.0]
    data["patch"]["logs"]["patch"]["intervals"]["center_of_pressure_x"] = [70.0, 80.0]
    assert 1 <= measured_pressures.enlargement(data) < whole


def test_the_true_center_is_that_of_the_feet_or_of_the_face():
    log = next(iter(measured_pushes()["three_feet"]["logs"].values()))
    assert measured_pressures.reference(log) == pytest.approx([45.0, 60.0])  # 1/4, 1/4, 1/2
    assert measured_pressures.reference(log | {"true_feet": None}) == pytest.approx([50.0, 50.0])


def test_the_caption_tells_each_log():
    data = measured_pushes()
    told = measured_pressures.caption(data)
    assert "(a) feet at (30, 30), (90, 30), (30, 90) mm, 50 pushes: centers 2.5 mm apart" in told
    assert "mean distance from the center 44 (true: 45) mm" in told
    assert "(e) on the whole face, 50 pushes" in told
    data["patch"]["logs"]["patch"]["pushes"] = 47
    assert "(e) on the whole face, 47 pushes" in measured_pressures.caption(data)


# -- errors ------------------------------------------------------------------------------------------


def test_the_panels_of_the_errors_are_the_comparisons(pictures, plotted):
    data = plotted["measured_errors"]
    rows = measured_errors.parts(data)
    for row in rows:
        medians = row[0].errors["median"].values.ravel()
        assert (np.diff(medians) >= 0.0).all()
        assert all((part.errors["model"] == row[0].errors["model"]).all() for part in row)
    parts = [part for row in rows for part in row]
    axes = pictures["measured_errors"].axes
    assert len(axes) == len(parts) == 8
    for ax, part in zip(axes, parts, strict=True):
        quantity = str(part.errors["quantity"].item())
        given = data[part.group.part][part.group.key][quantity]
        models = [str(name) for name in part.errors["model"].values]
        assert sorted(models) == sorted(name for name in LOOKS if name in given)
        for name, shown in zip(models, drawn(ax).values(), strict=True):
            assert shown["median"] == given[name]["median"]
            assert shown["most"] == given[name]["percentile_90"]
            assert shown["ends"] == given[name]["median_interval"]
        assert "0.70 (0.63\N{EN DASH}0.77)" in ratios(ax).values()


def test_models_that_the_first_panel_lacks_are_after_the_others():
    data = measured_pushes()
    alone = data["polygons"]["with_corners"]["pose"]
    alone["known_feet"] = dict(alone["uniform"])
    (*_, row) = measured_errors.parts(data)
    first, second = (part.errors.model.values.tolist() for part in row)
    assert "known_feet" not in first
    assert second == [*first, "known_feet"]


def test_the_caption_counts_the_pushes():
    data = measured_pushes()
    data["three_feet"]["pushes"], data["polygons"]["corner_pushes"] = 123, 41
    told = measured_errors.caption(data)
    assert "three feet (123 pushes)" in told
    assert "at a side (299), or at a side or a corner (340)" in told


# -- the file ----------------------------------------------------------------------------------------


def test_the_figures_show_the_content_of_the_file():
    assert view("measured_errors", "results") == read_pushes(PUSHES_FILE)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (None, "no such file; write it again with snakemake pushes --config data=FOLDER"),
        ("{", "is not JSON"),
        ("[]", "lacks three_feet; allowed: three_feet, patch, polygons, about_a_foot"),
        ('{"three_feet": {}, "patch": {}}', "lacks polygons"),
    ],
)
def test_a_wrong_file_is_one_line(tmp_path, text, said):
    path = tmp_path / "pushes.json"
    if text is not None:
        path.write_text(text, encoding="utf-8")
    with pytest.raises(InvalidFile) as caught:
        read_pushes(path)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_quantities_are_those_of_compare():
    from planar_pushing.pushes.fit.scores import QUANTITIES

    assert tuple(comparison.QUANTITIES) == QUANTITIES
