// One process: what it prints, how it is, Ctrl-C, "Run again", a line to type. All state is asked for on "ready".
const LINES = 500;
const COLOURS = ["#7d8b99", "#ff7b72", "#56d37d", "#e6c15c", "#6cb6ff", "#d2a8ff", "#5fd0d6", "#e6edf3"];
const STATES = { running: gettext("running"), finished: gettext("finished"), "exit code -2": gettext("stopped by Ctrl-C"),
  "exit code -15": gettext("terminated"), "exit code -9": gettext("killed") };
const ESCAPE = /\x1b\[([\d;]*)m|\x1b\[[\d;?]*[A-Za-ln-z]/g;

// The style after one colour code ("1;31").
function styled(style, codes) {
  const next = { ...style };
  for (const code of (codes || "0").split(";").map(Number)) {
    if (code === 0) { delete next.color; delete next.weight; }
    else if (code === 1) next.weight = 600;
    else if (code === 22) delete next.weight;
    else if (code === 39) delete next.color;
    else if (code >= 30 && code <= 37) next.color = COLOURS[code - 30];
    else if (code >= 90 && code <= 97) next.color = COLOURS[code - 90];
  }
  return next;
}

// One line as an element; levels of log lines have the colours that they have in a real terminal.
function drawn(text, style) {
  const row = document.createElement("div");
  const level = /(?:^|\] )\[(DEBUG|WARN|ERROR|FATAL)\] \[/.exec(text);
  if (level) row.className = `ck-log-${level[1]}`;
  let from = 0;
  const put = (part) => {
    if (!part) return;
    const span = document.createElement("span");
    span.textContent = part;
    if (style.color) span.style.color = style.color;
    if (style.weight) span.style.fontWeight = style.weight;
    row.appendChild(span);
  };
  for (const found of text.matchAll(ESCAPE)) {
    put(text.slice(from, found.index));
    from = found.index + found[0].length;
    if (found[1] !== undefined) style = styled(style, found[1]);
  }
  put(text.slice(from));
  if (!row.firstChild) row.appendChild(document.createElement("br"));
  return [row, style];
}

// Lines on a screen: a line that has not ended is drawn again when more of it comes; "\r" begins it anew.
class Screen {
  constructor(element) { this.element = element; this.clear(); }

  clear() {
    this.element.replaceChildren();
    this.rest = "";
    this.style = {};
    this.open = null;
  }

  add(text) {
    const lines = (this.rest + text).replaceAll("\r\n", "\n").split("\n");
    this.open?.remove();
    this.open = null;
    this.rest = lines.pop();
    for (const line of lines.slice(-LINES)) this.draw(line);
    if (this.rest) this.open = drawn(this.rest.split("\r").at(-1), this.style)[0];
    if (this.open) this.element.appendChild(this.open);
    while (this.element.childElementCount > LINES) this.element.firstChild.remove();
  }

  draw(line) {
    const [row, style] = drawn(line.split("\r").at(-1), this.style);
    this.style = style;
    this.element.appendChild(row);
  }

  remark(text) {
    const row = document.createElement("div");
    row.className = "ck-remark";
    row.textContent = text;
    this.element.appendChild(row);
  }
}

export default {
  render({ model, el }) {
    const panel = document.createElement("div");
    panel.className = "ck-terminal";
    panel.innerHTML = `
      <div class="ck-bar"><span class="ck-dot"></span><span class="ck-title"></span><span class="ck-state"></span>
      <button class="ck-again" title="${gettext("Start the same command line anew")}">${gettext("Run again")}</button>
      <button class="ck-stop" title="${gettext("Send Ctrl-C to this process")}">Ctrl-C</button></div>
      <div class="ck-screen" tabindex="0" role="log" data-lm-suppress-shortcuts="true"></div>
      <input class="ck-line" aria-label="${gettext("type a line")}" placeholder="${gettext("type here, then Enter")}"
             autocomplete="off" spellcheck="false" data-lm-suppress-shortcuts="true">`;
    const part = (name) => panel.querySelector(`.ck-${name}`);
    const element = part("screen");
    const screen = new Screen(element);
    part("title").textContent = model.get("title");
    const hear = (message) => {
      const atEnd = element.scrollTop + element.clientHeight >= element.scrollHeight - 12;
      if (message.whole) screen.clear();
      if (message.skipped) screen.remark(gettext("… {0} earlier lines …", message.skipped));
      screen.add(message.text);
      if (atEnd || message.whole) element.scrollTop = element.scrollHeight;
      part("title").title = message.command;
      part("state").textContent = STATES[message.state] ?? gettext("exit code {0}", message.state.replace("exit code ", ""));
      panel.dataset.again = message.again;
      const calm = ["finished", "exit code -2"].includes(message.state);
      panel.dataset.state = message.state === "running" ? "running" : calm ? "ok" : "failed";
    };
    part("stop").addEventListener("click", () => model.send({ type: "interrupt" }));
    part("again").addEventListener("click", () => model.send({ type: "again" }));
    panel.addEventListener("keydown", (event) => {
      if (event.ctrlKey && event.key === "c" && !window.getSelection().toString()) model.send({ type: "interrupt" });
      if (event.target === part("line")) event.stopPropagation();
      if (event.target !== part("line") || event.key !== "Enter") return;
      model.send({ type: "line", text: event.target.value });
      event.target.value = "";
    });
    model.on("msg:custom", hear);
    el.appendChild(panel);
    model.send({ type: "ready" });
    return () => model.off("msg:custom", hear);
  },
};
