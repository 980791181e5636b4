"""Pictures that a user asks for: of scenes, logs, solutions and supports."""

import base64
import io
import os
import subprocess
import sys

import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray as xr
from drawing.conftest import OTHERS
from drawing.scenes import INERTIA, NO_ADHESION, RING, ROUGH, coulomb, scene
from matplotlib.colors import same_color
from matplotlib.figure import Figure
from mechanics.supports.cases import SUPPORTS
from numpy.testing import assert_allclose
from PIL import Image

import planar_pushing as pp
from planar_pushing.drawing import over_time
from planar_pushing.drawing.animate import resample, status
from planar_pushing.drawing.canvas.colors import FORCE, GUIDE, IMPACT
from planar_pushing.drawing.timeline import impacts, path_data, pivots
from planar_pushing.mechanics import pictures
from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.terms import extras

SLIDER = scene(coulomb(2))
ANGLE = np.deg2rad(-10)
#: Its solutions, as errors list them.
NUMBERS = "0 (SEPARATE), 1 (STICK), 2 (SLIP_LEFT)"


@pytest.fixture(autouse=True)
def _closed():
    yield
    plt.close("all")


def words(ax):
    return [text.get_text() for text in ax.texts]


def filled(ax, color):
    return [patch for patch in ax.patches if same_color(patch.get_facecolor(), color)]


# -- scenes ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("contact", "angle", "title"),
    [
        (NO_ADHESION, 165, "No motion of the slider is consistent with this push."),
        (coulomb(2), -90, "The contact breaks."),
        (coulomb(2), 100, "The contact sticks."),
        (coulomb(2), 170, "The contact slips to the right."),
        (coulomb(2), -10, "The contact sticks while being pulled; two other solutions: the contact breaks, "
         "or slips to the left while being pulled."),
        (ROUGH, -90, "The contact sticks, held by adhesion; one other solution: the contact breaks."),
    ],
)  # fmt: skip
def test_a_push_is_told_in_words_over_a_scale(contact, angle, title):
    ax = pp.draw(scene(contact), np.deg2rad(angle))
    assert ax.get_title().replace("\n", " ") == title
    (length,) = (float(word) for word in words(ax) if word.replace(".", "").isdigit())
    (bar,) = (line for line in ax.lines if (line.get_color(), line.get_linewidth()) == (GUIDE, 1.6))
    assert np.ptp(bar.get_xdata()) == pytest.approx(length)
    assert not ax.axison
    ax.figure.savefig(io.BytesIO(), format="png")
    frame = ax.figure.bbox
    for box in (text.get_window_extent() for text in (ax.title, *ax.texts)):
        assert frame.x0 <= box.x0 < box.x1 <= frame.x1
        assert frame.y0 <= box.y0 < box.y1 <= frame.y1


def test_a_scene_without_a_push_has_its_cones_alone():
    ax = pp.draw(SLIDER)
    assert ax.get_title() == ""
    assert not [word for word in words(ax) if "mathbf" in word]
    bare = pp.draw(SLIDER, cones=False)
    assert len(bare.patches) == len(ax.patches) - 2
    pushed = [pp.draw(SLIDER, ANGLE, cones=cones) for cones in (True, False)]
    assert len(pushed[1].patches) == len(pushed[0].patches) - 2


@pytest.mark.parametrize("angle", [None, ANGLE])
def test_the_limit_curve_is_drawn_where_it_is_asked_for(angle):
    curved, plain = (pp.draw(SLIDER, angle, limit_curve=given) for given in (True, False))
    assert len(curved.lines) == len(plain.lines) + 1
    with pytest.raises(
        pp.InvalidValue, match=r"limit_curve: .*leave the limit curve out, or list one effect"
    ):
        pp.draw(scene(coulomb(2), (RING, INERTIA)), angle, limit_curve=True)


def test_a_scene_is_drawn_on_given_axes():
    figure = Figure(figsize=(7, 3.4))
    left, right = figure.subplots(1, 2)
    assert pp.draw(SLIDER, ANGLE, ax=right) is right
    assert not left.patches
    assert right.patches
    assert not plt.get_fignums()
    figure.savefig(io.BytesIO(), format="png")


