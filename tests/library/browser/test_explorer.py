"""The explorer in a real browser: what is dragged, clicked and pressed, and what the page then says."""

import re
from dataclasses import replace
from http.client import HTTPConnection
from pathlib import Path
from urllib.parse import parse_qsl, urlsplit

import numpy as np
import pytest
import xarray as xr
from browser.page import drag, handle, on_screen, ready, serving, settled, words
from browser.shots import alike

import planar_pushing as pp
from planar_pushing.drawing.timeline import path_data
from planar_pushing.drawing.words import outcome
from planar_pushing.explorer.address import state_in
from planar_pushing.explorer.objects import object_of
from planar_pushing.explorer.own_outline import sides_of
from planar_pushing.explorer.pictures import maps
from planar_pushing.explorer.pictures.pictures import LONG, solve_push
from planar_pushing.explorer.presets import preset, titles
from planar_pushing.scenes.files import load_scene_file

pytestmark = pytest.mark.alone
IMAGES = Path(__file__).with_name("images")


def state(page):
    """The state in the page's address."""
    return state_in(dict(parse_qsl(urlsplit(page.url).query)))


def expected(state):
    """What the page should say of a state."""
    push = solve_push(state)
    return outcome(push.solutions, push.sketch.pusher, push.chosen)


def start_from(page, name):
    page.locator(".preset select").select_option(label=titles()[name])
    page.wait_for_function(
        "title => new URLSearchParams(location.search).get('title') === title", arg=titles()[name]
    )
    settled(page)


def agrees(page):
    """The page says what the mechanics say of the state in its address."""
    settled(page)
    says = "said => document.getElementById('words').innerText === said"
    page.wait_for_function(says, arg=expected(state(page)))


def test_the_first_page_pulls(page):
    assert state(page) == preset("figure_03")
    assert page.title() == titles()["figure_03"]
    assert words(page) == (
        "The contact sticks while being pulled; two other solutions: the contact breaks, or slips to the "
        "left while being pulled."
    )
    assert "0.848 at 36\N{DEGREE SIGN}" in page.locator("tr.shown").inner_text()


def test_the_push_is_dragged(page):
    drag(page, handle(page, "pusher"), (-0.5, 1.2))
    agrees(page)
    assert state(page).angle == pytest.approx(np.rad2deg(np.arctan2(1.2, -0.5)), abs=1.0)
    cross = page.locator("#cross path").first.bounding_box()
    middle = cross["x"] + cross["width"] / 2, cross["y"] + cross["height"] / 2
    assert middle == pytest.approx(on_screen(page, maps.position_of(state(page)), "map"), abs=2.0)


def test_the_force_is_aimed_on_the_limit_curve(page):
    page.mouse.click(*on_screen(page, (0.0, 1.0), "curve"))
    agrees(page)
    assert state(page).angle == pytest.approx(
        np.rad2deg(pp.motion_angle(state(page).scene, np.pi / 2)), abs=1.0
    )


def test_a_click_on_the_map_goes_there(page):
    page.mouse.click(*on_screen(page, (maps.WIDE / 2, 2 / 3), "map"))
    agrees(page)
    assert state(page).angle == pytest.approx(60.0, abs=2.0)
    assert state(page).scene.contact.friction_coefficient == pytest.approx(1.0, rel=0.05)


def test_keys_move_the_handle_that_is_chosen(page):
    before = state(page)
    page.locator("#scene").focus()
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("ArrowLeft")
    agrees(page)
    assert state(page).angle == pytest.approx(before.angle + 2.0, abs=0.01)
    page.get_by_role("button", name="Rod").click()
    page.locator("#scene").focus()
    page.keyboard.press("Shift+ArrowUp")
    agrees(page)
    assert state(page).file.slider.rod_length == pytest.approx(3.6)


#: What has the focus, inside of the widgets' own trees too: its name or its text.
FOCUSED = """() => {
  let found = document.activeElement
  while (found.shadowRoot && found.shadowRoot.activeElement) found = found.shadowRoot.activeElement
  return found.id || found.textContent.trim() || found.tagName
}"""


def test_the_tab_key_reaches_picture_and_widgets(page):
    reached = set()
    for _ in range(70):
        page.keyboard.press("Tab")
        reached.add(page.evaluate(FOCUSED))
    assert {"scene", "Rod", "Finger", "Scene (YAML)"} <= reached
    assert len(reached) > 10


