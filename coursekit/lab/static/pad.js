// A teleop pad: arrow keys or WASD, a stick, a gamepad. What it publishes is shown below.
export default {
  render({ model, el }) {
    const frame = document.createElement("div");
    frame.className = "ck-pad";
    frame.innerHTML = `
      <div class="ck-bar"><span class="ck-dot"></span><span class="ck-title"></span></div>
      <div class="ck-field" aria-label="${gettext("teleop pad; drive with the arrow keys or WASD")}">
        <div class="ck-keys"><kbd data-code="KeyQ">Q</kbd><kbd data-code="ArrowUp KeyW">▲</kbd><kbd data-code="KeyE">E</kbd>
          <kbd data-code="ArrowLeft KeyA">◀</kbd><kbd data-code="ArrowDown KeyS">▼</kbd><kbd data-code="ArrowRight KeyD">▶</kbd></div>
        <div class="ck-read"><div class="ck-line"><label>linear</label><meter class="x" min="-1" max="1"></meter><output class="ox"></output></div>
          <div class="ck-line"><label>angular</label><meter class="t" min="-1" max="1"></meter><output class="ot"></output></div>
          <div class="ck-hint">${gettext("click here, then arrow keys or WASD")}</div></div>
      </div>`;
    const part = (name) => frame.querySelector(name);
    const strafe = model.get("holonomic");
    const [linear, angular] = [model.get("linear"), model.get("angular")];
    const field = part(".ck-field");
    part(".ck-title").textContent = model.get("topic");
    for (const key of frame.querySelectorAll('[data-code="KeyQ"], [data-code="KeyE"]')) key.style.visibility = strafe ? "" : "hidden";
    const bar = (name, value) => {
      const meter = part(`meter.${name}`);
      meter.value = value;
      meter.style.setProperty("--v", value);
    };
    const changed = (wish, held) => {
      bar("x", wish.x);
      bar("t", wish.turn);
      part(".ox").textContent = `${(wish.x * linear).toFixed(2)} m/s`;
      part(".ot").textContent = `${(wish.turn * angular).toFixed(2)} rad/s`;
      frame.dataset.state = wish.x || wish.y || wish.turn ? "moving" : "";
      for (const key of frame.querySelectorAll("kbd")) {
        key.classList.toggle("down", key.dataset.code.split(" ").some((code) => held.has(code)));
      }
    };
    const steer = steering(field, (message) => model.send(message), { letters: true, strafe, gamepad: true, changed });
    field.prepend(touchStick(steer));
    const hint = part(".ck-hint").textContent;
    const link = () => {
      const lost = model.get("lost");
      part(".ck-hint").textContent = lost ? gettext("The link to {0} is gone: the robot does not hear you.", lost) : hint;
      part(".ck-hint").style.color = lost ? "#ff8a80" : "";
    };
    model.on("change:lost", link);
    link();
    field.addEventListener("pointerdown", () => field.focus({ preventScroll: true }));
    changed({ x: 0, y: 0, turn: 0 }, new Set());
    el.appendChild(frame);
    return () => {
      model.off("change:lost", link);
      steer.close();
    };
  },
};
