// Below the list: a display more, by its type or by the topic that it shows, and the file that keeps the view.
function card(label, className, ...parts) {
  const made = make("div", { className: `ck-card ${className}`, hidden: true }, ...parts);
  made.setAttribute("role", "dialog");
  made.setAttribute("aria-label", label);
  return made;
}

// A button opens the card and closes it; so does Escape. `fill` is called before it is seen.
function opens(button, shown, fill = () => {}) {
  const set = (open) => {
    if (open) fill();
    shown.hidden = !open;
    button.setAttribute("aria-expanded", String(open));
    if (open) shown.querySelector("input, button, select")?.focus({ preventScroll: true });
    else button.focus({ preventScroll: true });
  };
  button.setAttribute("aria-expanded", "false");
  button.addEventListener("click", () => set(shown.hidden));
  shown.addEventListener("keydown", (event) => { if (event.key === "Escape") { event.stopPropagation(); set(false); } });
  return set;
}

function addDialog(model, kinds) {
  const search = make("input", { type: "search", placeholder: gettext("Search"), oninput: () => sift() });
  search.setAttribute("aria-label", gettext("Search displays and topics"));
  const byType = make("button", { textContent: gettext("By display type"), onclick: () => turn(false) });
  const byTopic = make("button", { textContent: gettext("By topic"), onclick: () => turn(true) });
  const offers = make("div", { className: "ck-offers" });
  const shown = card(gettext("Add a display"), "ck-add", make("div", { className: "ck-tabs" }, byType, byTopic, search), offers);
  const button = make("button", { className: "ck-main", textContent: gettext("Add"), title: gettext("a display more") });
  let topics = [], byTopics = false;
  const offer = (name, about, message) => make("button", { className: "ck-offer", onclick: () => { model.send({ type: "add", ...message }); set(false); } },
    make("b", { textContent: name }), make("span", { textContent: about }));
  const sift = () => {
    const wanted = search.value.trim().toLowerCase();
    for (const one of offers.children) one.hidden = !one.textContent.toLowerCase().includes(wanted);
  };
  const draw = async () => {
    const known = await kinds();
    offers.replaceChildren(...byTopics
      ? topics.map(([topic, kind]) => offer(topic, kind, { kind, topic }))
      : Object.entries(known).map(([kind, { about }]) => offer(kind, about, { kind })));
    if (byTopics && !topics.length) offers.append(make("p", { className: "ck-dim", textContent: gettext("Nobody publishes anything that can be shown.") }));
    sift();
  };
  const turn = (topic) => {
    byTopics = topic;
    byType.setAttribute("aria-pressed", String(!topic));
    byTopic.setAttribute("aria-pressed", String(topic));
    if (topic) model.send({ type: "topics" });
    draw();
  };
  const set = opens(button, shown, () => { search.value = ""; turn(byTopics); });
  return { button, shown, hear: (message) => { topics = message.topics; if (byTopics) draw(); } };
}

function saveDialog(model) {
  const name = make("input", { type: "text", value: "view.rviz", spellcheck: false });
  const save = () => { model.send({ type: "save", name: name.value }); set(false); };
  name.addEventListener("keydown", (event) => { if (event.key === "Enter") save(); });
  const shown = card(gettext("Save to a file"), "ck-save", make("label", {}, gettext("File"), name), make("button", { className: "ck-main", textContent: gettext("Save"), onclick: save }),
    make("p", { className: "ck-dim", textContent: gettext("RViz opens a file that ends in .rviz, too.") }));
  const button = make("button", { textContent: gettext("Save…"), title: gettext("the displays and the view to a file") });
  const set = opens(button, shown);
  return { button, shown };
}
