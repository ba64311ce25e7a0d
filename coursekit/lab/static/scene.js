// A scene in 3D: MeshCat draws what Python sends; this adds labels, the camera, and where the pointer is on the floor.
const FIELD = 45;
const AFAR = 30; // so many times further away, and narrower by as much, a camera sees parallel lines as parallel
const tan = (degrees) => Math.tan((degrees * Math.PI) / 360);
const NARROW_FIELD = (Math.atan(tan(FIELD) / AFAR) * 360) / Math.PI;
const REACH = 6; // pixels beside a dot or a line that still hit it

// MeshCat's own code, once per page: Python sends it, it is not part of any widget's state.
function meshcat(model) {
  globalThis.coursekitMeshcat ??= new Promise((resolve) => {
    const hear = async (message, buffers) => {
      if (message.type !== "library") return;
      model.off("msg:custom", hear);
      const parts = ["const module = { exports: {} }; const exports = module.exports; (function (define) {\n", buffers[0],
        "\n}).call(globalThis, undefined);\nexport default module.exports;"];
      const address = URL.createObjectURL(new Blob(parts, { type: "text/javascript" }));
      resolve((await import(/* webpackIgnore: true */ address)).default);
      URL.revokeObjectURL(address);
    };
    model.on("msg:custom", hear);
    model.send({ type: "library" });
  });
  return globalThis.coursekitMeshcat;
}

class Scene {
  constructor(library, pane, labels) {
    this.labels = labels;
    this.texts = new Map();
    this.touched = false;
    this.rays = new library.THREE.Raycaster();
    const view = this.view = new library.Viewer(pane);
    view.gui.domElement.style.display = "none";
    for (const name of ["Grid", "Axes"]) view.scene_tree.find([name]).object.visible = false;
    this.deaf = followTheme(view);
    dotsStaySeen(library.THREE);
    this.shadows = new Shadows(library.THREE, view);
    this.after = []; // called when a picture was drawn
    this.flatten(false);
    const resize = view.set_3d_pane_size.bind(view), size = new library.THREE.Vector2(1, 1);
    view.set_3d_pane_size = () => {
      if (!pane.clientWidth) return;
      size.set(pane.clientWidth, pane.clientHeight);
      resize(pane.clientWidth, pane.clientHeight);
    };
    const put = view.set_object.bind(view);
    view.set_object = (path, object) => {
      if (object.isLineSegments && object.userData.least) widen(library.THREE, object, size);
      put(path, object);
    };
    this.watcher = new ResizeObserver(() => view.set_3d_pane_size());
    this.watcher.observe(pane);
    const render = view.render.bind(view);
    view.render = () => { render(); this.placeTexts(); this.after.forEach((one) => one()); };
    view.controls.addEventListener("start", () => { this.touched = true; });
    this.vector = () => view.camera.position.clone();
  }

  // A sun in place of lamps near the origin, which glare on a floor.
  daylight({ DirectionalLight }) {
    const lights = this.view.scene_tree.find(["Lights"]);
    for (const name of ["PointLightNegativeX", "PointLightPositiveX", "FillLight"]) lights.find([name]).object.visible = false;
    for (const [x, y, z, bright] of [[-4, 9, 5, 0.5], [6, 5, -3, 0.25]]) {
      const sun = new DirectionalLight(0xffffff, bright);
      sun.position.set(x, y, z);
      lights.object.add(sun);
    }
  }

  node(number) { return this.view.scene_tree.find(["scene", String(number)]); }

