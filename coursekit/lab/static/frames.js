// The live tree of frames: Python draws it, this shows it; a click tells where a frame is.
export default {
  render({ model, el }) {
    const { panel, head, body } = frame(el, "frames", gettext("Frames"));
    const box = make("input", { type: "checkbox", onchange: () => model.send({ type: "details", on: box.checked }) });
    head.append(make("label", {}, box, gettext("details")));
    const drawing = make("div", { className: "ck-drawing" });
    const where = make("div", { className: "ck-details", hidden: true });
    body.append(drawing, where);
    const named = (event) => event.target.closest?.(".ck-part")?.dataset.name ?? "";
    drawing.addEventListener("click", (event) => model.send({ type: "choose", name: named(event) }));
    drawing.addEventListener("keydown", (event) => event.key === "Enter" && model.send({ type: "choose", name: named(event) }));
    return listen(model, {
      past: ({ on }) => panel.classList.toggle("ck-of-past", on),
      shown(message) {
        if (drawing.dataset.svg !== message.svg) drawing.innerHTML = drawing.dataset.svg = message.svg;
        box.checked = message.details;
        for (const part of drawing.querySelectorAll(".ck-part"))
          part.classList.toggle("ck-chosen", part.dataset.name === message.chosen);
        where.hidden = !message.where;
        const close = make("button", { textContent: gettext("Close"), onclick: () => model.send({ type: "choose", name: "" }) });
        where.replaceChildren(close, make("pre", { textContent: message.where }));
      },
    });
  },
};
