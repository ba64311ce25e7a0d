// A live picture: JPEGs come as buffers, each is acknowledged when it is drawn, so that none ever waits in a queue.
export default {
  render({ model, el }) {
    const frame = document.createElement("div");
    frame.className = "ck-picture";
    frame.innerHTML = `
      <div class="ck-bar"><span class="ck-dot"></span><span class="ck-title"></span><span class="ck-note"></span></div>
      <div class="ck-screen" tabindex="0" data-lm-suppress-shortcuts="true"><img alt="" draggable="false"><div class="ck-empty"></div></div>
      <div class="ck-trackbars" data-lm-suppress-shortcuts="true"></div>`;
    const part = (name) => frame.querySelector(`.ck-${name}`);
    const screen = part("screen");
    const image = frame.querySelector("img");
    let address = null;
    let times = [];
    // A trackbar that is being dragged is left alone: its own values come back while it moves on.
    const bars = new Map();
    let mouse = false;
    const arrange = ({ trackbars = [], ...rest }) => {
      mouse = rest.mouse ?? false;
      const names = trackbars.map(({ name }) => name).join("\n");
      if (names !== [...bars.keys()].join("\n")) {
        bars.clear();
        part("trackbars").replaceChildren(...trackbars.map(({ name }) => {
          const label = document.createElement("label");
          const [text, value] = [document.createElement("span"), document.createElement("output")];
          const bar = Object.assign(document.createElement("input"), { type: "range" });
          text.textContent = name;
          bar.addEventListener("input", () => {
            value.textContent = bar.value;
            model.send({ type: "slide", name, value: Number(bar.value) });
          });
          label.append(text, bar, value);
          bars.set(name, { bar, value });
          return label;
        }));
      }
      for (const one of trackbars) {
        const { bar, value } = bars.get(one.name);
        if (bar.matches(":active")) continue;
        Object.assign(bar, { min: one.min, max: one.max });
        bar.value = one.value;
        value.textContent = one.value;
      }
    };
    // OpenCV's numbers: an event is its base and the button's place (left, right, middle); flags are bits.
    const PLACES = [0, 2, 1];
    const tell = (event, number) => {
      if (!mouse || !image.naturalWidth) return;
      const box = image.getBoundingClientRect();
      const x = Math.floor(((event.clientX - box.left) / box.width) * image.naturalWidth);
      const y = Math.floor(((event.clientY - box.top) / box.height) * image.naturalHeight);
      const held = event.buttons | (event.type === "mouseup" ? [1, 4, 2][event.button] ?? 0 : 0);
      const flags = (held & 7) | (event.ctrlKey ? 8 : 0) | (event.shiftKey ? 16 : 0) | (event.altKey ? 32 : 0);
      model.send({ type: "mouse", event: number, x, y, flags });
    };
    for (const [kind, base] of [["mousedown", 1], ["mouseup", 4], ["dblclick", 7]]) {
      image.addEventListener(kind, (event) => tell(event, base + (PLACES[event.button] ?? 0)));
    }
    image.addEventListener("mousemove", (event) => tell(event, 0));
    part("trackbars").addEventListener("keydown", (event) => event.stopPropagation()); // the notebook has other uses for arrows
    image.addEventListener("contextmenu", (event) => { if (mouse) event.preventDefault(); });
    const hear = async (message, buffers) => {
      arrange(message);
      part("title").textContent = message.title;
      frame.dataset.state = message.open ? "open" : "closed";
      part("empty").textContent = message.empty ?? "";
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
