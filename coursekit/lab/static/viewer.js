// The viewer: MeshCat draws what Python sends; around it the list of displays, RViz's tools and the camera.
const NARROW = 620; // pixels of a viewer below which the list of displays is folded at first
const AIM = `<svg width="100%" height="100%"><defs><marker id="ck-tip" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="5" markerHeight="5"
  orient="auto"><path d="M0 0L8 4L0 8z"/></marker></defs><line class="ck-drag" style="display:none" marker-end="url(#ck-tip)"/>
  <line class="ck-ruler" style="display:none"/><circle class="ck-ring" r="7" style="display:none"/></svg>`;

// What there may be of displays; Python is asked once.
function knownKinds(model) {
  let known = null, hear = null;
  const kinds = () => {
    known ??= new Promise((resolve) => { hear = resolve; model.send({ type: "kinds" }); });
    return known;
  };
  return { kinds, hear: (message) => hear?.(message.kinds) };
}

// The list is folded where there is little room, until somebody wishes otherwise.
function foldable(panel, button) {
  let chosen = false;
  const folded = (wish) => {
    chosen ||= wish !== undefined;
    if (!panel.clientWidth || (chosen && wish === undefined)) return;
    const now = wish ?? panel.clientWidth < NARROW;
    panel.classList.toggle("ck-folded", now);
    button.setAttribute("aria-expanded", String(!now));
  };
  button.addEventListener("click", () => folded(!panel.classList.contains("ck-folded")));
  const sizes = new ResizeObserver(() => folded());
  sizes.observe(panel);
  return sizes;
}

// Pictures of cameras, in the corner.
function cornerPictures(element) {
  const images = new Map();
  const show = (names, buffers) => names.forEach((name, index) => {
    let shown = images.get(name);
    if (!shown) {
      const image = make("img", { alt: name, draggable: false });
      shown = { image, card: make("figure", {}, image, make("figcaption", { textContent: name })) };
      images.set(name, shown);
      element.append(shown.card);
    }
    if (shown.address) URL.revokeObjectURL(shown.address);
    shown.image.src = shown.address = URL.createObjectURL(new Blob([buffers[index]], { type: "image/jpeg" }));
  });
  const only = (names) => { for (const [name, { card }] of images) card.hidden = !names.has(name); };
  return { show, only, end: () => { for (const { address } of images.values()) URL.revokeObjectURL(address); } };
}

export default {
  render({ model, el }) {
    const { panel, head, body } = frame(el, "viewer", gettext("Viewer"));
    panel.classList.add("ck-scene");
    const fixed = make("select", { onchange: () => model.send({ type: "fix", frame: fixed.value }) });
    const tools = toolButtons(TOOLS), picks = toolButtons(PICKS);
    const worst = make("span", { className: "ck-dot" });
    const fold = make("button", { title: gettext("show or hide the list of displays") }, gettext("Displays"), worst);
    const sizes = foldable(panel, fold);
    head.append(fold, make("label", { className: "ck-dim" }, gettext("Fixed frame"), fixed), ...Object.values(tools));
    const { kinds, hear } = knownKinds(model);
    const adding = addDialog(model, kinds), saving = saveDialog(model), views = viewsCard(model);
    const rows = make("div", { className: "ck-rows" });
    const list = make("div", { className: "ck-list" }, rows, make("div", { className: "ck-foot" }, adding.button, saving.button));
    const displays = new DisplayList(model, rows, kinds);
    const pane = make("div", { className: "ck-pane" }), labels = make("div", { className: "ck-labels" });
    const pictures = make("div", { className: "ck-pictures" }), beside = cornerPictures(pictures);
    const aim = make("div", { className: "ck-aim", innerHTML: AIM });
    const told = make("div", { className: "ck-told" }), hint = make("div", { className: "ck-hint" });
    hint.setAttribute("role", "status");
    const picked = make("div", { className: "ck-picked", hidden: true }, make("b"), make("button", { textContent: "×", ariaLabel: gettext("Close the selection"),
      onclick: () => model.send({ type: "pick", number: null, at: null }) }), make("dl"));
    const corner = make("div", { className: "ck-corner" }), left = make("div", { className: "ck-corner ck-left" }, ...Object.values(picks));
    const stage = make("div", { className: "ck-stage", tabIndex: -1 }, pane, labels, aim, pictures, told, hint, left, corner, picked,
      views.shown, adding.shown, saving.shown);
    body.append(list, stage);
    wheelIsThePages(stage);
    let selection = null, calm = () => {}, last = null;

    const show = (message) => {
      last = message;
      stage.style.height = list.style.maxHeight = `${message.height}px`;
      const frames = message.frames.includes(message.fixed) ? message.frames : [message.fixed, ...message.frames];
      if (fixed.dataset.frames !== frames.join()) {
        fixed.replaceChildren(...frames.map((name) => make("option", { value: name, textContent: name })));
        fixed.dataset.frames = frames.join();
      }
      if (document.activeElement !== fixed) fixed.value = message.fixed;
      told.textContent = message.told;
      worst.className = `ck-dot ck-${displays.show(message)}`;
      beside.only(new Set(message.rows.filter((row) => row.on).map((row) => row.name)));
      views.show(message);
      selection?.show(message.picked);
    };
    const ready = (scene, { THREE }) => {
      const ruler = new Ruler(scene, aim, labels);
      selection = panel.selection = new Selection(scene, THREE, aim, picked);
      useTools(stage, scene, { ...picks, ...tools }, model, { ruler, hint });
      calm = tellCamera(scene, model);
      if (last) show(last);
    };
    const end = drawScene(model, { panel, pane, labels, corner, ready, pictures: beside.show, drawn: ({ marked }) => selection?.mark(marked) });
    corner.append(views.button);
    const deaf = listen(model, { shown: show, kinds: hear, topics: adding.hear });
    return () => {
      sizes.disconnect();
      calm();
      deaf();
      end();
      beside.end();
    };
  },
};
