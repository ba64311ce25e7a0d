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
    const { drawing, details, named, show } = drawingOf(model);
    body.append(drawing, details);
    drawing.addEventListener("mouseover", (event) => lightUp(drawing, named(event)));
    drawing.addEventListener("mouseleave", () => lightUp(drawing, ""));
    return listen(model, {
      past: ({ on }) => panel.classList.toggle("ck-of-past", on),
      shown(message) {
        view.value = message.view;
        for (const name of Object.keys(boxes)) boxes[name].checked = message.options[name];
        show(message);
      },
    });
  },
};