def test_touch_drags(chromium, server):
    context = chromium.new_context(
        viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True
    )
    page = context.new_page()
    page.goto(server.url)
    ready(page)
    session = context.new_cdp_session(page)
    start, end = on_screen(page, handle(page, "pusher")), on_screen(page, (-0.5, 1.2))
    for step in np.linspace(0, 1, 8):
        x, y = np.array(start) + step * (np.array(end) - start)
        kind = "touchStart" if step == 0 else "touchMove"
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y}]})
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    agrees(page)
    assert state(page).angle == pytest.approx(np.rad2deg(np.arctan2(1.2, -0.5)), abs=2.0)
    wide = page.evaluate("document.documentElement.scrollWidth")
    assert wide <= 390
    context.close()


@pytest.mark.parametrize("name", ["figure_13", "pulling_lost", "box", "box_side"])
def test_a_preset_opens(page, name):
    start_from(page, name)
    assert state(page) == preset(name)
    agrees(page)


def test_a_side_on_the_fence_is_pushed_and_followed(page):
    start_from(page, "box_side")
    assert words(page) == "The side stays flush and sticks."
    assert page.locator("#scene .handle").count() == 1
    for name in ("curve", "map"):
        assert "A side lies on the fence" in page.locator(f"#{name}").text_content()
        x, y = on_screen(page, (0.2, 0.4), name)
        page.mouse.click(x, y)
    assert page.get_by_label("Support", exact=True).is_disabled()
    drag(page, handle(page, "pusher"), (-0.1, 0.03))
    agrees(page)
    assert words(page) == "The side lifts off, turns about its right end and slips to the right."
    start_from(page, "box_side")
    follow(page)
    page.mouse.click(*on_screen(page, (0.2 * LONG, 1.4), "time"))
    settled(page)
    assert re.match(r"At time 1\.\d+ the side is flush and sticks\.", words(page))
    assert "a side flush on the fence" in page.locator("#energies").inner_text()
    page.get_by_role("button", name="Back to the push").click()
    start_from(page, "figure_03")
    assert page.locator("#scene .handle").count() == 4
    assert page.get_by_label("Support", exact=True).is_enabled()


def entered(page, label, text):
    """Enter a text in a field."""
    field = page.get_by_label(label, exact=True)
    field.fill(text)
    field.press("Tab")
    settled(page)


def test_the_contact_is_dragged_along_the_outline(page):
    start_from(page, "box")
    before = state(page)
    drag(page, handle(page, "contact"), (-0.1, -0.05))
    agrees(page)
    assert object_of(state(page)).place.point == pytest.approx((-0.06, -0.1), abs=2e-3)
    drag(page, handle(page, "contact"), (0.3, 0.05))  # to the middle of the right side
    agrees(page)
    assert object_of(state(page)).place.point == pytest.approx((0.15, -0.05), abs=2e-3)
    assert state(page).file.simulate == before.file.simulate


def test_steps_are_undone_by_buttons_and_keys(page):
    first = state(page)
    drag(page, handle(page, "pusher"), (-0.5, 1.2))
    agrees(page)
    second = state(page)
    start_from(page, "mug")
    page.get_by_role("button", name="Undo").click()
    agrees(page)
    assert state(page) == second
    page.keyboard.press("Control+z")
    agrees(page)
    assert state(page) == first
    assert page.get_by_role("button", name="Undo").is_disabled()
    page.keyboard.press("Control+Shift+z")
    agrees(page)
    assert state(page) == second
    page.get_by_role("button", name="Redo").click()
    agrees(page)
    assert state(page) == preset("mug")


def test_an_own_outline_is_entered_in_a_unit(page):
    page.get_by_label("Outline", exact=True).select_option(label="box")
    agrees(page)
    page.get_by_label("Unit of lengths").select_option(label="cm")
    settled(page)
    entered(page, "Width (cm)", "30")
    entered(page, "Height (cm)", "20")
    agrees(page)
    assert sides_of(state(page)) == (30.0, 20.0)
    page.get_by_label("Outline", exact=True).select_option(label="polygon")
    settled(page)
    here = state(page)
    entered(page, "Corners: x, y (cm)", "0, 0\n30, 0\n30, ten")
    alert = (
        "Corners: corner 3: '30, ten' given; allowed: two finite numbers, x and y; "
        "write them as in 0.15, -0.1"
    )
    assert page.get_by_role("alert").inner_text() == alert
    assert state(page) == here
    entered(page, "Corners: x, y (cm)", "0, 0\n30, 0\n0, 20")
    agrees(page)
    assert object_of(state(page)).outline.area == pytest.approx(300.0)
    assert page.locator("#error").inner_text() == ""


