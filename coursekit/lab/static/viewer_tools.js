// RViz's tools. Three act where the picture is clicked, and it can be turned meanwhile; three are dragged on the floor.
const PICKS = { select: ["Select", "s", gettext("Click a thing to see what it is")], focus: ["Focus", "c", gettext("Click a thing to look at it")],
  measure: ["Measure", "n", gettext("Click two points to measure their distance")] };
const TOOLS = { goal: ["2D Goal Pose", "g"], estimate: ["2D Pose Estimate", "p"], point: ["Publish Point", "u"] };
const STEADY = 5; // pixels: a press that moves further turns the camera

const toolButtons = (tools) => Object.fromEntries(Object.entries(tools).map(([name, [text, key]]) =>
  [name, make("button", { textContent: text, title: `${text} (${key.toUpperCase()})` })]));

// A line between two points of the scene, with its length beside it.
class Ruler {
  constructor(scene, svg, labels) {
    this.scene = scene;
    this.ends = [];
    this.line = svg.querySelector(".ck-ruler");
    this.pill = make("span", { className: "ck-text ck-length" });
    labels.append(this.pill);
    scene.after.push(() => this.draw());
    this.draw();
  }

  set(ends) { this.ends = ends; this.scene.view.set_dirty(); this.draw(); }

  get length() { return Math.hypot(...this.ends[0].map((one, axis) => one - this.ends[1][axis])); }

  draw() {
    const ends = this.ends.map((end) => this.scene.pixel(end)), [a, b] = [ends[0], ends[1] ?? ends[0]];
    const seen = ends.length > 0 && ends.every((end) => end.seen);
    this.line.style.display = seen ? "" : "none";
    this.pill.style.display = seen && ends.length === 2 ? "" : "none";
    if (!seen) return;
    for (const [name, value] of Object.entries({ x1: a.x, y1: a.y, x2: b.x + (ends.length < 2 ? 0.01 : 0), y2: b.y })) this.line.setAttribute(name, value);
    if (ends.length < 2) return;
    this.pill.textContent = `${this.length.toFixed(3)} m`;
    this.pill.style.transform = `translate(${((a.x + b.x) / 2).toFixed(1)}px, ${((a.y + b.y) / 2).toFixed(1)}px)`;
  }
}

// What the Select tool says: a card with the thing's values, and a box around the thing or a ring on the dot.
class Selection {
  constructor(scene, three, svg, card) {
    Object.assign(this, { scene, card, ring: svg.querySelector(".ck-ring"), picked: null, marked: null, around: null });
    this.three = three;
    const edges = new three.EdgesGeometry(new three.BoxGeometry(1, 1, 1));
    this.box = new three.LineSegments(edges, new three.LineBasicMaterial({ color: 0xff9d1c, depthTest: false }));
    Object.assign(this.box, { visible: false, matrixAutoUpdate: false, renderOrder: 9 });
    scene.view.scene.add(this.box);
    scene.after.push(() => this.draw());
  }

  // This thing is it: what is shown of it may have been replaced.
  mark(number) {
    if (number === this.marked) return;
    this.marked = number;
    const object = this.scene.view.scene_tree.find(["scene"]).children[number]?.object ?? null;
    let meshes = 0;
    object?.traverse((one) => { if (one.isMesh && !one.material.map) meshes++; });
    this.around = meshes ? object : null;
    this.box.visible = meshes > 0;
    this.frame();
    this.scene.view.set_dirty();
  }

  // The box goes around the thing, a little wider.
  frame() {
    if (!this.around) return;
    const around = new this.three.Box3().setFromObject(this.around), size = around.getSize(this.scene.vector());
    const { matrix } = this.box, world = this.scene.view.scene.matrixWorld; // MeshCat turns its scene
    matrix.compose(around.getCenter(this.scene.vector()), new this.three.Quaternion(), size.multiplyScalar(1.06).addScalar(0.01));
    matrix.premultiply(world.clone().invert());
    this.box.matrixWorldNeedsUpdate = true;
  }

