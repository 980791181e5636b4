import io
from contextlib import chdir
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.colors import same_color
from matplotlib.figure import Figure
from matplotlib.patches import ArrowStyle, FancyArrowPatch

from planar_pushing.figures import render, style
from planar_pushing.figures.parts.scene import draw_scene
from planar_pushing.figures.parts.sketch import Sketch, shown
from planar_pushing.figures.scene_picture import render_scene
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.study.datasets import motion_cones, scenes
from planar_pushing.study.figures import FIGURES
from planar_pushing.study.figures.base import COLUMN_WIDTH, PAGE_WIDTH
from planar_pushing.study.models import FigureEntry, Grid, PushEntry
from planar_pushing.study.scene_model import SceneFile
from planar_pushing.study.store import write_dataset
from planar_pushing.study.study_file import load_study

ROOT = Path(__file__).parents[2]
NAMES = ("figure_01", "figure_02", "figure_03", "figure_04", "figure_08", "figure_09", "figure_11")
FILLED, OPEN = (ArrowStyle.get_styles()[each] for each in ("-|>", "->"))


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """Results folder with the datasets that the scene figures read."""
    folder = tmp_path_factory.mktemp("results")
    with chdir(ROOT):
        study = load_study("workflow/config/paper.yaml")
        write_dataset(scenes.build(study), folder / "data" / "scenes.nc")
    grid = Grid.model_construct(
        effects=("support_friction",),
        rod_length=(2.0, 3.0),
        rod_angle=(45.0,),
        friction_coefficient=(0.5, 2.0),
    )
    cones = motion_cones.build(study.model_copy(update={"grid": grid}))
    write_dataset(cones, folder / "data" / "motion_cones.nc")
    return folder


@pytest.fixture
def data(results, request):
    return render.select(request.param, results, FigureEntry())


@pytest.fixture
def picture(results, request):
    with style.paper_style():
        data = render.select(request.param, results, FigureEntry())
        figure = render.picture(request.param, data)
        figure.savefig(io.BytesIO(), format="png", dpi="figure")
        yield figure


def arrows(figure):
    return [p for ax in figure.axes for p in ax.patches if isinstance(p, FancyArrowPatch)]


@pytest.mark.parametrize("data", NAMES, indirect=True)
def test_the_data_are_numbers_with_units_and_names(data):
    for name, variable in data.variables.items():
        assert {"units", "long_name"} <= set(variable.attrs), name
        assert variable.dtype.kind in "fiU", name
        assert variable.dtype.kind != "f" or not np.isnan(variable.values).any(), name
    assert data.attrs["title"]


@pytest.mark.parametrize("name", NAMES)
def test_rendering_twice_gives_the_same_bytes(results, tmp_path, name):
    for folder in (tmp_path / "a", tmp_path / "b"):
        paths = {kind: folder / f"{name}.{kind}" for kind in ("svg", "pdf", "png")}
        render.render(name, results, FigureEntry(), data=folder / f"{name}.nc", **paths)
    for path in sorted((tmp_path / "a").iterdir()):
        assert path.read_bytes() == (tmp_path / "b" / path.name).read_bytes(), path.name
    assert len(list((tmp_path / "a").iterdir())) == 4


@pytest.mark.parametrize("picture", NAMES, indirect=True)
def test_forces_have_filled_heads_and_motions_open_ones(picture):
    drawn = arrows(picture)
    assert drawn
    for patch in drawn:
        is_force = same_color(patch.get_edgecolor(), style.FORCE)
        assert type(patch.get_arrowstyle()) is (FILLED if is_force else OPEN)


@pytest.mark.parametrize("picture", NAMES, indirect=True)
def test_the_axes_have_equal_aspect(picture):
    for ax in picture.axes:
        (x, y), origin = ax.transData.transform([(1, 1), (0, 0)])
        assert x - origin[0] == pytest.approx(y - origin[1])


@pytest.mark.parametrize("picture", NAMES, indirect=True)
def test_no_label_covers_another_or_is_clipped(picture):
    frame = picture.bbox
    boxes = [text.get_window_extent() for ax in picture.axes for text in ax.texts]
    assert boxes
    for number, box in enumerate(boxes):
        assert not any(box.overlaps(other) for other in boxes[:number])
        assert frame.x0 <= box.x0 < box.x1 <= frame.x1
        assert frame.y0 <= box.y0 < box.y1 <= frame.y1


@pytest.mark.parametrize("name", NAMES)
def test_the_caption_and_the_size_suit_a_column_or_a_page(name):
    assert FIGURES[name].size[0] in (COLUMN_WIDTH, PAGE_WIDTH)
    assert FIGURES[name].caption.endswith(".")


@pytest.mark.parametrize("data", ["figure_02"], indirect=True)
def test_figure_02_pushes(data):
    assert data["mode"].values == [ContactMode.STICK]
    assert data["contact_motion"].sel(xy="y").item() > 0


@pytest.mark.parametrize("data", ["figure_03"], indirect=True)
def test_figure_03_pulls_with_a_force_into_the_slider(data):
    assert data["mode"].values == [ContactMode.STICK]
    assert data["contact_motion"].sel(xy="y").item() < 0
    assert data["force"].sel(xy="y").item() > 0


@pytest.mark.parametrize("data", ["figure_02", "figure_03"], indirect=True)
def test_the_support_friction_that_is_drawn_balances_the_force(data):
    pull = data["support_force"].isel(solution=0).mean("support_angle").values * 2 * np.pi
    assert -pull == pytest.approx(data["force"].values[0], abs=0.03)


