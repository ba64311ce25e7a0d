// The service caller: a form from the request's type; what was typed stays when the graph changes.
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

export default {
  render({ model, el }) {
    const { head, body } = frame(el, "services", gettext("Service caller"));
    const choice = make("select", { title: gettext("service"), onchange: () => model.send({ type: "choose", name: choice.value }) });
    const kind = make("span", { className: "ck-dim" });
    head.append(choice, kind);
    const empty = make("div", { className: "ck-empty", textContent: gettext("No services: start a node that serves one.") });
    const fields = make("form", { onsubmit: (event) => { event.preventDefault(); call(); } });
    const button = make("button", { className: "ck-main", textContent: gettext("Call"), onclick: (event) => { event.preventDefault(); call(); } });
    const state = make("span", { className: "ck-dim" });
    const answer = make("pre", { className: "ck-answer", hidden: true });
    const foot = make("div", { className: "ck-foot" }, button, state);
    body.append(empty, fields, foot, answer);
    let read = {};
    let built = "";
    const call = () => model.send({ type: "call", name: choice.value, fields: values(read) });
    return listen(model, {
      shown(message) {
        choice.replaceChildren(...message.services.map((name) => make("option", { value: name, textContent: name })));
        choice.value = message.chosen;
        kind.textContent = message.kind;
        empty.hidden = Boolean(message.chosen);
        choice.hidden = foot.hidden = !message.chosen;
        const wanted = message.chosen + message.kind;
        if (built === wanted) return;
        built = wanted;
        read = {};
        const inputs = form(message.fields, read);
        const none = make("div", { className: "ck-dim", textContent: gettext("The request has no fields.") });
        fields.replaceChildren(...(inputs.length || !message.chosen ? inputs : [none]));
        answer.hidden = true;
        state.textContent = "";
      },
      waiting() { state.textContent = gettext("waiting for the answer …"); answer.hidden = true; },
      answer(message) {
        state.textContent = message.ok ? gettext("answered in {0} ms", message.milliseconds) : gettext("not called");
        answer.textContent = message.text;
        answer.classList.toggle("ck-error", !message.ok);
        answer.hidden = false;
      },
    });
  },
};
