// A live picture: JPEGs come as buffers, each is acknowledged when it is drawn, so that none ever waits in a queue.
// Below it are OpenCV's sliders; the mouse's events are told in pixels of the image, with OpenCV's numbers.
const DOWN = [1, 3, 2], UP = [4, 6, 5]; // by the browser's number of the button
const MOVED = 0, TWICE = 7, WHEEL = 10;

/** The sliders as the program has them, but for one that is being pulled. */
function drawSliders(box, sliders, pulled) {
  const there = new Map([...box.children].map((row) => [row.dataset.name, row]));
  for (const [name, row] of there) if (!sliders.some((one) => one.name === name)) row.remove();
  for (const { name, value, low, high } of sliders) {
    const row = there.get(name) ?? box.appendChild(newSlider(name, pulled));
    const [input, shown] = [row.querySelector("input"), row.querySelector("output")];
    Object.assign(input, { min: low, max: high });
    if (document.activeElement !== input) input.value = value;
    shown.textContent = input.value;
  }
}

function newSlider(name, pulled) {
  const row = document.createElement("label");
  row.dataset.name = name;
  row.innerHTML = '<span></span><input type="range" step="1"><output></output>';
  row.querySelector("span").textContent = name;
  const input = row.querySelector("input");
  input.addEventListener("input", () => {
    row.querySelector("output").textContent = input.value;
    pulled(name, Number(input.value));
  });
  return row;
}

/** Tell the events of the mouse over an image while `wanted()`. */
function watchMouse(image, wanted, tell) {
  const send = (event, number, turned = 0) => {
    if (!wanted() || !image.naturalWidth) return;
    const box = image.getBoundingClientRect();
    const [x, y] = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    const held = event.buttons & 7; // left, right, middle: OpenCV has the same numbers
    const keys = (event.ctrlKey ? 8 : 0) | (event.shiftKey ? 16 : 0) | (event.altKey ? 32 : 0);
    tell({ event: number, x: Math.floor(x * image.naturalWidth), y: Math.floor(y * image.naturalHeight),
      flags: held | keys | (turned << 16) }); // a signed upper half, as cv2.getMouseWheelDelta reads it
  };
  let waiting = null;
  image.addEventListener("pointermove", (event) => { // at most once a frame
    if (waiting === null) requestAnimationFrame(() => { send(waiting, MOVED); waiting = null; });
    waiting = event;
  });
  image.addEventListener("pointerdown", (event) => { image.setPointerCapture(event.pointerId); send(event, DOWN[event.button] ?? 1); });
  image.addEventListener("pointerup", (event) => send(event, UP[event.button] ?? 4));
  image.addEventListener("dblclick", (event) => send(event, TWICE));
  image.addEventListener("contextmenu", (event) => { if (wanted()) event.preventDefault(); });
  image.addEventListener("wheel", (event) => {
    if (!wanted()) return;
    event.preventDefault();
    send(event, WHEEL, event.deltaY < 0 ? 120 : -120);
  }, { passive: false });
}

export default {
  render({ model, el }) {
    const frame = document.createElement("div");
    frame.className = "ck-picture";
    frame.innerHTML = `
      <div class="ck-bar"><span class="ck-dot"></span><span class="ck-title"></span><span class="ck-note"></span></div>
      <div class="ck-screen" tabindex="0" data-lm-suppress-shortcuts="true"><img alt="" draggable="false"><div class="ck-empty"></div></div>
      <div class="ck-sliders"></div>`;
    const part = (name) => frame.querySelector(`.ck-${name}`);
    const screen = part("screen");
    const image = frame.querySelector("img");
    let address = null;
    let times = [];
    let mouse = false;
    watchMouse(image, () => mouse, (event) => model.send({ type: "mouse", ...event }));
    const hear = async (message, buffers) => {
      part("title").textContent = message.title;
      frame.dataset.state = message.open ? "open" : "closed";
      part("empty").textContent = message.empty ?? "";
      drawSliders(part("sliders"), message.sliders ?? [], (name, value) => model.send({ type: "slider", name, value }));
      mouse = message.mouse ?? false;
      frame.dataset.mouse = mouse;
      if (!buffers?.length) { part("note").textContent = message.note ?? ""; return; }
      const next = URL.createObjectURL(new Blob([buffers[0]], { type: "image/jpeg" }));
      image.src = next;
      try { await image.decode(); } catch { /* replaced by a newer one */ }
      if (address) URL.revokeObjectURL(address);
      address = next;
      image.style.maxWidth = `${message.width}px`;
      const now = performance.now();
      times = [...times.filter((one) => now - one < 1000), now];
      const rate = message.live && times.length > 2 ? ` · ${times.length - 1} fps` : "";
      part("note").textContent = `${message.note}${rate}`;
      model.send({ type: "shown" });
    };
    screen.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const special = { Escape: 27, Enter: 13, Tab: 9, Backspace: 8, " ": 32 };
      const code = special[event.key] ?? (event.key.length === 1 ? event.key.charCodeAt(0) : null);
      if (code === null) return;
      event.preventDefault();
      event.stopPropagation();
      model.send({ type: "key", code });
    });
    model.on("msg:custom", hear);
    el.appendChild(frame);
    model.send({ type: "ready" });
    return () => { model.off("msg:custom", hear); if (address) URL.revokeObjectURL(address); };
  },
};