  apply(message, poses, commands) {
    if (message.whole) {
      this.view.delete_path(["scene"]);
      this.texts.forEach((text) => text.element.remove());
      this.texts.clear();
      this.shadows.clear();
    }
    for (const number of message.gone) {
      this.view.delete_path(["scene", String(number)]);
      this.shadows.gone(number);
      for (const [key, text] of this.texts) if (text.of === number) { text.element.remove(); this.texts.delete(key); }
    }
    for (const command of commands) this.view.handle_command_bytearray(command);
    for (let at = 0; at < poses.length; at += 11) {
      const object = this.node(poses[at]).object;
      object.position.set(poses[at + 1], poses[at + 2], poses[at + 3]);
      object.quaternion.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 7]);
      object.scale.set(poses[at + 8], poses[at + 9], poses[at + 10]);
    }
    this.shadows.add(message.solid);
    if (poses.length) this.shadows.place((number) => this.node(number));
    const fresh = [];
    message.labels.forEach((label, index) => {
      const element = make("span", { className: label.height ? "ck-text ck-big" : "ck-text", textContent: label.text });
      if (label.height) element.style.color = label.colour;
      if (label.light) element.classList.add("ck-light");
      this.labels.append(element);
      const text = { element, of: label.of, height: label.height, kept: false };
      this.texts.set(`${label.of} ${index} ${message.n}`, text);
      if (!label.height) fresh.push(text);
    });
    for (const text of fresh) Object.assign(text, { width: text.element.offsetWidth, rows: text.element.offsetHeight });
    this.view.set_dirty();
  }

  placeTexts() {
    const { dom_element: pane } = this.view;
    const zoom = pane.clientHeight / 2 / tan(this.view.camera.fov);
    const names = [], large = [];
    for (const text of this.texts.values()) {
      const { element, of, height } = text;
      const { x, y, depth, seen } = this.onScreen(this.node(of).object.getWorldPosition(this.vector()));
      element.style.display = seen ? "" : "none";
      if (!seen) { text.kept = false; continue; }
      const high = Math.min(200, (height / depth) * zoom);
      if (height) { element.style.fontSize = `${high}px`; large.push(boxOfLarge(x, y, element.textContent.length, high)); }
      else names.push({ text, x, y, depth });
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
    thinOut(names, large);
  }

  // Where a place of MeshCat's world is in the picture, in pixels, and how far ahead.
  onScreen(place) {
    const { camera, dom_element: pane } = this.view;
    const depth = -place.clone().applyMatrix4(camera.matrixWorldInverse).z;
    place.project(camera);
    const seen = depth > 0.02 && Math.abs(place.x) < 1.2 && Math.abs(place.y) < 1.2;
    return { x: ((place.x + 1) / 2) * pane.clientWidth, y: ((1 - place.y) / 2) * pane.clientHeight, depth, seen };
  }

  // Where a point [x, y, z] of the fixed frame is in the picture.
  pixel([x, y, z]) { return this.onScreen(this.vector().set(x, z, -y)); }

  // As a map shows it, far things as large as near ones and from straight above; or as an eye sees it.
  flatten(flat) {
    const { camera, controls } = this.view;
    this.flat = flat;
    this.stretch = flat ? AFAR : 1;
    camera.fov = flat ? NARROW_FIELD : FIELD;
    camera.far = 500 * this.stretch;
    controls.maxPolarAngle = flat ? 1e-3 : Math.PI;
  }

  // MeshCat's world has y up: (x, y, z) of ROS is (x, z, -y) there.
  look({ distance, yaw, pitch, target: [x, y, z], flat = false }) {
    this.flatten(flat);
    const away = distance * this.stretch, along = away * Math.cos(Math.min(pitch, Math.PI / 2 - 1e-3));
    const { camera, controls } = this.view;
    controls.target.set(x, z, -y);
    camera.position.set(x + along * Math.cos(yaw), z + away * Math.sin(pitch), -(y + along * Math.sin(yaw)));
    camera.updateProjectionMatrix();
    controls.update();
    this.view.set_3d_pane_size();
    this.view.set_dirty();
  }

  // From where it is looked now, as `look` takes it.
  lookedFrom() {
    const { camera, controls } = this.view;
    const { x, y, z } = camera.position.clone().sub(controls.target), distance = Math.hypot(x, y, z);
    const at = controls.target;
    return { distance: distance / this.stretch, flat: this.flat, yaw: Math.atan2(-z, x), pitch: Math.asin(y / distance), target: [at.x, -at.z, at.y] };
  }

  // The camera stays where it is and looks at a point; from now on it turns about that.
  focus([x, y, z]) {
    const { controls } = this.view;
    this.touched = true;
    controls.target.set(x, z, -y);
    controls.update();
    this.view.set_dirty();
    controls.dispatchEvent({ type: "end" });
  }

  // The camera goes with what it follows, [x, y, z, yaw]; null: it stands.
  follow(place) {
    const last = this.followed;
    this.followed = place;
    if (!last || !place) return;
    const [from, to] = [last, place].map(([x, y, z]) => this.vector().set(x, z, -y));
    const { camera, controls } = this.view;
    for (const one of [controls.target, camera.position]) {
      const away = one.clone().sub(from), [cos, sin] = [Math.cos(place[3] - last[3]), Math.sin(place[3] - last[3])];
      one.set(to.x + away.x * cos + away.z * sin, to.y + away.y, to.z + away.z * cos - away.x * sin);
    }
    controls.update();
    this.view.set_dirty();
  }

  // What of the scene is under the pointer, the nearest first: its number and where, in the fixed frame; null where nothing is.
  hit(event, may = () => true) {
    const { camera, controls, dom_element: pane } = this.view;
    const box = pane.getBoundingClientRect();
    const at = { x: ((event.clientX - box.left) / box.width) * 2 - 1, y: 1 - ((event.clientY - box.top) / box.height) * 2 };
    camera.updateMatrixWorld();
    this.view.scene.updateMatrixWorld(); // what came since the last picture has no place yet
    this.rays.setFromCamera(at, camera);
    const near = (REACH / box.height) * 2 * tan(camera.fov) * camera.position.distanceTo(controls.target);
    this.rays.params.Points.threshold = this.rays.params.Line.threshold = near;
    const numbers = new Map(Object.entries(this.view.scene_tree.find(["scene"]).children).map(([number, node]) => [node.object, number]));
    for (const { object, point } of this.rays.intersectObjects([...numbers.keys()], true)) {
      let one = object;
      while (one && !numbers.has(one)) one = one.parent;
      if (one && may(numbers.get(one))) return { number: Number(numbers.get(one)), at: [point.x, -point.z, point.y], object };
    }
    return null;
  }

  // The number of the nearest thing under the pointer among those that `may(number)` allows; null where there is none.
  thing(event, may) {
    const found = this.hit(event, may);
    return found === null ? null : String(found.number);
  }

  // Where the floor, z = 0 of the fixed frame, is under the pointer; null above the horizon.
  floor(event) {
    const { camera, dom_element: pane } = this.view;
    const box = pane.getBoundingClientRect();
    const far = this.vector().set(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2, 0.5);
    camera.updateMatrixWorld();
    far.unproject(camera);
    const eye = camera.getWorldPosition(this.vector());
    const part = eye.y / (eye.y - far.y);
    return part > 0 ? { x: eye.x + (far.x - eye.x) * part, y: -(eye.z + (far.z - eye.z) * part) } : null;
  }

  close() {
    this.watcher.disconnect();
    this.deaf();
    this.view.animate = () => {};
    this.view.renderer.dispose();
    this.view.renderer.forceContextLoss();
  }
}

