// A live picture: JPEGs come as buffers, each is acknowledged when it is drawn, so that none ever waits in a queue.
export default {
  render({ model, el }) {
    const frame = document.createElement("div");
    frame.className = "ck-picture";
    frame.innerHTML = `
      <div class="ck-bar"><span class="ck-dot"></span><span class="ck-title"></span><span class="ck-note"></span></div>
      <div class="ck-screen" tabindex="0" data-lm-suppress-shortcuts="true"><img alt="" draggable="false"><div class="ck-empty"></div></div>`;
    const part = (name) => frame.querySelector(`.ck-${name}`);
    const screen = part("screen");
    const image = frame.querySelector("img");
    let address = null;
    let times = [];
    const hear = async (message, buffers) => {
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
