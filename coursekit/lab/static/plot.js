// Curves over time: the newest at the right; the time line below goes back, and the pointer reads values.
const KEPT = 9000;
const SPANS = [5, 10, 20, 60, 300];
const INKS = { light: ["#2f6fb0", "#c2410c", "#2f8f57", "#7c3aed", "#b45309", "#0e7490"], dark: ["#79b4ee", "#fb923c", "#6fd197", "#c4b5fd", "#fcd34d", "#67e8f9"] };

// Round steps, about `count` of them between two numbers.
function steps(from, to, count) {
  const rough = (to - from || 1) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((one) => one * power).find((one) => one >= rough);
  const first = Math.ceil(from / step - 1e-9) * step;
  return Array.from({ length: Math.max(0, Math.floor((to - first) / step + 1e-9) + 1) }, (_, i) => first + i * step);
}

// The first place of sorted points whose time is not before `time`.
function place(points, time) {
  let low = 0, high = points.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (points[middle][0] < time) low = middle + 1; else high = middle;
  }
  return low;
}

const short = (value) => Math.abs(value) >= 1e5 || (value && Math.abs(value) < 1e-3) ? value.toExponential(2) : String(Number(value.toPrecision(4)));

export default {
  render({ model, el }) {
    const { head, body } = frame(el, "plot", gettext("Plot"));
    const canvas = make("canvas");
    canvas.setAttribute("role", "img");
    const legend = make("div", { className: "ck-legend" });
    const slider = make("input", { type: "range", min: 0, max: 1, step: "any", value: 1, oninput: () => { follow = false; held = true; at = Number(slider.value); draw(); model.send({ type: "go", at }); } });
    slider.addEventListener("change", () => { held = false; });
    slider.setAttribute("aria-label", gettext("time line"));
    const when = make("span", { className: "ck-when ck-dim" });
    const span = make("select", { onchange: draw });
    span.setAttribute("aria-label", gettext("how much is shown"));
    const live = make("button", { textContent: gettext("Live"), onclick: () => { follow = true; draw(); model.send({ type: "go", at: null }); } });
    head.append(span, live);
    body.append(canvas, legend, make("div", { className: "ck-line" }, slider, when));
    let curves = {}, now = 0, isLive = true, follow = true, held = false, at = 0, pointer = null, known = false;

    function begin() { return Math.min(now, ...Object.values(curves).filter((one) => one.length).map((one) => one[0][0])); }
    function shownTo() { return follow ? now : at; }

    function draw() {
      const start = begin(), width = Number(span.value) || now - start || 1;
      const first = start + Math.min(width, now - start);
      slider.disabled = first >= now;  // all is in sight
      slider.min = slider.disabled ? now - 1 : first;
      slider.max = now;
      slider.value = shownTo();
      live.hidden = !isLive || follow;
      const to = shownTo(), from = to - width;
      when.textContent = follow && isLive ? gettext("now, {0} s", to.toFixed(1)) : gettext("{0} of {1} s", to.toFixed(1), now.toFixed(1));
      paint(from, to);
    }

    function paint(from, to) {
      const dark = document.body.dataset.jpThemeLight === "false", inks = INKS[dark ? "dark" : "light"];
      const style = getComputedStyle(canvas.closest(".ck-panel"));
      const ink = style.getPropertyValue("--ck-dim"), rim = style.getPropertyValue("--ck-rim");
      const [w, h, scale] = [canvas.clientWidth, canvas.clientHeight, window.devicePixelRatio || 1];
      if (!w) return;
      canvas.width = w * scale; canvas.height = h * scale;
      const pen = canvas.getContext("2d");
      pen.scale(scale, scale);
      pen.font = "12px system-ui, sans-serif"; pen.lineWidth = 1;
      const names = Object.keys(curves).sort();
      const parts = names.map((name) => curves[name].slice(Math.max(0, place(curves[name], from) - 1), place(curves[name], to) + 1));
      const values = parts.flatMap((points) => points.map(([, value]) => value)).filter(Number.isFinite);
      let low = values.reduce((a, b) => Math.min(a, b), Infinity), high = values.reduce((a, b) => Math.max(a, b), -Infinity);
      if (low > high) [low, high] = [0, 1];
      const margin = (high - low) * 0.08 || Math.abs(high) * 0.1 || 0.5;
      low -= margin; high += margin;
      const box = { left: 58, right: w - 8, top: 6, bottom: h - 22 };
      const x = (time) => box.left + (time - from) / (to - from || 1) * (box.right - box.left);
      const y = (value) => box.bottom - (value - low) / (high - low) * (box.bottom - box.top);
      pen.strokeStyle = rim; pen.fillStyle = ink;
      pen.textAlign = "right"; pen.textBaseline = "middle";
      for (const value of steps(low, high, 5)) { rule(pen, box.left, y(value), box.right, y(value)); pen.fillText(short(value), box.left - 6, y(value)); }
      pen.textAlign = "center"; pen.textBaseline = "top";
      for (const time of steps(from, to, 8)) {
        if (time < -1e-9) continue;
        rule(pen, x(time), box.top, x(time), box.bottom);
        pen.fillText(`${short(time)} s`, Math.min(Math.max(x(time), box.left + 10), box.right - 14), box.bottom + 6);
      }
      pen.save();
      pen.beginPath(); pen.rect(box.left, box.top, box.right - box.left, box.bottom - box.top); pen.clip();
      pen.lineWidth = 1.8; pen.lineJoin = "round";
      parts.forEach((points, i) => {
        pen.strokeStyle = inks[i % inks.length];
        pen.beginPath();
        let drawn = false;  // what is no number is a gap
        for (const [time, value] of points) {
          if (value !== null) pen[drawn ? "lineTo" : "moveTo"](x(time), y(value));
          drawn = value !== null;
        }
        pen.stroke();
      });
      pen.restore();
      let read = to;
      if (pointer !== null && pointer >= box.left && pointer <= box.right) {
        read = from + (pointer - box.left) / (box.right - box.left) * (to - from);
        pen.strokeStyle = ink; rule(pen, pointer, box.top, pointer, box.bottom);
      }
      legend.replaceChildren(...names.map((name, i) => {
        const at = curves[name][Math.max(0, place(curves[name], read + 1e-9) - 1)];
        const mark = make("i"); mark.style.background = inks[i % inks.length];
        return make("span", {}, mark, `${name}  ${at && at[0] <= read + 1e-9 ? (at[1] === null ? gettext("no number") : short(at[1])) : ""}`);
      }));
      if (!names.length) legend.replaceChildren(make("span", { className: "ck-dim", textContent: gettext("No numbers yet: they come with the next message.") }));
      canvas.setAttribute("aria-label", names.length ? gettext("curves of {0}", names.join(", ")) : gettext("no curves yet"));
    }

    function rule(pen, x1, y1, x2, y2) { pen.beginPath(); pen.moveTo(x1, y1); pen.lineTo(x2, y2); pen.stroke(); }

    canvas.addEventListener("pointermove", (event) => { pointer = event.offsetX; draw(); });
    canvas.addEventListener("pointerleave", () => { pointer = null; draw(); });
    const sized = new ResizeObserver(draw);
    sized.observe(canvas);
    const deaf = listen(model, {
      look(said) {
        if (held) return;  // that is where a hand has put it
        follow = said.at === null;
        at = said.at ?? at;
        draw();
      },
      shown(said) {
        now = said.now; isLive = said.live;
        if (!known) {
          const spans = [...new Set([...SPANS, said.seconds])].sort((a, b) => a - b);
          span.replaceChildren(...spans.map((one) => make("option", { value: one, textContent: `${one} s` })), make("option", { value: "", textContent: gettext("all") }));
          span.value = said.live ? said.seconds : "";
          known = true;
        }
        for (const [name, points] of Object.entries(said.news)) {
          const had = curves[name] ?? [];
          const back = points.length && had.length && points[0][0] < had[had.length - 1][0];
          curves[name] = [...(back ? [] : had), ...points].slice(-KEPT);
        }
        canvas.dataset.points = Object.values(curves).reduce((sum, one) => sum + one.length, 0);
        draw();
      },
    });
    return () => { sized.disconnect(); deaf(); };
  },
};
