// The live tree of frames: Python draws it, this shows it; a click tells where a frame is.
export default {
  render({ model, el }) {
    const { panel, head, body } = frame(el, "frames", gettext("Frames"));
    const box = make("input", { type: "checkbox", onchange: () => model.send({ type: "times", on: box.checked }) });
    head.append(make("label", {}, box, gettext("details")));
    const { drawing, details, show } = drawingOf(model);
    body.append(drawing, details);
    return listen(model, {
      past: ({ on }) => panel.classList.toggle("ck-of-past", on),
      shown(message) {
        box.checked = message.times;
        show(message);
      },
    });
  },
};
