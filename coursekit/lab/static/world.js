// The simulated world: MeshCat draws it; this adds the simulator's clock, and hands that drag, add and remove.
const EVERY = 50; // milliseconds between two messages of a drag

// Pressing a thing takes hold of it, on the floor it turns the camera; with the box tool it puts a box there.
function useHands(stage, scene, model, state) {
  let from = null, sent = 0;
  const may = (number) => number in state.names;
  const over = (event) => (event.target.closest(".ck-pane") ? scene.thing(event, may) : null);
  stage.addEventListener("pointerdown", (event) => {
    const floor = scene.floor(event);
    if (!event.target.closest(".ck-pane") || event.button !== 0) return;
    if (state.boxing) {
      event.stopPropagation();
      if (floor) model.send({ type: "box", ...floor });
      state.box(false);
      return;
    }
    const number = over(event);
    state.choose(number === null ? null : state.names[number]);
    if (number === null || !floor) return;
    event.stopPropagation();
    event.preventDefault();
    stage.setPointerCapture(event.pointerId);
    model.send({ type: "pick", name: state.chosen });
    from = floor;
  }, { capture: true });
  stage.addEventListener("pointermove", (event) => {
    if (!from) {
      if (!event.buttons) stage.classList.toggle("ck-over", over(event) !== null);
      return;
    }
    event.stopPropagation();
    const floor = scene.floor(event);
    if (!floor || event.timeStamp - sent < EVERY) return;
    sent = event.timeStamp;
    model.send({ type: "drag", x: floor.x - from.x, y: floor.y - from.y });
  }, { capture: true });
  for (const end of ["pointerup", "pointercancel"]) stage.addEventListener(end, (event) => {
    const floor = from && scene.floor(event);
    if (floor && sent) model.send({ type: "drag", x: floor.x - from.x, y: floor.y - from.y });
    from = null;
    sent = 0;
  }, { capture: true });
  stage.addEventListener("keydown", (event) => {
    if (event.key === "Delete" && state.chosen) state.remove();
  });
}

export default {
  render({ model, el }) {
    const { panel, head, body } = frame(el, "world", gettext("World"));
    panel.classList.add("ck-scene");
    const press = (button) => model.send({ type: "press", button });
    const play = make("button", { textContent: gettext("Pause"), onclick: () => press(play.dataset.does) });
    const step = make("button", { textContent: gettext("Step"), title: gettext("let 0.05 s pass"), onclick: () => press("step") });
    const reset = make("button", { textContent: gettext("Reset"), title: gettext("everything back to where it began"), onclick: () => press("reset") });
    const speed = make("select", { onchange: () => model.send({ type: "speed", speed: Number(speed.value) }) });
    const lasers = make("input", { type: "checkbox", onchange: () => model.send({ type: "lasers", on: lasers.checked }) });
    const box = make("button", { textContent: gettext("Add a box"), title: gettext("then click the floor"), onclick: () => state.box(!state.boxing) });
    const time = make("span", { className: "ck-dim ck-time" });
    const remove = make("button", { textContent: gettext("Remove"), hidden: true, onclick: () => state.remove() });
    head.append(play, step, reset, make("label", { className: "ck-dim" }, gettext("Speed"), speed), box,
      make("label", { className: "ck-dim" }, lasers, gettext("Laser")), remove, time);
    const pane = make("div", { className: "ck-pane" }), labels = make("div", { className: "ck-labels" });
    const told = make("div", { className: "ck-told" }), nothing = make("div", { className: "ck-nothing", hidden: true });
    const corner = make("div", { className: "ck-corner" });
    const stage = make("div", { className: "ck-stage", tabIndex: -1 }, pane, labels, told, corner, nothing);
    body.append(stage);
    wheelIsThePages(stage);
    const state = {
      names: {}, chosen: null, boxing: false,
      choose(name) {
        state.chosen = name;
        remove.hidden = name === null;
        remove.textContent = gettext("Remove {0}", name);
      },
      remove() { model.send({ type: "remove", name: state.chosen }); state.choose(null); },
      box(on) {
        state.boxing = on;
        box.setAttribute("aria-pressed", String(on));
        stage.classList.toggle("ck-boxing", on);
      },
    };
    panel.world = state;
    const show = (message) => {
      stage.style.height = `${message.height}px`;
      nothing.hidden = message.there;
      nothing.textContent = message.there ? "" : message.told;
      for (const part of [play, step, reset, speed, box, lasers]) part.disabled = !message.there;
      if (!message.there) { time.textContent = ""; return; }
      told.textContent = message.told;
      state.names = message.names;
      if (state.chosen !== null && !Object.values(state.names).includes(state.chosen)) state.choose(null);
      play.textContent = message.paused ? gettext("Play") : gettext("Pause");
      play.dataset.does = message.paused ? "play" : "pause";
      step.disabled = !message.paused;
      lasers.checked = message.lasers;
      if (speed.options.length !== message.speeds.length)
        speed.replaceChildren(...message.speeds.map((times) => make("option", { value: times, textContent: `${times} x` })));
      if (document.activeElement !== speed) speed.value = message.speed;
      time.textContent = `${message.time.toFixed(1)} s` + (message.paused ? gettext(", paused") : gettext(", {0} x real time", message.factor.toFixed(2)));
    };
    const ready = (scene, { THREE }) => {
      scene.daylight(THREE);
      useHands(stage, scene, model, state);
    };
    const end = drawScene(model, { panel, pane, labels, corner, ready });
    const deaf = listen(model, { shown: show });
    return () => { deaf(); end(); };
  },
};