#: The times of the picture, the limit curve and the map at each change of the page while it plays.
TIMES = """() => {
  window.times = []
  const text = (id) => document.getElementById(id).innerText
  new MutationObserver(() => times.push([text("words"), text("when"), text("map-when")]))
    .observe(document.querySelector("main"), {subtree: true, childList: true, characterData: true})
}"""


def test_picture_and_map_show_one_time_while_they_play(page):
    start_from(page, "pulling")
    page.evaluate(TIMES)
    page.get_by_role("button", name="Follow over time").click()
    page.wait_for_function("new Set(times.map((each) => each[1])).size > 5")
    page.locator("button.pause").click()
    settled(page)
    times = [each for each in page.evaluate("times") if each[0].startswith("At time")]
    assert len(times) > 5
    for words_then, curve, modes in times:
        assert curve == modes
        assert curve == f"at time {words_then.split()[2]}"


def test_widgets_change_the_scene(page):
    page.get_by_label("Contact law").select_option("infinite friction")
    agrees(page)
    page.get_by_label("Support", exact=True).select_option(label="three feet")
    agrees(page)
    page.get_by_label("Inertia").check()
    page.wait_for_timeout(1500)
    agrees(page)
    found = state(page)
    assert isinstance(found.scene.contact, pp.InfiniteFriction)
    assert len(found.scene.rows.entries) == 2
    page.get_by_role("button", name="Finger").click()
    page.wait_for_function("location.search.includes('finger')")
    agrees(page)
    assert state(page).shape == "finger"


def test_another_solution_is_drawn_in_full(page):
    page.get_by_role("button", name="Slip left").click()
    agrees(page)
    assert state(page).shown == "SLIP_LEFT"
    assert words(page).startswith(
        "The contact slips to the left while being pulled; two other solutions: "
    )


def test_a_copied_address_opens_the_same_scene(page, context):
    start_from(page, "figure_13")
    drag(page, handle(page, "pusher"), (-1.0, 0.6))
    settled(page)
    said, here = words(page), state(page)
    other = context.new_page()
    other.goto(page.url)
    ready(other)
    assert words(other) == said
    assert state(other) == here


def test_other_origins_are_refused(server):
    headers = {
        "Connection": "Upgrade", "Upgrade": "websocket", "Sec-WebSocket-Version": "13",
        "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==",
    }  # fmt: skip
    connection = HTTPConnection(urlsplit(server.url).netloc)
    for origin, status in (("http://example.com", 403), (server.url.rstrip("/"), 101)):
        connection.request("GET", "/ws", headers=headers | {"Origin": origin})
        assert connection.getresponse().status == status
        connection.close()


def test_a_wrong_address_is_said_and_the_first_preset_shown(context, server):
    page = context.new_page()
    page.goto(f"{server.url}?slider.rod_length=long")
    ready(page)
    assert page.get_by_role("alert").inner_text() == (
        "address: slider.rod_length: 'long' given; allowed: a finite number >= 0; "
        "the page shows its first preset instead"
    )
    assert state(page) == preset("figure_03")


@pytest.mark.parametrize(("label", "value", "said"), [
    ("Mass m", "", "Mass m: nothing given; allowed: a finite number > 0"),
])  # fmt: skip
def test_a_bad_value_is_said_and_taken_back(page, label, value, said):
    start_from(page, "figure_13")
    field, here = page.get_by_label(label, exact=True), state(page)
    before = field.input_value()
    field.fill(value)
    field.press("Enter")
    page.wait_for_function("document.getElementById('error').innerText !== ''")
    assert page.get_by_role("alert").inner_text().startswith(said)
    settled(page)
    assert field.input_value() == before
    assert state(page) == here
    field.fill("2")
    field.press("Enter")
    settled(page)
    assert page.locator("#error").inner_text() == ""


