"""20,000 random drags: neither page nor server grows, moves are drawn soon, and a long drag is smooth.

`make test-drags` runs it; the variable DRAGS sets another number.
"""

import os
import random
import time

import numpy as np
from browser.page import drag, handle, on_screen, settled

DRAGS = int(os.environ.get("DRAGS", "20000"))
#: A drag, as events of the mouse with the buttons that are down.
DRAG = (("mousePressed", 1), ("mouseMoved", 1), ("mouseReleased", 0))
#: Seconds from drag to drag at least: 30 a second, as many as pictures are asked for.
PACE = 1 / 30
#: Moves of a long drag, and degrees of a move.
LONG, STEP = 600, 2.0
#: Drags before memory is measured for the first time, and between two drags of the rod.
WARM, BLOCK = DRAGS // 10, DRAGS // 40
#: Most that page and server may grow from the first measurement to the last, MB. Only these two collect
#: the page's garbage, which makes it forget its compiled code too.
GROWTH = 4.0, 40.0
#: Most milliseconds between a move and its picture, for 99 of 100; least pictures a second of a long drag.
LATENCY, RATE = 150.0, 20.0
#: Every move of the pointer is noted as it comes in, and every picture when the screen has its image: one
#: image of the screen after the one that is made of it. The page numbers the events of pointers, and each
#: picture has the number of the last one that it answers.
NOTE = """() => {
  const scene = document.getElementById("scene")
  window.noted = {moves: [], waits: [], pictures: 0, count: +scene.dataset.number}
  let held = false
  const note = (event) => {
    if (event.type === "pointerdown") held = true
    if (!held) return
    noted.count += 1
    if (event.type === "pointermove") noted.moves.push([noted.count, event.timeStamp])
    if (event.type === "pointerup") held = false
  }
  for (const kind of ["pointerdown", "pointermove", "pointerup"]) scene.addEventListener(kind, note, true)
  new MutationObserver(() => {
    noted.pictures += 1
    const answered = +scene.dataset.number
    requestAnimationFrame(() => requestAnimationFrame(() => {
      const now = performance.now()
      while (noted.moves.length && noted.moves[0][0] <= answered) {
        noted.waits.push(now - noted.moves.shift()[1])
      }
    }))
  }).observe(scene, {attributes: true, attributeFilter: ["data-number"]})
}"""
#: Pictures that the page has shown.
PICTURES = "noted.pictures"


def heap(session):
    """JavaScript in use after the garbage is collected, bytes."""
    session.send("HeapProfiler.collectGarbage")
    return session.send("Runtime.getHeapUsage")["usedSize"]


def mouse(session, kind, place, buttons):
    """One event of the mouse, straight to the page."""
    session.send("Input.dispatchMouseEvent", {
        "type": kind, "x": place[0], "y": place[1], "button": "left" if kind != "mouseMoved" else "none",
        "buttons": buttons, "clickCount": 1,
    })  # fmt: skip


def around(page):
    """The angle of the push, and where on the screen it is dragged to for another one."""
    origin, across, up = (np.array(on_screen(page, at)) for at in ((0, 0), (1, 0), (0, 1)))
    x, y = handle(page, "pusher")
    reach = np.hypot(x, y)

    def place(angle):
        x, y = reach * np.cos(angle), reach * np.sin(angle)
        return (origin + x * (across - origin) + y * (up - origin)).tolist()

    return np.arctan2(y, x), place


def block(page, session, count, random_of):
    """A drag of the rod, and short drags of the push to random directions."""
    angle, length = random_of.uniform(0.3, 2.8), random_of.uniform(1.5, 4.0)
    drag(page, handle(page, "rod"), (length * np.cos(angle), length * np.sin(angle)))
    settled(page)
    turn, place = around(page)
    start = time.perf_counter()
    for number in range(count):
        time.sleep(max(start + number * PACE - time.perf_counter(), 0.0))
        for kind, buttons in DRAG:
            turn = random_of.uniform(-np.pi, np.pi) if kind == "mouseMoved" else turn
            mouse(session, kind, place(turn), buttons)


def rate(page, session):
    """Pictures a second of a long drag."""
    settled(page)
    turn, place = around(page)
    before, start = page.evaluate(PICTURES), time.perf_counter()
    mouse(session, "mousePressed", place(turn), 1)
    for move in range(LONG):
        mouse(session, "mouseMoved", place(turn + move * np.deg2rad(STEP)), 1)
    count, seconds = page.evaluate(PICTURES) - before, time.perf_counter() - start
    mouse(session, "mouseReleased", place(turn + LONG * np.deg2rad(STEP)), 0)
    return count / seconds


def test_memory_latency_and_rate(page, server, context):
    session = context.new_cdp_session(page)
    page.evaluate(NOTE)
    random_of = random.Random(16)
    for _ in range(WARM // BLOCK):
        block(page, session, BLOCK, random_of)
    before = np.array([heap(session), server.memory]) / 1e6
    start = time.perf_counter()
    for _ in range((DRAGS - WARM) // BLOCK):
        block(page, session, BLOCK, random_of)
    seconds = time.perf_counter() - start
    waits = np.array(page.evaluate("noted.waits"))
    smooth = rate(page, session)
    p50, p99 = np.percentile(waits, [50, 99])
    after = np.array([heap(session), server.memory]) / 1e6
    print(
        f"\n{DRAGS} drags, {len(waits)} moves drawn, {1e3 * seconds / (DRAGS - WARM):.1f} ms a drag\n"
        f"from a move to its picture: median {p50:.0f} ms, p99 {p99:.0f} ms\n"
        f"a long drag: {smooth:.0f} pictures a second\n"
        f"page {before[0]:.1f} to {after[0]:.1f} MB, server {before[1]:.0f} to {after[1]:.0f} MB"
    )
    assert len(waits) > DRAGS
    assert p99 < LATENCY
    assert smooth > RATE
    assert (after - before < GROWTH).all()
