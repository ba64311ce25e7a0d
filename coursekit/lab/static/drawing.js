// A picture of parts that Python draws; a click on a part asks for details, which are shown below the picture.
function drawingOf(model) {
  const drawing = make("div", { className: "ck-drawing" });
  const named = (event) => event.target.closest?.(".ck-part")?.dataset.name ?? "";
  const choose = (name) => model.send({ type: "choose", name });
  drawing.addEventListener("click", (event) => choose(named(event)));
  drawing.addEventListener("keydown", (event) => event.key === "Enter" && choose(named(event)));
  const text = make("pre");
  const details = make("div", { className: "ck-details", hidden: true },
    make("button", { textContent: gettext("Close"), onclick: () => choose("") }), text);
  const show = unlessPressed(drawing, ({ svg, chosen, details: said }) => {
    if (drawing.dataset.svg !== svg) drawing.innerHTML = drawing.dataset.svg = svg;
    for (const part of drawing.querySelectorAll(".ck-part")) part.classList.toggle("ck-chosen", part.dataset.name === chosen);
    details.hidden = !said;
    text.textContent = said;
  });
  return { drawing, details, named, show };
}
