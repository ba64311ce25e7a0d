// The list of displays: each can be turned off, listens to a topic, says how it does, and opens its properties.
const LEVELS = ["Ok", "Warn", "Error"];
const hex = (colour) => `#${colour.map((one) => Math.round(one).toString(16).padStart(2, "0")).join("")}`;
const rgb = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));

// What edits a property: an element, and what sets its value.
function editorOf(property, label, send) {
  const { editor, choices, least, most, whole } = property;
  const named = (element) => { element.setAttribute("aria-label", label); return element; };
  if (editor === "box") {
    const box = named(make("input", { type: "checkbox", onchange: () => send(box.checked) }));
    return { element: box, set: (value) => { box.checked = value; } };
  }
  if (editor === "colour") {
    const colour = named(make("input", { type: "color", onchange: () => send(rgb(colour.value)) }));
    return { element: colour, set: (value) => { colour.value = hex(value); } };
  }
  if (editor === "choice") {
    const choice = named(make("select", { onchange: () => send(choice.value) }));
    const set = (value) => {
      const all = choices.includes(value) ? choices : [...choices, value];
      if (choice.options.length !== all.length)
        choice.replaceChildren(...all.map((one) => make("option", { value: one, textContent: one || gettext("whatever fits") })));
      choice.value = value;
    };
    return { element: choice, set };
  }
  if (editor === "text") {
    const text = named(make("input", { type: "text", spellcheck: false, onchange: () => send(text.value.trim()) }));
    return { element: text, set: (value) => { text.value = value; } };
  }
  const slider = least === 0 && most === 1;
  const number = named(make("input", { type: slider ? "range" : "number", min: least ?? "", max: most ?? "", step: whole ? 1 : slider ? 0.05 : "any" }));
  number.addEventListener("change", () => { if (number.value !== "" && number.checkValidity()) send(Number(number.value)); });
  return { element: number, set: (value) => { number.value = value; } };
}

class Row {
  constructor(row, model, kinds) {
    const send = (type, more) => model.send({ type, row: row.row, ...more });
    Object.assign(this, { send, kinds, name: row.name, editors: null, said: "" });
    const { name } = row;
    this.box = make("input", { type: "checkbox", onchange: () => send("switch", { on: this.box.checked }) });
    this.dot = make("span", { className: "ck-dot" });
    this.open = make("button", { className: "ck-open", textContent: "›", title: gettext("Properties of {0}", name), onclick: () => this.unfold() });
    this.open.setAttribute("aria-label", gettext("Properties of {0}", name));
    this.open.setAttribute("aria-expanded", "false");
    this.lines = make("div", { className: "ck-lines" });
    this.properties = make("div", { className: "ck-properties", hidden: true });
    const parts = [this.open, make("label", {}, this.box, make("b", { textContent: name })), this.dot];
    if (row.topic !== null) {
      this.topic = make("input", { type: "text", className: "ck-topic", spellcheck: false, onchange: () => send("topic", { topic: this.topic.value }) });
      this.topic.setAttribute("aria-label", gettext("topic of {0}", name));
      parts.push(this.topic);
    }
    this.element = make("div", { className: "ck-row" }, ...parts, this.lines, this.properties);
    this.element.dataset.name = name;
  }

  async unfold() {
    const open = this.properties.hidden;
    this.open.setAttribute("aria-expanded", String(open));
    this.properties.hidden = !open;
    if (this.editors) return;
    this.editors = {};
    const { properties } = (await this.kinds())[this.kind];
    for (const property of properties) {
      const editor = editorOf(property, gettext("{0} of {1}", property.name, this.name), (value) => this.send("property", { key: property.key, value }));
      this.editors[property.key] = editor;
      this.properties.append(make("span", { textContent: property.name }), editor.element);
    }
    this.properties.append(make("button", { textContent: gettext("Remove this display"), className: "ck-remove", onclick: () => this.send("remove") }));
    this.show(this.last);
  }

  show(row) {
    this.last = row;
    this.kind = row.kind;
    this.box.checked = row.on;
    this.dot.className = `ck-dot ck-${row.level}`;
    this.dot.title = row.level;
    if (this.topic && document.activeElement !== this.topic) this.topic.value = row.topic;
    const worst = row.lines.filter((line) => line.level === row.level);
    const lines = row.level === "Ok" ? worst.filter((line) => !line.text.endsWith(" OK")).slice(-1) : worst;
    const said = JSON.stringify(lines);
    if (said !== this.said) {
      this.said = said;
      this.lines.replaceChildren(...lines.map((line) => make("div", { className: `ck-say ck-${line.level}`, textContent: line.text, title: `${line.what}: ${line.level}` })));
    }
    for (const [key, { element, set }] of Object.entries(this.editors ?? {}))
      if (document.activeElement !== element || element.matches("[type=checkbox], select")) set(row.options[key]);
  }
}

// The rows stay the same elements while they are shown, so that nobody loses the place where he types.
class DisplayList {
  constructor(model, element, kinds) {
    Object.assign(this, { model, element, kinds, rows: new Map() });
    this.wrong = make("div", { className: "ck-say", hidden: true });
    this.skipped = make("div", { className: "ck-say", hidden: true });
    element.append(this.wrong, this.skipped);
  }

  show({ rows, level, remark, skipped }) {
    this.wrong.hidden = !remark;
    this.wrong.className = `ck-say ck-${level}`;
    this.wrong.textContent = remark;
    this.skipped.hidden = !skipped.length;
    this.skipped.textContent = gettext("not known here: {0}", skipped.join(", "));
    const there = new Set(rows.map((row) => row.row));
    for (const [key, row] of this.rows) if (!there.has(key)) { row.element.remove(); this.rows.delete(key); }
    for (const row of rows) {
      if (!this.rows.has(row.row)) {
        this.rows.set(row.row, new Row(row, this.model, this.kinds));
        this.element.insertBefore(this.rows.get(row.row).element, this.skipped);
      }
      this.rows.get(row.row).show(row);
    }
    const levels = [level, ...rows.filter((row) => row.on).map((row) => row.level)];
    return levels.reduce((one, other) => (LEVELS.indexOf(other) > LEVELS.indexOf(one) ? other : one), "Ok");
  }
}