@pytest.mark.parametrize("which", [*enumerate(ContactMode(i) for i in (0, 1, 3))])
def test_a_solution_is_drawn_in_full_by_its_number_or_its_mode(which):
    found = pp.solve(SLIDER, ANGLE)
    for solution in which:
        ax = pp.draw(SLIDER, ANGLE, solution=solution)
        assert len(filled(ax, FORCE)) == (which[0] > 0)
        if which[0]:
            (arrow,) = filled(ax, FORCE)
            tip, force = arrow.get_xy()[1], found[which[0]].force
            assert tip / np.hypot(*tip) == pytest.approx(force / np.hypot(*force))
    said = ["contact breaks", "contact sticks", "contact slips to the left"][which[0]]
    assert ax.get_title().startswith(f"The {said}")


def test_the_magnitude_counts_where_friction_and_inertia_resist():
    own = scene(coulomb(2), (RING, INERTIA))
    for magnitude in (0.1, 5.0):
        (arrow,) = filled(pp.draw(own, 2.0, magnitude), FORCE)
        tip, force = arrow.get_xy()[1], pp.solve(own, 2.0, magnitude)[0].force
        assert tip / np.hypot(*tip) == pytest.approx(force / np.hypot(*force))


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"solution": 7}, f"solution: 7 given; allowed: {NUMBERS}; choose one of these, or leave it out"),
        ({"solution": ContactMode.SLIP_RIGHT}, f"given; allowed: {NUMBERS}; "),
        ({"pusher_angle": np.nan}, "pusher_angle: nan given; allowed: a finite number"),
        ({"pusher_magnitude": -1.0}, "pusher_magnitude: -1.0 given; allowed: "),
        ({"pusher_angle": None, "pusher_magnitude": -5}, "pusher_magnitude: -5 given; allowed: "),
        ({"pusher_angle": None, "solution": 7}, "solution: 7 given; allowed: None without pusher_angle"),
        ({"ax": 1}, "ax: 1 given; allowed: axes of matplotlib"),
        ({"cones": np.array([True, False])}, "cones: array([ True, False]) given; allowed: True or False"),
        ({"limit_curve": "no"}, "limit_curve: 'no' given; allowed: True or False"),
    ],
)  # fmt: skip
def test_what_cannot_be_drawn_is_one_line(options, said):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.draw(SLIDER, **{"pusher_angle": ANGLE} | options)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
    assert not plt.get_fignums()


def test_without_a_solution_none_can_be_chosen():
    with pytest.raises(pp.InvalidValue, match="allowed: none, because no solution is consistent"):
        pp.draw(scene(NO_ADHESION), np.deg2rad(165), solution=0)


@pytest.mark.parametrize("given", ["scene", None, "figure_08"])
def test_what_is_no_scene_is_refused(given):
    with pytest.raises(pp.InvalidValue, match=r"^scene: "):
        pp.draw(given)


MANY = pp.Scene(
    slider=pp.Slider(rod_length=xr.DataArray([1.0, 2.0], dims="rod_length"), rod_angle=0.8),
    contact=pp.Coulomb(1.0), effects=(pp.RingFriction(),),
)  # fmt: skip


def test_an_array_of_scenes_is_refused():
    with pytest.raises(pp.InvalidValue, match="allowed: ") as caught:
        pp.draw(MANY, 1.0)
    assert "\n" not in str(caught.value)


# -- logs --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "labels"),
    [("pulling", ["gap"]), ("pulling_lost", ["gap"]), ("slipping", ["slip"]), ("plate", [])],
)
def test_a_log_shows_what_varies(logs, name, labels):
    figure = pp.plot_log(logs[name])
    found = [ax.get_ylabel() for ax in figure.axes if ax.get_ylabel()]
    assert found[0].startswith("rod angle")
    assert found[1:] == labels
    figure.savefig(io.BytesIO(), format="png")


def test_a_log_is_drawn_on_a_given_figure(logs):
    figure = Figure(figsize=(3.4, 5.0))
    assert pp.plot_log(logs["slipping"], figure) is figure
    assert not plt.get_fignums()
    frames, below = figure.axes[:3], figure.axes[3:]
    left = {ax.get_position().x0 for ax in below}
    assert len(left) == 1  # below each other in a narrow figure, and below the frames
    assert min(ax.get_position().y0 for ax in frames) > max(ax.get_position().y1 for ax in below)


def test_an_impact_has_its_own_frame_and_is_marked_in_time(logs):
    log = logs["impact"]
    (row,) = impacts(log)
    figure = pp.plot_log(log)
    frames, below = figure.axes[:3], figure.axes[3:]
    assert ["impact" in words(ax) for ax in frames] == [False, True, False]
    assert [bool(filled(ax, IMPACT)) for ax in frames] == [False, True, False]
    titles = ["$t = 0$   approaches", "$t = 0.398$   impact", "$t = 3$   falls behind"]
    assert [title in words(ax) for title, ax in zip(titles, frames, strict=True)] == [True] * 3
    for ax in below:
        assert any(set(line.get_xdata()) == {float(log.time[row])} for line in ax.lines)
    assert legend(figure) == ["impact"]


