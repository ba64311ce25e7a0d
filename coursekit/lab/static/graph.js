// The live graph: Python draws it, this shows it; a click asks for details, the pointer lights up neighbours.
const VIEWS = { nodes: gettext("Nodes only"), active: gettext("Nodes and active topics"), all: gettext("Nodes and all topics") };
const OPTIONS = { services: gettext("services"), actions: gettext("actions"), hidden: gettext("hidden"), debug: gettext("debug") };

function lightUp(drawing, name) {
  const lines = [...drawing.querySelectorAll(".ck-link")];
  const near = new Set([name]);
  for (const line of lines) {
    const mine = line.dataset.from === name || line.dataset.to === name;
    line.classList.toggle("ck-faint", Boolean(name) && !mine);
    if (mine) near.add(line.dataset.from).add(line.dataset.to);
  }
  for (const part of drawing.querySelectorAll(".ck-part"))
    part.classList.toggle("ck-faint", Boolean(name) && !near.has(part.dataset.name));
}

export default {
  render({ model, el }) {
    const { panel, head, body } = frame(el, "graph", gettext("Graph"));
    const view = make("select", { title: gettext("what is shown"), onchange: () => model.send({ type: "view", view: view.value }) });
    for (const [value, text] of Object.entries(VIEWS)) view.append(make("option", { value, textContent: text }));
    head.append(view);
    const boxes = {};
    for (const [name, text] of Object.entries(OPTIONS)) {
      boxes[name] = make("input", { type: "checkbox", onchange: (e) => model.send({ type: "option", name, on: e.target.checked }) });
      head.append(make("label", {}, boxes[name], text));
    }
    const drawing = make("div", { className: "ck-drawing" });
    const details = make("div", { className: "ck-details", hidden: true });
    body.append(drawing, details);
    const named = (event) => event.target.closest?.(".ck-part")?.dataset.name ?? "";
    drawing.addEventListener("click", (event) => model.send({ type: "choose", name: named(event) }));
    drawing.addEventListener("keydown", (event) => event.key === "Enter" && model.send({ type: "choose", name: named(event) }));
    drawing.addEventListener("mouseover", (event) => lightUp(drawing, named(event)));
    drawing.addEventListener("mouseleave", () => lightUp(drawing, ""));
    return listen(model, {
      past: ({ on }) => panel.classList.toggle("ck-of-past", on),
      shown(message) {
        if (drawing.dataset.svg !== message.svg) drawing.innerHTML = drawing.dataset.svg = message.svg;
        view.value = message.view;
        for (const name of Object.keys(boxes)) boxes[name].checked = message.options[name];
        for (const part of drawing.querySelectorAll(".ck-part"))
          part.classList.toggle("ck-chosen", part.dataset.name === message.chosen);
        details.hidden = !message.details;
        const close = make("button", { textContent: gettext("Close"), onclick: () => model.send({ type: "choose", name: "" }) });
        details.replaceChildren(close, make("pre", { textContent: message.details }));
      },
    });
  },
};
