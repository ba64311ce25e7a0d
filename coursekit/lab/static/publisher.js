// The message publisher: a form from the topic's type, which publishes once or again and again.
export default {
  render({ model, el }) {
    const tell = (type) => model.send({ type, ...panel.given(), rate: rate.value });
    const panel = formPanel({
      model, el, kind: "publisher", title: gettext("Message publisher"), what: gettext("topic"),
      nothing: gettext("No topics: start a node that has one."), submit: () => tell("publish"),
    });
    const once = make("button", { className: "ck-main", textContent: gettext("Publish once"), onclick: () => tell("publish") });
    const rate = make("input", { type: "text", value: "10", inputMode: "decimal", className: "ck-rate" });
    const hertz = make("label", {}, rate, "Hz");
    const again = make("button", { onclick: () => tell(again.dataset.does) });
    const state = make("span", { className: "ck-dim" });
    state.setAttribute("role", "status");
    panel.foot.append(once, again, hertz, state);
    return listen(model, {
      shown(message) {
        panel.show(message.topics, message);
        again.dataset.does = message.repeats ? "stop" : "repeat";
        again.textContent = message.repeats ? gettext("Stop") : gettext("Publish again and again");
        rate.disabled = message.repeats;
        state.textContent = message.count ? gettext("published: {0}", message.count) : "";
        state.classList.remove("ck-error");
      },
      refused(message) {
        state.textContent = message.text;
        state.classList.add("ck-error");
      },
    });
  },
};