@pytest.mark.parametrize("data", ["figure_08"], indirect=True)
def test_figure_08_slips_to_the_right_with_the_force_on_the_left_edge(data):
    assert data["mode"].values == [ContactMode.SLIP_RIGHT]
    force, motion = data["force"].values[0], data["contact_motion"].values[0]
    assert force[0] < 0
    assert force[1] == 0
    angle = np.rad2deg(np.arctan2(motion[1], motion[0]))
    assert angle == pytest.approx(float(data["motion_cone_left"]))


@pytest.mark.parametrize("data", ["figure_09"], indirect=True)
def test_figure_09_has_the_duals_of_the_edges_on_one_line_of_centers(data):
    rod = np.array([np.cos(np.pi / 4), np.sin(np.pi / 4)])
    beyond = 2 + 1 / 2  # rod length, and squared radius of gyration over rod length
    for side in ("right", "left"):
        assert data[f"center_{side}"].values @ rod == pytest.approx([beyond, beyond])
    assert data["friction_coefficient"].values == pytest.approx([2, np.inf])


@pytest.mark.parametrize("data", ["figure_11"], indirect=True)
def test_figure_11_has_its_center_on_the_ring_and_its_line_of_force_tangent(data):
    sketch = Sketch.of(data)
    assert np.hypot(*(sketch.center - sketch.ring)) == pytest.approx(1)
    assert sketch.foot - sketch.ring == pytest.approx(sketch.ring - sketch.center)
    assert data["contact_motion"].sel(xy="y").item() < 0


RING = {"type": "ring_friction", "weight": 1}
INERTIA = {"type": "inertia", "mass": 1, "gyration_radius": 1}


def scene(contact, pusher_angle, *, effects=(RING,), magnitude=1.0, **slider):
    slider = {"rod_length": 2.0, "rod_angle": 45.0, "radius": 1.0} | slider
    file = SceneFile.model_validate({"slider": slider, "contact": contact, "effects": effects})
    push = PushEntry(file="", pusher_angle=pusher_angle, pusher_magnitude=magnitude)
    return scenes.scene_dataset(file, push)


def coulomb(mu):
    return {"law": "coulomb", "friction_coefficient": mu}


ROUGH = {"law": "perfectly_rough"}
NO_ADHESION = {"law": "infinite_friction", "at_zero_normal": "none"}


@pytest.mark.parametrize(
    ("contact", "angle", "mode"),
    [
        (coulomb(2), -10, [ContactMode.STICK]),
        (coulomb(2), 170, [ContactMode.SLIP_RIGHT]),
        (coulomb(2), -90, [ContactMode.SEPARATE]),
        (NO_ADHESION, 165, []),
    ],
)
def test_a_sticking_solution_is_shown_else_one_that_moves(contact, angle, mode):
    data = shown(scene(contact, angle))
    assert data["mode"].values.tolist() == mode
    assert data.identical(shown(data))


def texts(dataset):
    ax = draw_scene(Figure(figsize=(3.4, 3.4)), dataset)
    return " ".join([ax.get_title(), *(text.get_text() for text in ax.texts)])


@pytest.mark.parametrize(
    ("dataset", "words"),
    [
        (scene(NO_ADHESION, 165), "no consistent solution"),
        (scene(coulomb(2), -90), "the contact breaks"),
        (scene(coulomb(2), -10), "the contact sticks (one of several solutions)"),
        (scene(ROUGH, -90), "(adhesive)"),
        (scene(coulomb(2), 44.9), "radii away"),
        (scene(coulomb(2), 60, effects=(INERTIA,)), r"\mathbf{a}_s = \mathbf{a}_p"),
        (scene(coulomb(2), 60), r"\mathbf{v}_s = \mathbf{v}_p"),
    ],
)
def test_the_picture_says_what_it_shows(dataset, words):
    assert words in texts(dataset)


def test_a_translation_has_no_center():
    assert "centre" not in texts(scene(coulomb(1), 90, rod_length=0.0))


def test_a_scene_is_drawn_on_given_axes():
    figure = Figure(figsize=(7, 3.4))
    left, right = figure.subplots(1, 2)
    draw_scene(right, scene(coulomb(2), 100))
    assert not left.patches
    assert right.patches
    figure.savefig(io.BytesIO(), format="png")


@pytest.mark.parametrize("kind", ["svg", "pdf", "png"])
def test_a_scene_file_is_drawn(tmp_path, kind):
    path = tmp_path / f"scene.{kind}"
    file = SceneFile.model_validate(
        {"slider": {"rod_length": 2, "rod_angle": 45}, "contact": ROUGH, "effects": [RING]}
    )
    render_scene(file, PushEntry(file="", pusher_angle=200), path)
    assert path.stat().st_size > 1000


LAWS = st.one_of(
    st.floats(0, 1e6).map(coulomb),
    st.just({"law": "infinite_friction"}),
    st.just(NO_ADHESION),
    st.just(ROUGH),
)


@settings(max_examples=40, deadline=None)
@given(
    contact=LAWS,
    angle=st.one_of(
        st.integers(-180_000, 180_000).map(lambda n: n / 1000),
        st.sampled_from([-180, -90, 0, 45, 90, 180]),
    ),
    effects=st.sampled_from([(RING,), (INERTIA,), (RING, INERTIA)]),
    magnitude=st.floats(1e-3, 1e3),
    rod_length=st.one_of(st.floats(0, 10), st.sampled_from([0.0, 1e-9, 1.0, 10.0])),
    rod_angle=st.floats(0.01, 179.99),
    radius=st.floats(1e-2, 1e2),
)
def test_any_scene_can_be_drawn(contact, angle, **rest):
    with style.paper_style():
        figure = Figure(figsize=(3.4, 3.4))
        draw_scene(figure, scene(contact, angle, **rest))
        figure.savefig(io.BytesIO(), format="png", dpi=50)
    assert all(np.all(np.isfinite(patch.get_path().vertices)) for patch in arrows(figure))
