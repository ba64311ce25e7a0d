// A scene in 3D: MeshCat draws what Python sends; this adds labels, the camera, and where the pointer is on the floor.
const FIELD = 45;

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
    Object.assign(view.scene_tree.find(["Background"]).object, { top_color: [245, 247, 250], bottom_color: [221, 226, 232] });
    view.show_background();
    view.camera.fov = FIELD;
    view.camera.far = 500;
    const resize = view.set_3d_pane_size.bind(view);
    view.set_3d_pane_size = () => pane.clientWidth && resize(pane.clientWidth, pane.clientHeight);
    this.watcher = new ResizeObserver(() => view.set_3d_pane_size());
    this.watcher.observe(pane);
    const render = view.render.bind(view);
    view.render = () => { render(); this.placeTexts(); };
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
    }
    for (const number of message.gone) {
      this.view.delete_path(["scene", String(number)]);
      for (const [key, text] of this.texts) if (text.of === number) { text.element.remove(); this.texts.delete(key); }
    }
    for (const command of commands) this.view.handle_command_bytearray(command);
    for (let at = 0; at < poses.length; at += 11) {
      const object = this.node(poses[at]).object;
      object.position.set(poses[at + 1], poses[at + 2], poses[at + 3]);
      object.quaternion.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 7]);
      object.scale.set(poses[at + 8], poses[at + 9], poses[at + 10]);
    }
    message.labels.forEach((label, index) => {
      const element = make("span", { className: label.height ? "ck-text ck-big" : "ck-text", textContent: label.text });
      if (label.height) element.style.color = label.colour;
      if (label.light) element.classList.add("ck-light");
      this.labels.append(element);
      this.texts.set(`${label.of} ${index} ${message.n}`, { element, of: label.of, height: label.height });
    });
    this.view.set_dirty();
  }

  placeTexts() {
    const { camera, dom_element: pane } = this.view;
    const zoom = pane.clientHeight / 2 / Math.tan((FIELD * Math.PI) / 360);
    for (const { element, of, height } of this.texts.values()) {
      const place = this.node(of).object.getWorldPosition(this.vector());
      const depth = -place.clone().applyMatrix4(camera.matrixWorldInverse).z;
      place.project(camera);
      const seen = depth > 0.02 && Math.abs(place.x) < 1.2 && Math.abs(place.y) < 1.2;
      element.style.display = seen ? "" : "none";
      if (!seen) continue;
      if (height) element.style.fontSize = `${Math.min(200, (height / depth) * zoom)}px`;
      const x = ((place.x + 1) / 2) * pane.clientWidth, y = ((1 - place.y) / 2) * pane.clientHeight;
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
  }

  // MeshCat's world has y up: (x, y, z) of ROS is (x, z, -y) there.
  look({ distance, yaw, pitch, target: [x, y, z] }) {
    const flat = Math.cos(Math.min(pitch, Math.PI / 2 - 1e-3)), high = Math.sin(pitch);
    const { camera, controls } = this.view;
    controls.target.set(x, z, -y);
    camera.position.set(x + distance * flat * Math.cos(yaw), z + distance * high, -(y + distance * flat * Math.sin(yaw)));
    camera.updateProjectionMatrix();
    controls.update();
    this.view.set_3d_pane_size();
    this.view.set_dirty();
  }

  // The number of the nearest thing under the pointer among those that `may(number)` allows; null where there is none.
  thing(event, may) {
    const { camera, dom_element: pane } = this.view;
    const box = pane.getBoundingClientRect();
    const at = { x: ((event.clientX - box.left) / box.width) * 2 - 1, y: 1 - ((event.clientY - box.top) / box.height) * 2 };
    this.rays.setFromCamera(at, camera);
    const numbers = new Map(Object.entries(this.view.scene_tree.find(["scene"]).children).map(([number, node]) => [node.object, number]));
    for (const { object } of this.rays.intersectObjects([...numbers.keys()], true)) {
      let one = object;
      while (one && !numbers.has(one)) one = one.parent;
      if (one && may(numbers.get(one))) return numbers.get(one);
    }
    return null;
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
    this.view.animate = () => {};
    this.view.renderer.dispose();
    this.view.renderer.forceContextLoss();
  }
}

// The wheel scrolls the page until the picture is clicked: who reads on must not get stuck in it.
function wheelIsThePages(stage) {
  const note = make("div", { className: "ck-wheel", textContent: "Click the picture, then the wheel zooms" });
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
// what is shown beside the scene. Gives the function that ends it.
function drawScene(model, { panel, pane, labels, corner, ready, pictures = () => {} }) {
  const home = make("button", { textContent: "Reset view" }), top = make("button", { textContent: "From above" });
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
    if (message.view) { view = message.view; if (!scene.touched) scene.look(view); }
    panel.dataset.messages = message.n;
    requestAnimationFrame(() => model.send({ type: "drawn", n: message.n }));
  };
  model.on("msg:custom", hear);
  meshcat(model).then((library) => {
    if (closed) return;
    panel.viewer = scene = new Scene(library, pane, labels);
    ready(scene, library);
    home.addEventListener("click", () => { scene.touched = false; if (view) scene.look(view); });
    top.addEventListener("click", () => { scene.touched = true; if (view) scene.look({ ...view, pitch: Math.PI / 2, yaw: -Math.PI / 2 }); });
    for (const [message, buffers] of early.splice(0)) hear(message, buffers);
    model.send({ type: "open" });
  });
  return () => {
    closed = true;
    model.off("msg:custom", hear);
    scene?.close();
  };
}
