// One process: what it prints, how it is, a Ctrl-C button, a line to type. All state is asked for on "ready".
const LINES = 500;

function append(screen, message) {
  const atEnd = screen.scrollTop + screen.clientHeight >= screen.scrollHeight - 8;
  if (message.whole) screen.textContent = "";
  const skipped = message.skipped ? `… ${message.skipped} lines left out …\n` : "";
  screen.appendChild(document.createTextNode(skipped + message.text));
  const lines = screen.textContent.split("\n");
  if (lines.length > 2 * LINES) screen.textContent = lines.slice(-LINES).join("\n");
  if (atEnd || message.whole) screen.scrollTop = screen.scrollHeight;
}

export default {
  render({ model, el }) {
    const frame = document.createElement("div");
    frame.className = "ck-terminal";
    frame.innerHTML = `
      <div class="ck-bar"><span class="ck-dot"></span><span class="ck-title"></span><span class="ck-state"></span>
      <button class="ck-stop" title="Send Ctrl-C to this process">Ctrl-C</button></div>
      <pre class="ck-screen" tabindex="0" aria-live="polite"></pre>
      <input class="ck-line" aria-label="type a line" placeholder="type here, then Enter"
             autocomplete="off" spellcheck="false" data-lm-suppress-shortcuts="true">`;
    const part = (name) => frame.querySelector(`.ck-${name}`);
    part("title").textContent = model.get("title");
    const hear = (message) => {
      append(part("screen"), message);
      part("state").textContent = message.state;
      frame.dataset.state = message.state === "running" ? "running" : message.state === "finished" ? "ok" : "failed";
    };
    part("stop").addEventListener("click", () => model.send({ type: "interrupt" }));
    part("line").addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.ctrlKey && event.key === "c" && !window.getSelection().toString()) model.send({ type: "interrupt" });
      if (event.key !== "Enter") return;
      model.send({ type: "line", text: event.target.value });
      event.target.value = "";
    });
    model.on("msg:custom", hear);
    el.appendChild(frame);
    model.send({ type: "ready" });
    return () => model.off("msg:custom", hear);
  },
};
