// Shows markup in elements by id, and reports pointers, keys and sizes of the pictures.

export function render({model}) {
  const byId = (id) => document.getElementById(id)
  const pictures = [...document.querySelectorAll("svg.picture")]
  // Numbers of the last event, of the last two reported moves, and of the last picture shown.
  let number = 0, before = 0, last = 0, shown = 0, held = null, waiting = null

  model.on("msg:custom", (message) => {
    for (const [id, content] of Object.entries(message.markup)) byId(id).innerHTML = content
    if (message.address !== undefined) history.replaceState(null, "", "?" + message.address)
    if (message.title) document.title = message.title
    if (message.file) {
      const [name, content] = message.file
      Object.assign(document.createElement("a"), {href: "data:application/octet-stream;base64," + content, download: name}).click()
    }
    if (message.number === undefined) return
    shown = Math.max(shown, message.number)
    byId("scene").dataset.number = shown
    flush()
  })

  // One picture is made while the previous one is in transit. A later move waits and replaces a waiting move.
  function flush() {
    if (waiting === null || shown < before) return
    const move = waiting
    waiting = null
    tell(move)
  }
  function tell(event) {
    before = last
    last = event.number
    model.send_msg(event)
  }
  function point(kind, event) {
    const box = held.getBoundingClientRect()
    const told = {kind, picture: held.id, x: event.clientX - box.x, y: event.clientY - box.y, number: ++number}
    if (kind === "drag") {
      waiting = told
      flush()
    } else {
      waiting = null
      tell(told)
    }
  }

  for (const picture of pictures) {
    picture.addEventListener("pointerdown", (event) => {
      if (!event.isPrimary || event.button) return
      picture.setPointerCapture(event.pointerId)
      held = picture
      point("grab", event)
    })
    picture.addEventListener("pointermove", (event) => {
      if (held === picture && event.isPrimary) point("drag", event)
    })
    for (const [name, kind] of [["pointerup", "drop"], ["pointercancel", "cancel"]]) {
      picture.addEventListener(name, (event) => {
        if (held !== picture || !event.isPrimary) return
        point(kind, event)
        held = null
      })
    }
  }

  const ways = {ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}
  byId("scene").addEventListener("keydown", (event) => {
    const way = ways[event.key]
    if (!way) return
    event.preventDefault()
    tell({kind: "key", way, coarse: event.shiftKey, number: ++number})
  })

  // Fields with text undo their own letters.
  const writes = (element) => element && (element.shadowRoot && element.shadowRoot.activeElement
    ? writes(element.shadowRoot.activeElement) : element.matches("textarea, input:not([type=range]):not([type=checkbox])"))
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || writes(document.activeElement)) return
    const key = event.key.toLowerCase()
    const kind = key === "y" || (key === "z" && event.shiftKey) ? "redo" : key === "z" ? "undo" : ""
    if (!kind) return
    event.preventDefault()
    tell({kind, number: ++number})
  })

  const sizes = () => Object.fromEntries(pictures.map((each) => [each.id, [each.clientWidth, each.clientHeight]]))
  const resized = new ResizeObserver(() => model.send_msg({kind: "sizes", sizes: sizes(), number}))
  pictures.forEach((each) => resized.observe(each))
}
