// Sliders for a robot's joints: Python is told while one is dragged, and sends back what others moved.
function jointRow(row, model) {
  const value = make("span", { className: "ck-value" });
  const slider = make("input", { type: "range", min: row.least, max: row.greatest, step: (row.greatest - row.least) / 10000 });
  const show = (position) => { value.textContent = position.toFixed(3); };
  slider.setAttribute("aria-label", row.name);
  slider.addEventListener("input", () => {
    const position = Number(slider.value);
    show(position);
    model.send({ type: "move", name: row.name, value: position });
  });
  const element = make("div", { className: "ck-row" }, make("b", { textContent: row.name }), value, slider);
  const held = () => slider.matches(":active");
  return { element, key: `${row.least} ${row.greatest}`, set(position) { if (!held()) { slider.value = position; show(position); } } };
}

export default {
  render({ model, el }) {
    const { head, body } = frame(el, "joints", gettext("Joints"));
    const node = make("span", { className: "ck-dim" });
    const button = (text, type) => make("button", { textContent: text, onclick: () => model.send({ type }) });
    head.append(node, button(gettext("Center"), "center"), button(gettext("Randomize"), "randomize"));
    const rows = new Map();
    return listen(model, {
      shown({ node: name, running, rows: shown }) {
        node.textContent = running ? name : gettext("{0} (ended)", name);
        const known = [...rows].map(([joint, row]) => `${joint} ${row.key}`).join();
        if (known !== shown.map((row) => `${row.name} ${row.least} ${row.greatest}`).join()) {
          rows.clear();
          for (const row of shown) rows.set(row.name, jointRow(row, model));
          body.replaceChildren(...[...rows.values()].map((row) => row.element));
          if (!shown.length) body.replaceChildren(make("div", { className: "ck-empty", textContent: gettext("No joints yet: waiting for robot_description.") }));
        }
        for (const row of shown) rows.get(row.name).set(row.value);
        body.classList.toggle("ck-ended", !running);
      },
    });
  },
};
