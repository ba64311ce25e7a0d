// A view that its program has left stays as it was, says what to do, and takes no input: it never looks alive.
// That is so when the kernel restarts or ends, and when Python says {type: "ended", text}, with a still where nothing is drawn yet.
const GONE = new Set(["restarting", "autorestarting", "terminating", "dead"]);
const AGAIN = gettext("Run its cell again to have it live.");

// A panel in a cell has a button that puts it on the desk, where it stays in sight; on the desk it needs none.
function offerDesk(model, inner) {
  const bar = inner.querySelector(".ck-head, .ck-bar");
  if (!bar || !model.widget_manager?.kernel) return;  // elsewhere than in JupyterLab nothing stands beside a notebook
  const button = document.createElement("button");
  button.className = "ck-to-desk";
  button.textContent = "⇥";
  button.title = gettext("To the desk, beside the notebook");
  button.setAttribute("aria-label", button.title);
  button.style.cssText = "margin-left: auto; order: 99; padding: 0 7px; font-size: 14px; line-height: 20px; cursor: pointer;"
    + "color: inherit; background: none; border: 1px solid color-mix(in srgb, currentColor 35%, transparent); border-radius: 5px;";
  button.addEventListener("click", (event) => { event.stopPropagation(); model.send({ type: "desk" }); });
  bar.append(button);
  requestAnimationFrame(() => { button.hidden = Boolean(inner.closest(".jupyterlab-sidecar")); });
}

function veiled(widget) {
  return { ...widget, render(context) {
    const { model, el } = context;
    const inner = document.createElement("div");
    inner.style.height = "100%";
    el.append(inner);
    const still = (text, picture) => {
      const figure = document.createElement("div");
      figure.className = "ck-still";
      if (picture) {
        const image = document.createElement("img");
        image.src = URL.createObjectURL(new Blob([picture], { type: "image/png" }));
        image.style.maxWidth = "100%";
        figure.append(image);
      } else {
        const lines = document.createElement("pre");
        lines.textContent = text;
        figure.append(lines);
      }
      inner.replaceChildren(figure);
    };
    const lower = (why) => {
      if (el.querySelector(":scope > .ck-veil")) return;
      const veil = document.createElement("div");
      veil.className = "ck-veil";
      veil.setAttribute("role", "status");
      veil.style.cssText = "position: absolute; inset: 0; z-index: 10; display: flex; align-items: flex-start; justify-content: center;"
        + "background: color-mix(in srgb, var(--jp-layout-color1, #fff) 45%, transparent); cursor: not-allowed;"
        + "font: 600 13px/1.5 var(--jp-ui-font-family, system-ui, sans-serif); color: #26323b; text-align: center;";
      veil.innerHTML = `<span style="background: #fff3c4; border: 1px solid #e0c46c; border-radius: 0 0 8px 8px; padding: 4px 14px"></span>`;
      veil.firstChild.textContent = `${why} ${AGAIN}`;
      el.style.position = "relative";
      inner.inert = true;
      document.activeElement?.blur?.();
      el.append(veil);
    };
    const hear = (message, buffers) => {
      if (message.type !== "ended") return;
      if (message.still) still(message.text, buffers?.[0]);
      lower(message.why);
    };
    model.on("msg:custom", hear);
    const kernel = model.widget_manager?.kernel;
    const status = (_kernel, now) => { if (GONE.has(now)) lower(gettext("The kernel was restarted.")); };
    kernel?.statusChanged?.connect(status);
    const drawn = widget.render({ ...context, el: inner });
    Promise.resolve(drawn).then(() => offerDesk(model, inner));
    return async () => {
      model.off("msg:custom", hear);
      kernel?.statusChanged?.disconnect(status);
      (await drawn)?.();
    };
  } };
}
