// What the page tells of itself once it is there: pointers and keys on its pictures, and the size of these.

// Where a pointer is on a picture, in pixels from the picture's corner: once for each image of the screen.
function listen(element, picture, source) {
  let held = false, waiting = null, number = 0
  const place = (event) => {
    const box = picture.getBoundingClientRect()
    return [event.clientX - box.x, event.clientY - box.y]
  }
  const tell = (kind, [x, y]) => {
    source.data = {kind: [kind], x: [x], y: [y], number: [++number]}
  }
  const flush = () => {
    if (waiting) tell("drag", waiting)
    waiting = null
  }
  element.addEventListener("pointerdown", (event) => {
    if (!event.isPrimary || event.button) return
    element.setPointerCapture(event.pointerId)
    held = true
    tell("grab", place(event))
  })
  element.addEventListener("pointermove", (event) => {
    if (!held || !event.isPrimary) return
    if (!waiting) requestAnimationFrame(flush)
    waiting = place(event)
  })
  for (const end of ["pointerup", "pointercancel"]) {
    element.addEventListener(end, (event) => {
      if (!held || !event.isPrimary) return
      flush()
      held = false
      tell("drop", place(event))
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