def legend(figure):
    """Texts of the legends of a figure."""
    return [text.get_text() for found in figure.legends for text in found.get_texts()]


def test_a_choice_of_modes_has_a_bar_and_a_legend(logs):
    found = {name: legend(pp.plot_log(logs[name])) for name in ("pulling", "slipping")}
    assert found == {"pulling": ["more than one mode possible"], "slipping": []}


def test_pivots_are_a_bar_on_the_strip_with_a_legend(logs):
    motion, figure = path_data(logs["stool"]), pp.plot_log(logs["stool"])
    assert legend(figure) == ["pivots about a support point"]
    (span,) = pivots(motion)
    (bar,) = (patch for patch in figure.axes[-1].patches if patch.get_height() == over_time.PIVOT)
    times = motion.time.values[[span.start, span.stop]]
    assert (bar.get_x(), bar.get_x() + bar.get_width()) == pytest.approx(tuple(times))


# -- animations --------------------------------------------------------------------------------------


def test_frames_lie_between_rows(logs):
    motion = path_data(logs["slipping"])
    found = resample(motion, 8)
    assert_allclose(found.time, np.linspace(0, 3, 8))
    assert_allclose(found.path_rod_angle[[0, -1]], motion.path_rod_angle[[0, -1]])
    exact = np.rad2deg(np.arcsin(np.sin(np.pi / 4) - found.time * np.sin(np.deg2rad(165)) / 5))
    assert_allclose(found.path_rod_angle, exact, rtol=0, atol=1e-4)


def test_a_frame_says_what_the_contact_does(logs):
    motion = resample(path_data(logs["stool"]), 9)
    said = [status(motion, row) for row in range(9)]
    assert said[0] == said[-1] == "stick"
    assert "slip left, pivots" in said
    assert status(path_data(logs["pulling"]), 80) == "stick (one of several)"


def test_the_background_of_an_animation_is_white(logs):
    with Image.open(io.BytesIO(pp.animate(logs["box"], frames=2).gif)) as image:
        assert image.convert("RGB").getpixel((2, image.height - 2)) == (255, 255, 255)


@pytest.mark.parametrize("name", OTHERS)
def test_any_support_is_animated_in_a_notebook_or_a_file(logs, tmp_path, name):
    path = tmp_path / "motion.gif"
    found = pp.animate(logs[name], path, frames=4, frames_per_second=10)
    assert found.frames == 4
    assert (
        pp.animate(logs[name], frames=4, frames_per_second=10.0).gif
        == found.gif
        == path.read_bytes()
    )
    start, _, data = found._repr_html_().partition("base64,")
    assert start.startswith("<img alt=")
    assert base64.b64decode(data.partition('"')[0]) == found.gif
    frames = set()
    with Image.open(path) as image:
        assert (image.format, image.n_frames, image.info["duration"]) == ("GIF", 4, 100)
        for number in range(4):
            image.seek(number)
            frames.add(np.asarray(image.convert("RGB")).tobytes())
    assert len(frames) == 4


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"path": "a.webm"},
         "output: 'a.webm' given; allowed: a name ending in .gif or, with the program ffmpeg, in .mp4; "),
        ({"path": 1}, "path: 1 given; allowed: the path of a file"),
        ({"frames": 1}, "frames: 1 given; allowed: a whole number from 2 to 1000; choose another number"),
        ({"frames_per_second": 0.0},
         "frames_per_second: 0.0 given; allowed: a number in (0, 50]; slow it down"),
    ],
)  # fmt: skip
def test_wrong_options_of_an_animation_are_one_line(logs, options, said):
    with pytest.raises(pp.InvalidValue) as caught:
        pp.animate(logs["slipping"], **options)
    assert str(caught.value).startswith(said)
    assert "\n" not in str(caught.value)


@pytest.fixture
def ffmpeg(tmp_path, monkeypatch):
    """Put a program that stands for ffmpeg on the path, a shell script."""

    def install(script):
        program = tmp_path / "bin/ffmpeg"
        program.parent.mkdir()
        program.write_text(f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)
        monkeypatch.setenv("PATH", f"{program.parent}:{os.defpath}")

    return install


