// The viewer: MeshCat draws what Python sends; this adds the list of displays, RViz's tools and the camera.
const TOOLS = { goal: "2D Goal Pose", estimate: "2D Pose Estimate", point: "Publish Point" };
const NARROW = 620; // pixels of a viewer below which the list of displays is folded at first
const LEVELS = ["Ok", "Warn", "Error"];

// A tool in use: press where, drag whither; Python publishes.
function useTools(stage, scene, buttons, model) {
  let tool = null, start = null;
  const line = stage.querySelector("line");
  const choose = (name) => {
    tool = tool === name ? null : name;
    for (const [key, button] of Object.entries(buttons)) button.setAttribute("aria-pressed", String(key === tool));
    scene.view.controls.enabled = tool === null;
    stage.classList.toggle("ck-aiming", tool !== null);
  };
  const inside = (event) => { const box = stage.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
  const draw = (event) => {
    const [x, y] = inside(event);
    line.setAttribute("x2", x); line.setAttribute("y2", y);
  };
  const cover = stage.querySelector("svg");
  cover.addEventListener("pointerdown", (event) => {
    const place = tool && scene.floor(event);
    if (!place) return;
    event.preventDefault();
    cover.setPointerCapture(event.pointerId);
    if (tool === "point") { model.send({ type: "tool", tool, ...place, z: 0 }); choose(tool); return; }
    start = place;
    const [x, y] = inside(event);
    line.setAttribute("x1", x); line.setAttribute("y1", y);
    draw(event);
    line.style.display = "";
  });
  cover.addEventListener("pointermove", (event) => start && draw(event));
  cover.addEventListener("pointerup", (event) => {
    if (!start) return;
    const end = scene.floor(event) ?? start;
    const yaw = Math.atan2(end.y - start.y, end.x - start.x);
    model.send({ type: "tool", tool, ...start, yaw });
    start = null;
    line.style.display = "none";
    choose(tool);
  });
  return choose;
}

function rowOf(row, model) {
  const box = make("input", { type: "checkbox", checked: row.on, onchange: () => model.send({ type: "switch", row: row.row, on: box.checked }) });
  const dot = make("span", { className: `ck-dot ck-${row.level}`, title: row.level });
  const parts = [make("label", {}, box, make("b", { textContent: row.name })), dot];
  if (row.topic !== null) {
    const topic = make("input", { type: "text", value: row.topic, className: "ck-topic", spellcheck: false,
      onchange: () => model.send({ type: "topic", row: row.row, topic: topic.value }) });
    topic.setAttribute("aria-label", `topic of ${row.name}`);
    parts.push(topic);
  }
  const worst = row.lines.filter((line) => line.level === row.level);
  const lines = row.level === "Ok" ? worst.filter((line) => !line.text.endsWith(" OK")).slice(-1) : worst;
  for (const line of lines) parts.push(make("div", { className: `ck-say ck-${line.level}`, textContent: line.text, title: `${line.what}: ${line.level}` }));
  return make("div", { className: "ck-row" }, ...parts);
}

export default {
  render({ model, el }) {
    const { panel, head, body } = frame(el, "viewer", "Viewer");
    panel.classList.add("ck-scene");
    const fixed = make("select", { onchange: () => model.send({ type: "fix", frame: fixed.value }) });
    const buttons = Object.fromEntries(Object.entries(TOOLS).map(([name, text]) => [name, make("button", { textContent: text })]));
    const worst = make("span", { className: "ck-dot" });
    const fold = make("button", { title: "show or hide the list of displays", onclick: () => folded(panel.clientWidth, !panel.classList.contains("ck-folded")) },
      "Displays", worst);
    let chosen = false;
    const folded = (width, wish) => {
      chosen ||= wish !== undefined;
      if (!width || (chosen && wish === undefined)) return;
      const now = wish ?? width < NARROW;
      panel.classList.toggle("ck-folded", now);
      fold.setAttribute("aria-expanded", String(!now));
    };
    const sizes = new ResizeObserver(() => folded(panel.clientWidth));
    sizes.observe(panel);
    head.append(fold, make("label", { className: "ck-dim" }, "Fixed frame", fixed), ...Object.values(buttons));
    const list = make("div", { className: "ck-list" }), pane = make("div", { className: "ck-pane" });
    const labels = make("div", { className: "ck-labels" }), pictures = make("div", { className: "ck-pictures" });
    const aim = make("div", { className: "ck-aim" });
    aim.innerHTML = '<svg width="100%" height="100%"><defs><marker id="ck-tip" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="5" markerHeight="5" orient="auto"><path d="M0 0L8 4L0 8z"/></marker></defs><line style="display:none" marker-end="url(#ck-tip)"/></svg>';
    const told = make("div", { className: "ck-told" });
    const corner = make("div", { className: "ck-corner" });
    const stage = make("div", { className: "ck-stage", tabIndex: -1 }, pane, labels, aim, pictures, told, corner);
    body.append(list, stage);
    wheelIsThePages(stage);
    const images = new Map();
    let rows = "";

    const showImages = (names, buffers) => names.forEach((name, index) => {
      let shown = images.get(name);
      if (!shown) {
        const image = make("img", { alt: name, draggable: false });
        shown = { image, card: make("figure", {}, image, make("figcaption", { textContent: name })) };
        images.set(name, shown);
        pictures.append(shown.card);
      }
      if (shown.address) URL.revokeObjectURL(shown.address);
      shown.image.src = shown.address = URL.createObjectURL(new Blob([buffers[index]], { type: "image/jpeg" }));
    });
    const show = (message) => {
      stage.style.height = list.style.maxHeight = `${message.height}px`;
      const frames = message.frames.includes(message.fixed) ? message.frames : [message.fixed, ...message.frames];
      if (fixed.dataset.frames !== frames.join()) {
        fixed.replaceChildren(...frames.map((name) => make("option", { value: name, textContent: name })));
        fixed.dataset.frames = frames.join();
      }
      fixed.value = message.fixed;
      told.textContent = message.told;
      const text = JSON.stringify([message.rows, message.level, message.remark, message.skipped]);
      if (text === rows || list.contains(document.activeElement) && document.activeElement.matches(".ck-topic")) return;
      rows = text;
      const levels = [message.level, ...message.rows.filter((row) => row.on).map((row) => row.level)];
      worst.className = `ck-dot ck-${levels.reduce((one, other) => LEVELS.indexOf(other) > LEVELS.indexOf(one) ? other : one, "Ok")}`;
      const wrong = message.remark ? [make("div", { className: `ck-say ck-${message.level}`, textContent: message.remark })] : [];
      const skipped = message.skipped.map((name) => make("div", { className: "ck-say", textContent: `not known here: ${name}` }));
      list.replaceChildren(...wrong, ...message.rows.map((row) => rowOf(row, model)), ...skipped);
      const on = new Set(message.rows.filter((row) => row.on).map((row) => row.name));
      for (const [name, { card }] of images) card.hidden = !on.has(name);
    };
    const ready = (scene) => {
      const choose = useTools(stage, scene, buttons, model);
      for (const name of Object.keys(buttons)) buttons[name].addEventListener("click", () => choose(name));
    };
    const end = drawScene(model, { panel, pane, labels, corner, ready, pictures: showImages });
    const deaf = listen(model, { shown: show });
    return () => {
      sizes.disconnect();
      deaf();
      end();
      for (const { address } of images.values()) URL.revokeObjectURL(address);
    };
  },
};
