// The service caller: a form from the request's type, and the response.
export default {
  render({ model, el }) {
    const call = () => model.send({ type: "call", ...panel.given() });
    const panel = formPanel({
      model, el, kind: "services", title: gettext("Service caller"), what: gettext("service"),
      nothing: gettext("No services: start a node that serves one."), submit: call,
    });
    const button = make("button", { className: "ck-main", textContent: gettext("Call"), onclick: (event) => { event.preventDefault(); call(); } });
    const state = make("span", { className: "ck-dim" });
    const answer = make("pre", { className: "ck-answer", hidden: true });
    panel.foot.append(button, state);
    panel.body.append(answer);
    return listen(model, {
      shown(message) {
        if (!panel.show(message.services, message)) return;
        if (message.chosen && !message.fields.length) panel.say(gettext("The request has no fields."));
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