  show(picked) {
    this.picked = picked;
    this.card.hidden = !picked;
    this.scene.view.set_dirty();
    if (!picked) return;
    const text = JSON.stringify([picked.name, picked.facts]);
    if (text === this.card.dataset.says) return;
    this.card.dataset.says = text;
    this.card.querySelector("b").textContent = picked.name;
    this.card.querySelector("dl").replaceChildren(...picked.facts.flatMap(([what, value]) => [make("dt", { textContent: what }), make("dd", { textContent: value })]));
  }

  draw() {
    this.frame();
    const place = this.picked && !this.around && this.scene.pixel(this.picked.at);
    this.ring.style.display = place && place.seen ? "" : "none";
    if (place) { this.ring.setAttribute("cx", place.x); this.ring.setAttribute("cy", place.y); }
  }
}

// One tool at a time; null is moving the camera.
function useTools(stage, scene, buttons, model, { ruler, hint }) {
  let tool = null, start = null, press = null;
  const svg = stage.querySelector(".ck-aim svg"), line = svg.querySelector(".ck-drag");
  const choose = (name) => {
    tool = tool === name ? null : name;
    for (const [key, button] of Object.entries(buttons)) button.setAttribute("aria-pressed", String(key === tool));
    scene.view.controls.enabled = !(tool in TOOLS);
    stage.classList.toggle("ck-aiming", tool in TOOLS);
    stage.classList.toggle("ck-picking", tool in PICKS);
    hint.textContent = PICKS[tool]?.[2] ?? "";
    if (tool === "measure") ruler.set([]);
  };
  const inside = (event) => { const box = stage.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
  const draw = (event) => {
    const [x, y] = inside(event);
    line.setAttribute("x2", x); line.setAttribute("y2", y);
  };
  // A thing, else the floor.
  const under = (event) => {
    const found = scene.hit(event), floor = scene.floor(event);
    return found ?? (floor && { number: null, at: [floor.x, floor.y, 0] });
  };
  const clicked = (event) => {
    if (tool === "select") { const found = scene.hit(event); model.send({ type: "pick", number: found?.number ?? null, at: found?.at ?? null }); return; }
    const found = under(event);
    if (!found) return;
    if (tool === "focus") { scene.focus(found.at); choose(tool); return; }
    ruler.set(ruler.ends.length === 1 ? [ruler.ends[0], found.at] : [found.at]);
    if (ruler.ends.length === 2) hint.textContent = gettext("Length: {0} m. Click two points to measure again, Escape to end", ruler.length.toFixed(3));
  };
  stage.addEventListener("pointerdown", (event) => { press = event.button === 0 && event.target.closest(".ck-pane") ? inside(event) : null; }, { capture: true });
  stage.addEventListener("pointerup", (event) => {
    if (!(tool in PICKS) || !press) return;
    const [x, y] = inside(event);
    if (Math.hypot(x - press[0], y - press[1]) < STEADY) clicked(event);
    press = null;
  }, { capture: true });
  svg.addEventListener("pointerdown", (event) => {
    const place = tool && scene.floor(event);
    if (!place) return;
    event.preventDefault();
    svg.setPointerCapture(event.pointerId);
    if (tool === "point") { model.send({ type: "tool", tool, ...place, z: 0 }); choose(tool); return; }
    start = place;
    const [x, y] = inside(event);
    line.setAttribute("x1", x); line.setAttribute("y1", y);
    draw(event);
    line.style.display = "";
  });
  svg.addEventListener("pointermove", (event) => start && draw(event));
  svg.addEventListener("pointerup", (event) => {
    if (!start) return;
    const end = scene.floor(event) ?? start;
    const yaw = Math.atan2(end.y - start.y, end.x - start.x);
    model.send({ type: "tool", tool, ...start, yaw });
    start = null;
    line.style.display = "none";
    choose(tool);
  });
  stage.addEventListener("keydown", (event) => {
    if (event.target.closest("input, select") || event.ctrlKey || event.altKey || event.metaKey) return;
    const name = Object.entries({ ...PICKS, ...TOOLS }).find(([, [, key]]) => key === event.key)?.[0];
    if (name) choose(name);
    else if (event.key === "Escape") {
      if (tool !== null) choose(tool);
      ruler.set([]);
      model.send({ type: "pick", number: null, at: null });
    }
  });
  for (const [name, button] of Object.entries(buttons)) button.addEventListener("click", () => choose(name));
}
