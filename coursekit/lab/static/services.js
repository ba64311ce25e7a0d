// The service caller: a form from the request's type; what was typed stays when the graph changes.
export default {
  render({ model, el }) {
    const { panel, head, body } = frame(el, "services", gettext("Service caller"));
    panel.classList.add("ck-form");
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