// The wheel scrolls the page until the picture is clicked: who reads on must not get stuck in it.
function wheelIsThePages(stage) {
  const note = make("div", { className: "ck-wheel", textContent: gettext("Click the picture, then the wheel zooms") });
  let timer = null;
  stage.append(note);
  stage.addEventListener("pointerdown", () => stage.focus({ preventScroll: true }));
  stage.addEventListener("wheel", (event) => {
    if (stage.contains(document.activeElement)) return;
    event.stopPropagation();
    note.classList.add("ck-seen");
    clearTimeout(timer);
    timer = setTimeout(() => note.classList.remove("ck-seen"), 1500);
  }, { capture: true });
}

// Draws what Python streams; two buttons lead the camera. `ready(scene, library)` is called once MeshCat is there, `pictures` with
// what is shown beside the scene, `drawn` after each message. Gives the function that ends it.
function drawScene(model, { panel, pane, labels, corner, ready, pictures = () => {}, drawn = () => {} }) {
  const home = make("button", { textContent: gettext("Reset view"), title: gettext("look from where it was at first") });
  const top = make("button", { textContent: gettext("From above"), title: gettext("look straight down") });
  corner.append(home, top);
  const early = [];
  let scene = null, view = null, closed = false;
  const bytes = (buffer) => new Uint8Array(buffer.buffer, buffer.byteOffset, buffer.byteLength);
  const hear = (message, buffers) => {
    if (message.type !== "scene") return;
    if (!scene) { early.push([message, buffers]); return; }
    const count = buffers.length - message.images.length;
    scene.apply(message, new Float64Array(bytes(buffers[0]).slice().buffer), buffers.slice(1, count).map(bytes));
    pictures(message.images, buffers.slice(count));
    if (message.view) {
      view = message.view;
      if (!scene.touched || view.anew) { scene.look(view); scene.followed = null; }
    }
    scene.follow(message.follow);
    drawn(message);
    panel.dataset.messages = message.n;
    panel.classList.toggle("ck-of-past", message.past);
    requestAnimationFrame(() => model.send({ type: "drawn", n: message.n }));
  };
  model.on("msg:custom", hear);
  meshcat(model).then((library) => {
    if (closed) return;
    panel.viewer = scene = new Scene(library, pane, labels);
    labels.after(new Compass(scene).element);
    ready(scene, library);
    home.addEventListener("click", () => { scene.touched = false; model.send({ type: "home" }); });
    top.addEventListener("click", () => {
      scene.touched = true;
      scene.look({ ...scene.lookedFrom(), pitch: Math.PI / 2, yaw: -Math.PI / 2 });
      scene.view.controls.dispatchEvent({ type: "end" });
    });
    for (const [message, buffers] of early.splice(0)) hear(message, buffers);
    model.send({ type: "open" });
  });
  return () => {
    closed = true;
    model.off("msg:custom", hear);
    scene?.close();
  };
}
