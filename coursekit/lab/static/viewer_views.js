// The camera: which frame it goes with, and views that are kept.
const STILL = "<Fixed Frame>";
const CAMERAS = { Orbit: "Orbit", ThirdPersonFollower: "Third Person Follower", TopDownOrtho: "Top Down Ortho" };
const CALM = 300; // milliseconds after which a moved camera is told

function viewsCard(model) {
  const kind = make("select", {}, ...Object.entries(CAMERAS).map(([value, textContent]) => make("option", { value, textContent })));
  const frame = make("select", {});
  for (const one of [kind, frame]) one.addEventListener("change", () => model.send({ type: "follow", frame: frame.value, kind: kind.value }));
  const name = make("input", { type: "text", placeholder: gettext("name of this view"), spellcheck: false });
  name.setAttribute("aria-label", gettext("Name of this view"));
  const keep = () => {
    if (!name.value.trim()) { name.focus(); return; }
    model.send({ type: "view", does: "save", name: name.value });
    name.value = "";
  };
  name.addEventListener("keydown", (event) => { if (event.key === "Enter") keep(); });
  const saved = make("ul", { className: "ck-views" });
  const shown = card(gettext("Views"), "ck-looking", make("label", {}, gettext("Type"), kind), make("label", {}, gettext("Target frame"), frame),
    make("div", { className: "ck-keep" }, name, make("button", { textContent: gettext("Save"), onclick: keep })), saved);
  const button = make("button", { textContent: gettext("Views"), title: gettext("follow a frame, keep views") });
  opens(button, shown);
  const line = (one) => make("li", {},
    make("button", { textContent: one, title: gettext("look from \"{0}\"", one), onclick: () => model.send({ type: "view", does: "use", name: one }) }),
    make("button", { textContent: "×", ariaLabel: gettext("Forget {0}", one), title: gettext("forget \"{0}\"", one), onclick: () => model.send({ type: "view", does: "forget", name: one }) }));
  const show = ({ frames, looking }) => {
    const all = [...new Set(["", ...frames, looking.frame])];
    if (frame.dataset.all !== all.join()) {
      frame.replaceChildren(...all.map((value) => make("option", { value, textContent: value || STILL })));
      frame.dataset.all = all.join();
    }
    if (document.activeElement !== frame) frame.value = looking.frame;
    if (document.activeElement !== kind) kind.value = looking.type;
    if (saved.dataset.all !== looking.views.join("\n")) {
      saved.replaceChildren(...looking.views.map(line));
      saved.dataset.all = looking.views.join("\n");
    }
  };
  return { button, shown, show };
}

// Python is told where a hand has put the camera, when the hand rests: a reload, a still and a saved file keep it.
function tellCamera(scene, model) {
  let timer = null;
  const tell = () => { model.send({ type: "look", ...scene.lookedFrom() }); };
  scene.view.controls.addEventListener("end", () => { clearTimeout(timer); timer = setTimeout(tell, CALM); });
  return () => clearTimeout(timer);
}
