// What the page tells of itself once it is there: pointers and keys on its pictures, and the size of these.

// Where a pointer is on a picture, in pixels from the picture's corner. Browsers tell of moves once for each image of
// the screen. A move must not ask for an image: while one is asked for and the pointer is pressed or released,
// Chromium holds back all messages of the server until the image is made.
function listen(element, picture, source) {
  let held = false, number = 0
  const tell = (kind, event) => {
    const box = picture.getBoundingClientRect()
    source.data = {kind: [kind], x: [event.clientX - box.x], y: [event.clientY - box.y], number: [++number]}
  }
  element.addEventListener("pointerdown", (event) => {
    if (!event.isPrimary || event.button) return
    element.setPointerCapture(event.pointerId)
    held = true
    tell("grab", event)
  })
  element.addEventListener("pointermove", (event) => {
    if (held && event.isPrimary) tell("drag", event)
  })
  for (const end of ["pointerup", "pointercancel"]) {
    element.addEventListener(end, (event) => {
      if (!held || !event.isPrimary) return
      held = false
      tell("drop", event)
    })
  }
}

const scene = document.getElementById("scene"), curve = document.getElementById("curve")
listen(document.getElementById("picture"), scene, scene_pointer)
listen(document.getElementById("aim"), curve, curve_pointer)

const resized = new ResizeObserver(() => {
  const size = (element) => [element.clientWidth, element.clientHeight]
  sizes.data = {scene: size(scene), curve: size(curve)}
})
resized.observe(scene)
resized.observe(curve)

let presses = 0
const ways = {ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}
document.getElementById("picture").addEventListener("keydown", (event) => {
  const way = ways[event.key]
  if (!way) return
  event.preventDefault()
  keys.data = {right: [way[0]], up: [way[1]], coarse: [event.shiftKey], number: [++presses]}
})
