// TurtleSim's window: paper with strokes, turtles on top, driven by keys or by the stick. All state comes in messages.
const EASE_MS = 70;

function turtleCanvas(canvas, model) {
  const side = model.get("side");
  const shape = model.get("shape");
  const kinds = model.get("kinds");
  const paper = document.createElement("canvas");
  let strokes = [];
  let state = { turtles: [], background: [69, 86, 255], running: false };
  let shown = {};
  let since = 0;
  let frame = null;
  let scale = 1;

  const fit = () => {
    const width = Math.max(120, canvas.clientWidth) * (window.devicePixelRatio || 1);
    canvas.width = canvas.height = paper.width = paper.height = Math.round(width);
    scale = canvas.width / (side + 1 / 45);
    repaint();
  };
  const at = (x, y) => [x * scale, (side - y) * scale];
  const drawStroke = (context, { colour, width, points }) => {
    context.strokeStyle = `rgb(${colour})`;
    context.lineWidth = width * canvas.width / 500;
    context.lineCap = context.lineJoin = "round";
    context.beginPath();
    points.forEach(([x, y], number) => context[number ? "lineTo" : "moveTo"](...at(x, y)));
    context.stroke();
  };
  const repaint = () => {
    const context = paper.getContext("2d");
    context.clearRect(0, 0, paper.width, paper.height);
    for (const stroke of strokes) drawStroke(context, stroke);
    wake();
  };
  const drawTurtle = (context, name, kind, x, y, theta) => {
    const [u, v] = at(x, y);
    const colours = kinds[kind % kinds.length];
    context.save();
    context.translate(u, v);
    context.rotate(-theta);
    context.scale(scale, -scale);
    context.shadowColor = "rgba(10, 15, 60, .45)";
    context.shadowBlur = 0.10 * scale;
    context.shadowOffsetY = 0.05 * scale;
    for (const [role, corners] of shape) {
      context.beginPath();
      corners.forEach(([a, b], number) => context[number ? "lineTo" : "moveTo"](a, b));
      context.closePath();
      context.fillStyle = colours[role] ?? "#26313a";
      context.fill();
      if (role === "rim") context.shadowColor = "transparent";
    }
    context.restore();
  };
  const between = (from, to, part) => {
    const turn = Math.atan2(Math.sin(to[4] - from[4]), Math.cos(to[4] - from[4]));
    const far = Math.hypot(to[2] - from[2], to[3] - from[3]) > 1;
    if (far) return to;
    return [to[0], to[1], from[2] + (to[2] - from[2]) * part, from[3] + (to[3] - from[3]) * part, from[4] + turn * part];
  };
  const draw = () => {
    frame = null;
    const context = canvas.getContext("2d");
    const part = Math.min(1, (performance.now() - since) / EASE_MS);
    context.fillStyle = `rgb(${state.background})`;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(paper, 0, 0);
    for (const turtle of state.turtles) {
      const now = between(shown[turtle[0]] ?? turtle, turtle, part);
      drawTurtle(context, ...now);
      if (part === 1) shown[turtle[0]] = turtle;
    }
    if (!state.running) { context.fillStyle = "rgba(18, 24, 60, .55)"; context.fillRect(0, 0, canvas.width, canvas.height); }
    if (part < 1) wake();
  };
  const wake = () => { frame ??= requestAnimationFrame(draw); };
  const watch = new ResizeObserver(fit);
  watch.observe(canvas);

  return {
    take(message) {
      const part = Math.min(1, (performance.now() - since) / EASE_MS);
      const before = {};
      for (const turtle of state.turtles) before[turtle[0]] = between(shown[turtle[0]] ?? turtle, turtle, part);
      shown = before;
      since = performance.now();
      state = message;
      if (message.whole) strokes = [];
      let redraw = message.whole;
      for (const { i, from, colour, width, points } of message.strokes) {
        const stroke = (strokes[i] ??= { colour, width, points: [] });
        stroke.points.splice(from, Infinity, ...points);
        const tail = { colour, width, points: stroke.points.slice(Math.max(0, from - 1)) };
        if (!redraw) drawStroke(paper.getContext("2d"), tail);
      }
      if (redraw) repaint();
      wake();
    },
    at(event) {
      const box = canvas.getBoundingClientRect();
      const x = (event.clientX - box.left) / box.width * side;
      const y = side - (event.clientY - box.top) / box.height * side;
      return state.turtles.find((one) => Math.hypot(one[2] - x, one[3] - y) < 0.6)?.[0];
    },
    close() { watch.disconnect(); if (frame) cancelAnimationFrame(frame); },
  };
}

export default {
  render({ model, el }) {
    const frame = document.createElement("div");
    frame.className = "ck-turtle";
    frame.innerHTML = `
      <div class="ck-bar"><span class="ck-dot"></span><span class="ck-title">TurtleSim</span>
        <span class="ck-node"></span><span class="ck-pose"></span></div>
      <div class="ck-sheet" aria-label="${gettext("turtlesim window; drive with the arrow keys")}"><canvas></canvas>
        <div class="ck-empty"></div><div class="ck-hint"></div></div>`;
    const part = (name) => frame.querySelector(name);
    const sheet = part(".ck-sheet");
    el.appendChild(frame);
    const view = turtleCanvas(part("canvas"), model);
    let driven = model.get("turtle");
    const hint = () => {
      const focused = document.activeElement === sheet;
      part(".ck-hint").textContent = focused ? gettext("driving {0} with the arrow keys", driven) : gettext("click here, then drive with the arrow keys");
    };
    const steer = steering(sheet, (message) => model.send(message));
    sheet.appendChild(touchStick(steer));
    sheet.addEventListener("focus", hint);
    sheet.addEventListener("blur", hint);
    part("canvas").addEventListener("pointerdown", (event) => {
      const name = view.at(event);
      if (name && name !== driven) model.send({ type: "pick", name });
      sheet.focus({ preventScroll: true });
    });
    const hear = (message) => {
      driven = message.driven;
      view.take(message);
      frame.dataset.state = message.running ? "running" : "none";
      part(".ck-node").textContent = message.node;
      part(".ck-empty").textContent = message.running ? "" : message.note;
      const pose = message.turtles.find((one) => one[0] === driven);
      const degrees = pose ? Math.round(pose[4] * 180 / Math.PI) : 0;
      part(".ck-pose").textContent = pose ? `${driven}  x ${pose[2].toFixed(2)}  y ${pose[3].toFixed(2)}  θ ${degrees}°` : "";
      hint();
    };
    model.on("msg:custom", hear);
    model.send({ type: "ready" });
    return () => { model.off("msg:custom", hear); steer.close(); view.close(); };
  },
};
