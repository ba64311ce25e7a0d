// The network: its state, the others and their nodes, what is heard and sent.
// Each cell says in words what it is; what no row has takes no room.
const KINDS = ["", "ck-number", "ck-number", "ck-number", "", "ck-dim"];
function traffic(title, rows, empty) {
  const used = KINDS.map((_, i) => rows.some((row) => row[i]));
  const cells = (row) => row.map((text, i) => used[i] ? make("td", { textContent: text, className: KINDS[i] }) : null);
  const table = rows.length ? make("table", {}, make("tbody", {}, ...rows.map((row) => make("tr", {}, ...cells(row).filter(Boolean)))))
    : make("div", { className: "ck-dim", textContent: empty });
  return make("section", {}, make("h4", { textContent: title }), table);
}

function others(sessions) {
  const rows = sessions.map((one) => make("tr", {}, make("td", { className: "ck-dim", textContent: one.name }),
    make("td", { textContent: one.nodes.join(", ") || gettext("(no nodes)") })));
  const list = rows.length ? make("table", {}, make("tbody", {}, ...rows))
    : make("div", { className: "ck-dim", textContent: gettext("Nobody else is there yet.") });
  return make("section", {}, make("h4", { textContent: gettext("Others") }), list);
}

export default {
  render({ model, el }) {
    const { head, body } = frame(el, "network", gettext("Network"));
    const state = make("span", { className: "ck-state" });
    state.setAttribute("role", "status");
    const leave = make("button", { textContent: gettext("Leave"), onclick: () => model.send({ type: "leave" }) });
    head.append(state, leave);
    return listen(model, {
      shown(now) {
        leave.hidden = !now.joined;
        if (!now.joined) {
          state.className = "ck-state";
          state.textContent = gettext("not joined");
          body.replaceChildren(make("div", { className: "ck-empty" }, gettext("Messages stay in this notebook. To join a network, type in a cell: "),
            make("code", { textContent: now.how })));
          return;
        }
        state.className = `ck-state ${now.up ? "ck-up" : "ck-error"}`;
        const only = now.listenOnly ? gettext(", you only listen") : "";
        state.textContent = now.up ? gettext("{0}, domain {1}: joined{2}", now.address, now.domain, only)
          : gettext("{0}: the link is gone; it is tried again", now.address);
        const notes = now.notes.map((text) => make("div", { className: "ck-error", textContent: text }));
        body.replaceChildren(others(now.others), traffic(gettext("Heard"), now.heard, gettext("Nothing yet: what nobody here asks for is not sent.")),
          traffic(gettext("Sent"), now.sent, gettext("Nothing yet.")), ...notes);
      },
    });
  },
};
