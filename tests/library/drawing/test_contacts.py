"""Pictures of objects with several contacts."""

import matplotlib.pyplot as plt
import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.drawing.canvas.marks import Arrow, Hatch
from planar_pushing.drawing.contacts import ContactsPicture
from planar_pushing.drawing.files import contacts_picture
from planar_pushing.drawing.motion import wall_segments
from planar_pushing.drawing.timeline import path_data
from planar_pushing.scenes.contacts_files import load_contacts_file

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
FRICTION = [pp.SupportFriction(support=pp.Polygon(SQUARE))]


def touch(point, mu, velocity=(0, 0)):
    """A contact with Coulomb friction."""
    return pp.Contact(point, law=pp.Coulomb(mu), velocity=velocity)


@pytest.fixture(autouse=True)
def _close():
    yield
    plt.close("all")


@pytest.mark.parametrize(
    ("contacts", "words", "forces"),
    [
        ([touch((-1, 0.5), 0.2, (1, -0.5)), touch((0.3, -1), 0.2)], "contact 1 slips left", 2),
        # Two fingers that stick: the inner force has a range, and each contact two arrows.
        ([touch((-0.5, -1), 0.5, (0, 1)), touch((0.5, -1), 0.5, (0, 0.8))], "contact 2 sticks", 4),
        ([touch((-1, 0.3), 1.0, (1, 0)), touch((1, -0.4), 1.0)], "no motion: wedged", 0),
        ([touch((-1, 0.3), 1.0, (1, 0)), touch((1, 0.3), 1.0)], "no motion: jammed", 0),
    ],
)
def test_pictures_show_cones_forces_and_what_happens(contacts, words, forces):
    axes = pp.draw_contacts(contacts, effects=FRICTION, outline=SQUARE)
    assert words in axes.get_title()
    picture = ContactsPicture(contacts, FRICTION, SQUARE, 0)
    arrows = [mark for mark in picture.draw().marks if isinstance(mark, Arrow) and mark.filled]
    assert len(arrows) == forces
    low, high = picture.box()
    for arrow in arrows:
        assert (np.asarray(arrow.points) >= low - 1e-9).all()
        assert (np.asarray(arrow.points) <= high + 1e-9).all()


@pytest.mark.parametrize(
    ("options", "said"),
    [({"solution": 3}, "a number below 1"), ({"ax": 3}, "axes of matplotlib")],
)
def test_wrong_options_are_refused(options, said):
    contacts = [touch((-1, 0.5), 0.2, (1, -0.5)), touch((0.3, -1), 0.2)]
    with pytest.raises(pp.InvalidValue, match=said):
        pp.draw_contacts(contacts, effects=FRICTION, outline=SQUARE, **options)


def test_a_log_shows_the_walls_beside_the_slider():
    scene = pp.scene_at((-1, 0.5), outline=SQUARE, contact=pp.Coulomb(0.3), effects=FRICTION)
    pusher = pp.Pusher(velocity=(1, -0.1), shape="finger", frame="world")
    walls = [pp.Wall((0, -1), (0, 1), pp.Coulomb(0.2)), pp.Wall((900, 0), (-1, 0), pp.Coulomb(0.2))]
    log = pp.simulate(scene, pusher, duration=1.0, object_pose=(0, 0, 0), walls=walls)
    data = path_data(log)
    ((ends, normal),) = wall_segments(data, -1)
    # The wall is under the square's center, at half of its side.
    center = data["path_position"].values[-1]
    assert float((center - ends[0]) @ normal) == pytest.approx(1.0, abs=1e-9)
    assert len(pp.plot_log(log).axes) > 3


def test_the_picture_of_a_file_shows_its_walls_in_the_objects_frame(tmp_path):
    """The square is turned by 90 degrees and 0.5 above the ground, whose hatch is on its other side."""
    path = tmp_path / "scene.yaml"
    path.write_text(
        """\
object: {outline: [[-1, -1], [1, -1], [1, 1], [-1, 1]]}
contacts: [{point: [0, 1], law: perfectly_rough}]
effects: [{type: support_friction}]
simulate:
  pushers: [{shape: finger, angle: 90}]
  walls:
    - {point: [7, 0], normal: [0, 3], contact: {law: perfectly_rough}}
    - {point: [900, 0], normal: [-1, 0], contact: {law: perfectly_rough}}
  object_pose: {x: 5, y: 1.5, angle: 90}
  duration: 1
""",
        encoding="utf-8",
    )
    sketch = contacts_picture(load_contacts_file(path))
    ((ends, normal),) = sketch.walls  # the other one is far away
    assert normal == pytest.approx((1, 0))
    assert ends[:, 0] == pytest.approx(-1.5)
    (hatch,) = (mark for mark in sketch.draw().marks if isinstance(mark, Hatch))
    assert (np.array(hatch.strokes)[:, 1, 0] < -1.5).all()
    low, high = sketch.box()
    assert ((low <= ends) & (ends <= high)).all()
