// What all panels share: making elements, and the talk with Python (custom messages only, never synced traits).
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name in element && name !== "list") element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

// A panel's frame with a title; keys typed in it do not reach the notebook's shortcuts.
function frame(el, kind, title) {
  const head = make("div", { className: "ck-head" }, make("span", { className: "ck-title", textContent: title }));
  const body = make("div", { className: "ck-body" });
  const panel = make("div", { className: `ck-panel ck-${kind}` }, head, body);
  panel.setAttribute("data-lm-suppress-shortcuts", "true");
  panel.addEventListener("keydown", (event) => event.stopPropagation());
  el.appendChild(panel);
  return { panel, head, body };
}

// Calls react[message.type](message) for what Python says; asks for the present state at once.
function listen(model, react) {
  const hear = (message) => react[message.type]?.(message);
  model.on("msg:custom", hear);
  model.send({ type: "ready" });
  return () => model.off("msg:custom", hear);
}

// Has draw(message) wait while the pointer is pressed on an element: what is pressed must still be there for its click.
function unlessPressed(element, draw) {
  let pressed = false;
  let waiting = null;
  const release = () => setTimeout(() => { // after the click
    pressed = false;
    if (waiting) draw(waiting);
    waiting = null;
  });
  element.addEventListener("pointerdown", () => (pressed = true));
  for (const end of ["pointerup", "pointercancel", "pointerleave"]) element.addEventListener(end, release);
  return (message) => (pressed ? (waiting = message) : draw(message));
}
