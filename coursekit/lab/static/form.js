// A form made from a message's type, with a control for each field, and what is typed in it.
function control(field) {
  if (field.control === "check") return make("input", { type: "checkbox", checked: field.value });
  const input = make("input", { type: "text", value: field.value, spellcheck: false, autocomplete: "off" });
  if (field.control === "whole" || field.control === "number") input.inputMode = "decimal";
  if (field.limit) input.maxLength = field.limit;
  if (field.control === "list") input.placeholder = "[1, 2, 3]";
  return input;
}

function form(fields, read) {
  return fields.map((field) => {
    const name = make("span", { className: "ck-field-name", textContent: field.name });
    const type = make("span", { className: "ck-dim ck-type", textContent: field.type });
    if (field.control === "group") {
      read[field.name] = {};
      return make("fieldset", {}, make("legend", {}, name, type), ...form(field.fields, read[field.name]));
    }
    const input = control(field);
    read[field.name] = () => (field.control === "check" ? input.checked : input.value);
    return make("label", { className: "ck-field" }, name, input, type);
  });
}

const values = (read) =>
  Object.fromEntries(Object.entries(read).map(([name, get]) => [name, typeof get === "function" ? get() : values(get)]));

// A panel with a choice of names, and a form for what the chosen one takes; what was typed stays until another is chosen.
function formPanel({ model, el, kind, title, what, nothing, submit }) {
  const { panel, head, body } = frame(el, kind, title);
  panel.classList.add("ck-form");
  const choice = make("select", { title: what, onchange: () => model.send({ type: "choose", name: choice.value }) });
  const type = make("span", { className: "ck-dim" });
  const empty = make("div", { className: "ck-empty", textContent: nothing });
  const fields = make("form", { onsubmit: (event) => { event.preventDefault(); submit(); } });
  const foot = make("div", { className: "ck-foot" });
  head.append(choice, type);
  body.append(empty, fields, foot);
  let read = {};
  let built = "";
  return {
    body,
    foot,
    given: () => ({ name: choice.value, fields: values(read) }),
    show(names, message) { // true if the form is another one
      choice.replaceChildren(...names.map((name) => make("option", { value: name, textContent: name })));
      choice.value = message.chosen;
      type.textContent = message.kind;
      empty.hidden = Boolean(message.chosen);
      choice.hidden = foot.hidden = !message.chosen;
      const wanted = message.chosen + message.kind;
      if (built === wanted) return false;
      built = wanted;
      read = {};
      fields.replaceChildren(...form(message.fields, read));
      return true;
    },
    say: (text) => fields.replaceChildren(make("div", { className: "ck-dim", textContent: text })),
  };
}