def test_the_last_effect_stays(page):
    box = page.get_by_label("Support friction")
    box.uncheck()
    page.wait_for_function("document.getElementById('error').innerText !== ''")
    assert (
        page.get_by_role("alert")
        .inner_text()
        .startswith("Effects: nothing given; allowed: a list with")
    )
    settled(page)
    assert box.is_checked()


def follow(page):
    """Follow over time, and pause after a while."""
    page.get_by_role("button", name="Follow over time").click()
    page.wait_for_selector("#runs > g > path")
    page.wait_for_timeout(1500)
    page.locator("button.pause").click()
    settled(page)


def bars(page):
    """Number of runs of a mode over time."""
    return page.evaluate("document.querySelectorAll('#runs path[fill^=\"#\"]').length")


def test_a_push_is_followed_and_a_way_taken_by_hand(page):
    follow(page)
    assert 0.0 < state(page).time < state(page).duration
    assert bars(page) == 2
    page.mouse.click(*on_screen(page, (0.08 * LONG, 1.4), "time"))
    settled(page)
    assert state(page).time == pytest.approx(0.08 * state(page).duration, rel=0.02)
    assert re.match(
        r"At time 0\.\d+ the contact sticks, one of three consistent solutions\.", words(page)
    )
    page.get_by_role("button", name="slips to the left").click()
    settled(page)
    assert bars(page) == 3
    assert [each.policy for each in state(page).file.simulate.policies][1:] == ["slip-left"]
    page.get_by_role("button", name="Forget the choices made").click()
    settled(page)
    assert bars(page) == 2
    page.get_by_role("button", name="Back to the push").click()
    settled(page)
    assert words(page) == expected(replace(state(page), time=None))
    assert not page.locator("#time").is_visible()


@pytest.mark.parametrize(("name", "when"), [
    ("pulling", "at time"), ("pulling_with_inertia", "of the push at the start"),
])  # fmt: skip
def test_an_address_copied_over_time_opens_the_same_page(page, context, name, when):
    start_from(page, name)
    follow(page)
    other = context.new_page()
    other.goto(page.url)
    ready(other)
    settled(other)
    assert state(other) == state(page)
    for part in (
        "#words",
        "#solutions",
        "#curve",
        "#scene",
        "#cross",
        "#runs",
        "#now",
        "#map-when",
    ):
        assert other.locator(part).inner_html() == page.locator(part).inner_html() != "", part
    assert when in page.locator("#when").inner_text()
    assert when in page.locator("#map-when").inner_text()


def saved(page, button, folder):
    with page.expect_download() as found:
        page.get_by_role("button", name=button).click()
    path = folder / found.value.suggested_filename
    found.value.save_as(path)
    return path


def test_files_are_saved(page, tmp_path):
    start_from(page, "pulling")
    here = state(page)
    assert load_scene_file(saved(page, "Scene (YAML)", tmp_path)) == here.file
    assert saved(page, "Picture (SVG)", tmp_path).read_text(encoding="utf-8").count("<path") > 5
    with xr.open_dataset(saved(page, "Log (netCDF)", tmp_path), engine="h5netcdf") as log:
        assert "path_position" in path_data(log.load())
    found = {}
    exec(saved(page, "Python", tmp_path).read_text(encoding="utf-8"), found)
    assert found["scene"] == here.scene


@pytest.mark.parametrize(("name", "size"), [
    ("figure_03", (1400, 900)), ("figure_13", (1400, 900)), ("plate", (1400, 900)),
    ("figure_03", (390, 844)),
])  # fmt: skip
def test_the_picture_looks_as_it_did(page, name, size):
    page.set_viewport_size(dict(zip(("width", "height"), size, strict=True)))
    start_from(page, name)
    page.wait_for_timeout(400)
    shot = page.locator("#scene").screenshot()
    assert alike(IMAGES / f"{name}_{size[0]}.png", shot)


@pytest.mark.parametrize("way", ["button", "Ctrl-C"])
def test_the_server_ends(context, way):
    with serving("workflow/scenes/figure_08.yaml") as server:
        page = context.new_page()
        page.goto(server.url)
        ready(page)
        assert words(page) == "The contact sticks."
        if way == "button":
            page.get_by_role("button", name="Close").click()
            code, out, err = server.ended()
        else:
            code, out, err = server.interrupt()
        assert (code, err) == (0, "")
        assert "closed" in out
