// The topics: a row each; a tick measures the rate and shows the last message.
function row(one, model) {
  const tick = make("input", {
    type: "checkbox", checked: one.watched, title: gettext("measure the rate, show the last message"),
    onchange: (event) => model.send({ type: "watch", name: one.name, on: event.target.checked }),
  });
  const cells = [
    make("td", {}, make("label", {}, tick, make("b", { textContent: one.name }))),
    make("td", { className: "ck-dim", textContent: one.type }),
    make("td", { className: "ck-number", textContent: one.publishers }),
    make("td", { className: "ck-number", textContent: one.subscribers }),
    make("td", {
      className: "ck-number", title: one.watched ? gettext("{0} messages heard", one.count) : "",
      textContent: !one.watched ? "" : one.rate ? `${one.rate.toFixed(2)} Hz` : one.count ? gettext("silent") : gettext("nothing yet"),
    }),
  ];
  const rows = [make("tr", {}, ...cells)];
  if (one.watched && one.last)
    rows.push(make("tr", { className: "ck-message" }, make("td", { colSpan: 5 }, make("pre", { textContent: one.last }))));
  return rows;
}

export default {
  render({ model, el }) {
    const { body } = frame(el, "topics", gettext("Topics"));
    const error = make("div", { className: "ck-error" });
    const table = make("div");
    body.append(table, error);
    const titles = [gettext("topic"), gettext("type"), gettext("publishers"), gettext("subscribers"), gettext("rate")];
    return listen(model, {
      shown: unlessPressed(table, ({ rows }) => {
        error.textContent = "";
        if (!rows.length) {
          table.replaceChildren(make("div", { className: "ck-empty", textContent: gettext("No topics: start a node.") }));
          return;
        }
        const focused = table.contains(document.activeElement) ? document.activeElement.closest("tr")?.rowIndex : null;
        const head = make("tr", {}, ...titles.map((text, i) => make("th", { textContent: text, className: i > 1 ? "ck-number" : "" })));
        const whole = make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows.flatMap((one) => row(one, model))));
        table.replaceChildren(whole);
        if (focused) whole.rows[focused]?.querySelector("input")?.focus();
      }),
      error({ text }) { error.textContent = text; },
    });
  },
};
