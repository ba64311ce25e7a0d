// The message publisher: a form from the topic's type, which publishes once or again and again.
export default {
  render({ model, el }) {
    const { panel, head, body } = frame(el, "publisher", gettext("Message publisher"));
    panel.classList.add("ck-form");
    const choice = make("select", { title: gettext("topic"), onchange: () => model.send({ type: "choose", name: choice.value }) });
    const kind = make("span", { className: "ck-dim" });
    head.append(choice, kind);
    const empty = make("div", { className: "ck-empty", textContent: gettext("No topics: start a node that has one.") });
    const tell = (type) => model.send({ type, name: choice.value, fields: values(read), rate: rate.value });
    const fields = make("form", { onsubmit: (event) => { event.preventDefault(); tell("publish"); } });
    const once = make("button", { className: "ck-main", textContent: gettext("Publish once"), onclick: () => tell("publish") });
    const rate = make("input", { type: "text", value: "10", inputMode: "decimal", className: "ck-rate" });
    const hertz = make("label", {}, rate, "Hz");
    const again = make("button", { onclick: () => tell(again.dataset.does) });
    const state = make("span", { className: "ck-dim" });
    state.setAttribute("role", "status");
    const foot = make("div", { className: "ck-foot" }, once, again, hertz, state);
    body.append(empty, fields, foot);
    let read = {};
    let built = "";
    return listen(model, {
      shown(message) {
        choice.replaceChildren(...message.topics.map((name) => make("option", { value: name, textContent: name })));
        choice.value = message.chosen;
        kind.textContent = message.kind;
        empty.hidden = Boolean(message.chosen);
        choice.hidden = foot.hidden = !message.chosen;
        again.dataset.does = message.repeats ? "stop" : "repeat";
        again.textContent = message.repeats ? gettext("Stop") : gettext("Publish again and again");
        rate.disabled = message.repeats;
        state.textContent = message.count ? gettext("published: {0}", message.count) : "";
        state.classList.remove("ck-error");
        const wanted = message.chosen + message.kind;
        if (built === wanted) return;
        built = wanted;
        read = {};
        fields.replaceChildren(...form(message.fields, read));
      },
      refused(message) {
        state.textContent = message.text;
        state.classList.add("ck-error");
      },
    });
  },
};