def test_a_video_is_what_ffmpeg_makes_of_the_animation(logs, ffmpeg, tmp_path):
    ffmpeg('for file; do :; done; cat > "$file"; echo "$@" > "$0.txt"')
    found = pp.animate(logs["slipping"], tmp_path / "a.MP4", frames=2)
    found.save(tmp_path / "b.mp4")
    assert (tmp_path / "a.MP4").read_bytes() == (tmp_path / "b.mp4").read_bytes() == found.gif
    words = (tmp_path / "bin/ffmpeg.txt").read_text().split()
    assert words[words.index("-i") - 2 :][:4] == ["-f", "gif", "-i", "pipe:0"]
    assert words[-3:-1] == ["-f", "mp4"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.MP4", "b.mp4", "bin"]


def test_a_video_that_fails_is_one_line_and_no_file(logs, ffmpeg, tmp_path):
    ffmpeg("echo first >&2; echo 'Unknown encoder' >&2; exit 1")
    animation = pp.animate(logs["slipping"], frames=2)
    with pytest.raises(pp.InvalidFile) as caught:
        animation.save(tmp_path / "b.mp4")
    assert str(caught.value) == (
        f"{tmp_path / 'b.mp4'}: ffmpeg: Unknown encoder; update ffmpeg, or give a name ending in .gif"
    )
    assert [path.name for path in tmp_path.iterdir()] == ["bin"]


def test_without_ffmpeg_a_video_is_refused_before_a_frame_is_drawn(logs, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    animation = pp.animate(logs["slipping"], frames=2)
    monkeypatch.setattr("planar_pushing.drawing.animate._pictures", None)
    said = (
        "allowed: a name ending in .gif, since the program ffmpeg is not found; install ffmpeg, or"
    )
    for write in (animation.save, lambda path: pp.animate(logs["slipping"], path)):
        with pytest.raises(pp.InvalidValue, match=said):
            write(tmp_path / "b.mp4")
    animation.save(tmp_path / "b.gif")
    assert (tmp_path / "b.gif").read_bytes() == animation.gif


@pytest.mark.parametrize("function", [pp.animate, pp.plot_log])
@pytest.mark.parametrize("given", [None, "log.nc"])
def test_what_is_no_log_is_one_line(function, given):
    with pytest.raises(
        pp.InvalidValue, match=r"^log: .* given; allowed: a dataset returned by simulate"
    ):
        function(given)


# -- notebooks ---------------------------------------------------------------------------------------


def pictured():
    """SVG of every kind of object that has a picture."""
    yield "scene", SLIDER._repr_svg_()
    yield "solutions", pp.solve(SLIDER, ANGLE)._repr_html_()
    for name, (support, _) in SUPPORTS.items():
        yield name, support._repr_svg_()


def test_objects_have_pictures_in_a_notebook():
    for name, found in pictured():
        assert found.count("<svg") == found.count("</svg>") == 1, name
        assert "nan" not in found
        assert ("<table" in found) == (name == "solutions")


def test_solutions_have_the_picture_of_their_push():
    found = pp.solve(SLIDER, ANGLE)
    html = found._repr_html_()
    assert html.index("<svg") < html.index(f"<p>{found._title}</p>") < html.index("<table")
    none = pp.solve(scene(NO_ADHESION), np.deg2rad(165))._repr_html_()
    assert "<svg" in none
    assert "<table" not in none


def test_without_matplotlib_there_is_a_table_and_no_picture(monkeypatch):
    monkeypatch.setattr(extras, "find_spec", lambda name: None)
    for name in ("planar_pushing.drawing", "planar_pushing.drawing.scene"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    for name, found in pictured():
        assert "<svg" not in (found or ""), name
        assert (found is None) == (name != "solutions")
    with pytest.raises(pp.PlanarPushingError, match="install the extra figures"):
        import planar_pushing.drawing.scene  # noqa: F401


def test_pictures_after_a_plain_import():
    code = (
        "import sys, planar_pushing as pp; disc = pp.Disc(1.0); print('matplotlib' in sys.modules, "
        "disc._repr_svg_().count('<svg'))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "False 1\n"


def test_pictures_are_those_that_are_registered(monkeypatch):
    monkeypatch.setattr(pictures, "LOADERS", [])
    monkeypatch.setattr(pictures, "PICTURES", {})
    for name, found in pictured():
        assert "<svg" not in (found or ""), name
    monkeypatch.setattr(
        pictures,
        "LOADERS",
        [lambda: pictures.PICTURES.update(support=lambda of: f"<svg>{of}</svg>")],
    )
    disc = pp.Disc(1.0)
    assert disc._repr_svg_() == f"<svg>{disc}</svg>"
    assert SLIDER._repr_svg_() is None
