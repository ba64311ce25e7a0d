// Keys, a touch stick and a gamepad, as one wish {x: forward, y: left, turn: left}, each from -1 to 1.
// The wish is sent when it changes and every 100 ms while it is not zero. Keys end with the focus; all ends with the window's.
const ARROWS = { ArrowUp: ["x", 1], ArrowDown: ["x", -1], ArrowLeft: ["turn", 1], ArrowRight: ["turn", -1] };
const LETTERS = { KeyW: ["x", 1], KeyS: ["x", -1], KeyA: ["turn", 1], KeyD: ["turn", -1] };
const STRAFE = { KeyQ: ["y", 1], KeyE: ["y", -1] };
const BEAT_MS = 100;

function steering(field, say, { letters = false, strafe = false, gamepad = false, changed = () => {} } = {}) {
  const meanings = { ...ARROWS, ...(letters ? LETTERS : {}), ...(strafe ? STRAFE : {}) };
  const held = new Set();
  const stick = { x: 0, y: 0, turn: 0 };
  const joy = { x: 0, y: 0, turn: 0 };
  let last = "";
  let beat = null;

  const wish = () => {
    const total = { x: stick.x + joy.x, y: stick.y + joy.y, turn: stick.turn + joy.turn };
    for (const code of held) total[meanings[code][0]] += meanings[code][1];
    for (const part in total) total[part] = Math.round(Math.max(-1, Math.min(1, total[part])) * 1000) / 1000;
    return total;
  };
  const tell = () => say({ type: "drive", ...wish() });
  const update = () => {
    const now = wish();
    const text = JSON.stringify(now);
    if (text === last) return;
    last = text;
    tell();
    changed(now, held);
    const moving = now.x || now.y || now.turn;
    if (moving && !beat) beat = setInterval(tell, BEAT_MS);
    if (!moving && beat) beat = clearInterval(beat);
  };
  const release = () => { held.clear(); update(); };

  const down = (event) => {
    if (!(event.code in meanings) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    held.add(event.code);
    update();
  };
  const up = (event) => {
    if (!held.delete(event.code)) return;
    event.preventDefault();
    event.stopPropagation();
    update();
  };
  const away = () => {
    for (const hand of [stick, joy]) hand.x = hand.y = hand.turn = 0;
    release();
  };
  const hidden = () => { if (document.hidden) away(); };
  field.tabIndex = 0;
  field.dataset.lmSuppressShortcuts = "true";
  field.addEventListener("keydown", down);
  field.addEventListener("keyup", up);
  field.addEventListener("blur", release);
  window.addEventListener("blur", away);
  document.addEventListener("visibilitychange", hidden);

  let frame = null;
  const poll = () => {
    const here = document.hasFocus() && !document.hidden;
    const pad = here ? [...(navigator.getGamepads?.() ?? [])].find((one) => one) : null;
    const axis = (number) => (pad && Math.abs(pad.axes[number] ?? 0) > 0.12 ? -pad.axes[number] : 0);
    [joy.x, joy.turn] = [axis(1), axis(0)];
    if (strafe) [joy.y, joy.turn] = [axis(0), axis(2)];
    update();
    frame = requestAnimationFrame(poll);
  };
  if (gamepad) poll();

  return {
    set(part) { Object.assign(stick, part); update(); },
    close() {
      if (frame) cancelAnimationFrame(frame);
      window.removeEventListener("blur", away);
      document.removeEventListener("visibilitychange", hidden);
      away();
    },
  };
}

// A round stick for finger or mouse; letting go centres it.
function touchStick(steer) {
  const base = document.createElement("div");
  base.className = "ck-stick";
  base.innerHTML = `<span class="ck-mark n">▲</span><span class="ck-mark s">▼</span><span class="ck-mark w">◀</span>
    <span class="ck-mark e">▶</span><div class="ck-knob"></div>`;
  const knob = base.querySelector(".ck-knob");
  const place = (u, v) => { knob.style.transform = `translate(calc(-50% + ${u * 30}px), calc(-50% + ${v * 30}px))`; };
  const move = (event) => {
    const box = base.getBoundingClientRect();
    let u = (event.clientX - box.left) / box.width * 2 - 1;
    let v = (event.clientY - box.top) / box.height * 2 - 1;
    const length = Math.hypot(u, v);
    if (length > 1) { u /= length; v /= length; }
    place(u, v);
    const snap = (value) => (Math.abs(value) < 0.15 ? 0 : value);
    steer.set({ x: snap(-v), turn: snap(-u) });
  };
  const end = () => { base.classList.remove("held"); place(0, 0); steer.set({ x: 0, turn: 0 }); };
  base.addEventListener("pointerdown", (event) => {
    base.setPointerCapture(event.pointerId);
    base.classList.add("held");
    move(event);
  });
  base.addEventListener("pointermove", (event) => { if (base.classList.contains("held")) move(event); });
  for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) base.addEventListener(name, end);
  place(0, 0);
  return base;
}
