// A node's parameters: a control each; a refused value goes back, with the node's reason beside it.
function control(row, set) {
  const locked = { disabled: row.locked, "aria-label": row.name };
  if (row.control === "check")
    return [make("input", { type: "checkbox", checked: row.value, ...locked, onchange: (e) => set(e.target.checked) })];
  const ranged = row.least !== undefined;
  const step = row.step ?? (row.control === "whole" ? 1 : "any");
  const limits = ranged ? { min: row.least, max: row.greatest } : {};
  if (row.control === "whole" || row.control === "number") {
    const input = make("input", { type: "number", step, ...limits, value: row.value, ...locked, onchange: (e) => set(e.target.value) });
    if (!ranged) return [input];
    const fine = row.step ?? (row.control === "whole" ? 1 : (row.greatest - row.least) / 200);
    const slider = make("input", { type: "range", step: fine, ...limits, value: row.value, ...locked,
      oninput: (e) => { input.value = e.target.value; }, onchange: (e) => set(e.target.value) });
    return [input, slider];
  }
  return [make("input", { type: "text", value: row.value, spellcheck: false, ...locked, onchange: (e) => set(e.target.value) })];
}

export default {
  render({ model, el }) {
    const { head, body } = frame(el, "parameters", gettext("Parameters"));
    const node = make("span", { className: "ck-dim" });
    head.append(node);
    const lines = new Map();
    const say = (name, text, bad) => {
      const note = lines.get(name)?.note;
      if (!note) return;
      note.textContent = text;
      note.className = bad ? "ck-note ck-error" : "ck-note ck-good";
    };
    const line = (row) => {
      const set = (value) => { say(row.name, "", false); model.send({ type: "set", name: row.name, value }); };
      const note = lines.get(row.name)?.note ?? make("span", { className: "ck-note" });
      const extent = row.least === undefined ? "" : `  ${row.least} … ${row.greatest}`;
      const about = make("span", { className: "ck-dim ck-about", textContent: row.type + extent + (row.locked ? `  ${gettext("read-only")}` : "") });
      const parts = row.name.split(/(?<=[./])/).flatMap((part) => [part, make("wbr")]);  // a long name goes on after a dot
      const title = make("span", { className: "ck-name" }, make("b", {}, ...parts));
      if (row.description) title.append(make("span", { className: "ck-dim ck-description", textContent: row.description }));
      const controls = make("span", { className: "ck-control" }, ...control(row, set));
      return { row: make("div", { className: "ck-row" }, title, controls, about, note), note, said: JSON.stringify(row) };
    };
    return listen(model, {
      shown({ node: name, rows }) {
        node.textContent = name;
        const names = new Set(rows.map((row) => row.name));
        for (const [old, kept] of lines) if (!names.has(old)) { kept.row.remove(); lines.delete(old); }
        rows.forEach((row, place) => {
          const kept = lines.get(row.name);
          const typing = kept?.row.contains(document.activeElement) && kept.said === JSON.stringify(row) && !kept.stale;
          if (typing) return;
          if (kept && kept.said === JSON.stringify(row) && !kept.stale) return;
          const made = line(row);
          kept?.row.remove();
          lines.set(row.name, made);
          body.insertBefore(made.row, body.children[place] ?? null);
        });
        if (!rows.length) body.replaceChildren(make("div", { className: "ck-empty", textContent: gettext("This node has no parameters.") }));
      },
      accepted({ name }) { say(name, "set", false); },
      refused({ name, reason }) {
        say(name, reason, true);
        const kept = lines.get(name);
        if (kept) kept.stale = true;
      },
    });
  },
};
