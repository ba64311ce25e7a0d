// What nodes log: counts per level that are filters too, a choice of node, a search, a pause.
const LEVELS = ["DEBUG", "INFO", "WARN", "ERROR", "FATAL"];

export default {
  render({ model, el }) {
    const { head, body } = frame(el, "log", gettext("Log"));
    const levels = {};
    const group = make("span", { className: "ck-levels", title: gettext("show this level and above") });
    for (const level of LEVELS) {
      levels[level] = make("button", { className: `ck-level ck-${level}`, onclick: () => model.send({ type: "filter", level }) });
      group.append(levels[level]);
    }
    const node = make("select", { title: gettext("node"), onchange: () => model.send({ type: "filter", node: node.value }) });
    const search = make("input", { type: "search", placeholder: gettext("search"), oninput: () => model.send({ type: "filter", text: search.value }) });
    const pause = make("button", { textContent: gettext("Pause"), onclick: () => model.send({ type: "pause", on: pause.textContent === gettext("Pause") }) });
    const clear = make("button", { textContent: gettext("Clear"), onclick: () => model.send({ type: "clear" }) });
    head.append(group, node, search, pause, clear);
    const list = make("div", { className: "ck-lines", tabIndex: 0 });
    body.append(list);
    return listen(model, {
      shown({ lines, passing, counts, nodes, filters, paused }) {
        const least = LEVELS.indexOf(filters.level);
        for (const [place, level] of LEVELS.entries()) {
          levels[level].textContent = `${level} ${counts[level]}`;
          levels[level].classList.toggle("ck-off", place < least);
          levels[level].setAttribute("aria-pressed", place >= least);
        }
        const names = ["", ...new Set([...nodes, ...(filters.node ? [filters.node] : [])])];
        node.replaceChildren(...names.map((name) => make("option", { value: name, textContent: name || gettext("all nodes") })));
        node.value = filters.node;
        if (document.activeElement !== search) search.value = filters.text;
        pause.textContent = paused ? gettext("Go on") : gettext("Pause");
        const atEnd = list.scrollTop + list.clientHeight >= list.scrollHeight - 12;
        const older = passing - lines.length;
        const rows = lines.map((line) =>
          make("div", { className: `ck-line ck-${line.level}`, title: line.place },
            make("span", { className: "ck-time", textContent: line.time }),
            make("span", { className: "ck-mark", textContent: line.level }),
            make("span", { className: "ck-from", textContent: line.node }),
            make("span", { className: "ck-said", textContent: line.text })));
        if (older > 0) rows.unshift(make("div", { className: "ck-empty", textContent: gettext("{0} older lines", older) }));
        if (!rows.length) rows.push(make("div", { className: "ck-empty", textContent: gettext("Nothing logged yet.") }));
        list.replaceChildren(...rows);
        if (atEnd) list.scrollTop = list.scrollHeight;
      },
    });
  },
};
