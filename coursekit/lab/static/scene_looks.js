// How a scene looks: the theme's colours, dots that never vanish, names that do not cover each other, soft shadows.
const SKIES = { light: [[245, 247, 250], [221, 226, 232]], dark: [[52, 60, 68], [30, 35, 41]] };
const LEAST_DOT = 2; // pixels
const MOST_NAMES = 300; // of more it is not asked which cover each other

const isDark = () => document.body.dataset.jpThemeLight === "false";

// The sky follows the theme of the page. Gives what ends it.
function followTheme(view) {
  const paint = () => {
    const [top, bottom] = SKIES[isDark() ? "dark" : "light"];
    Object.assign(view.scene_tree.find(["Background"]).object, { top_color: top, bottom_color: bottom });
    view.show_background();
  };
  const watcher = new MutationObserver(paint);
  watcher.observe(document.body, { attributes: true, attributeFilter: ["data-jp-theme-light"] });
  paint();
  return () => watcher.disconnect();
}

// Dots that are far away stay as large as can be seen; once for all scenes of a page.
function dotsStaySeen({ PointsMaterial }) {
  PointsMaterial.prototype.onBeforeCompile = (shader) => {
    const place = "#include <logdepthbuf_vertex>";
    shader.vertexShader = shader.vertexShader.replace(place, `gl_PointSize = max(gl_PointSize, ${LEAST_DOT.toFixed(1)});\n${place}`);
  };
}

// Of small names that would cover each other the nearest stays; one that is seen stays rather than a new one. Large ones all stay.
function thinOut(names, large) {
  if (names.length > MOST_NAMES) return;
  names.sort((one, other) => other.text.kept - one.text.kept || one.depth - other.depth);
  const kept = [...large];
  for (const { text, x, y } of names) {
    const box = { left: x, top: y, right: x + text.width, bottom: y + text.rows };
    text.kept = !kept.some((other) => box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom);
    if (text.kept) kept.push(box);
    else text.element.style.display = "none";
  }
}

// About where a large text is, its letters being so high.
const boxOfLarge = (x, y, letters, height) =>
  ({ left: x - 0.32 * height * letters - 6, right: x + 0.32 * height * letters - 6, top: y - 0.7 * height + 19, bottom: y + 0.7 * height + 19 });

// Which way the axes of the fixed frame point: small arrows in a corner, that turn with the camera.
const AXES = { x: [1, 0, 0], y: [0, 0, -1], z: [0, 1, 0] }; // MeshCat's world has y up
const ARROW = 15; // pixels

class Compass {
  constructor(scene) {
    const axis = (name) => `<g class="ck-${name}"><line/><text>${name}</text></g>`;
    this.element = make("div", { className: "ck-compass", ariaHidden: "true",
      innerHTML: `<svg viewBox="-26 -26 52 52">${Object.keys(AXES).map(axis).join("")}</svg>` });
    this.scene = scene;
    scene.after.push(() => this.draw());
  }

  draw() {
    const away = this.scene.view.camera.getWorldQuaternion(this.turned ??= this.scene.view.camera.quaternion.clone()).invert();
    if (this.drawn?.equals(away)) return; // most pictures are of a camera that stands still
    this.drawn = away.clone();
    for (const [name, axis] of Object.entries(AXES)) {
      const { x, y } = this.scene.vector().set(...axis).applyQuaternion(away);
      const [line, letter] = this.element.querySelector(`.ck-${name}`).children;
      line.setAttribute("x2", (ARROW * x).toFixed(1)); line.setAttribute("y2", (-ARROW * y).toFixed(1));
      letter.setAttribute("x", (1.45 * ARROW * x).toFixed(1)); letter.setAttribute("y", (-1.45 * ARROW * y).toFixed(1));
    }
  }
}

// A soft spot on the floor under each robot, as wide as the robot.
class Shadows {
  constructor(three, view) {
    Object.assign(this, { three, view, robots: new Map() });
  }

  // The spot is drawn once, dark in the middle.
  material() {
    if (this.dark) return this.dark;
    const canvas = Object.assign(document.createElement("canvas"), { width: 128, height: 128 }), pen = canvas.getContext("2d");
    const fade = pen.createRadialGradient(64, 64, 8, 64, 64, 64);
    for (const [at, much] of [[0, 0.42], [0.55, 0.3], [0.8, 0.1], [1, 0]]) fade.addColorStop(at, `rgba(10, 16, 22, ${much})`);
    pen.fillStyle = fade;
    pen.fillRect(0, 0, 128, 128);
    this.dark = new this.three.MeshBasicMaterial({ map: new this.three.CanvasTexture(canvas), transparent: true, depthWrite: false });
    return this.dark;
  }

  clear() {
    for (const { spot } of this.robots.values()) this.view.scene.remove(spot);
    this.robots.clear();
  }

  // These numbers are new parts of robots.
  add(solid) {
    for (const [number, robot] of solid) {
      if (!this.robots.has(robot)) {
        const spot = new this.three.Mesh(new this.three.PlaneGeometry(1, 1), this.material());
        spot.renderOrder = 1;
        this.view.scene.add(spot);
        this.robots.set(robot, { spot, parts: new Map() });
      }
      this.robots.get(robot).parts.set(String(number), null);
    }
  }

  gone(number) {
    for (const [robot, { spot, parts }] of this.robots) {
      if (parts.delete(String(number)) && !parts.size) { this.view.scene.remove(spot); this.robots.delete(robot); }
    }
  }

  // The box around a part, in its own frame.
  boxOf(object) {
    const box = new this.three.Box3();
    object.traverse((one) => {
      if (!one.isMesh) return;
      one.geometry.computeBoundingBox();
      box.union(one.geometry.boundingBox);
    });
    return box;
  }

  place(node) {
    for (const { spot, parts } of this.robots.values()) {
      const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
      let turn = null, cos = 1, sin = 0;
      for (const [number, known] of parts) {
        const object = node(number).object;
        object.updateWorldMatrix(true, false);
        const box = known ?? this.boxOf(object);
        if (!known && !box.isEmpty()) parts.set(number, box);
        if (turn === null) {
          const [x, , z] = object.matrixWorld.elements;
          turn = Math.hypot(x, z) > 1e-6 ? Math.atan2(-z, x) : 0;
          [cos, sin] = [Math.cos(turn), Math.sin(turn)];
        }
        if (box.isEmpty()) continue;
        for (let corner = 0; corner < 8; corner++) {
          const at = new this.three.Vector3(...["x", "y", "z"].map((axis, bit) => (corner >> bit & 1 ? box.max : box.min)[axis])).applyMatrix4(object.matrixWorld);
          [at.x * cos - at.z * sin, at.x * sin + at.z * cos, at.y].forEach((value, axis) => {
            least[axis] = Math.min(least[axis], value);
            most[axis] = Math.max(most[axis], value);
          });
        }
      }
      spot.visible = Number.isFinite(least[0]);
      if (!spot.visible) continue;
      const [u, v] = [0, 1].map((axis) => (least[axis] + most[axis]) / 2);
      const margin = 0.25 * Math.min(most[0] - least[0], most[1] - least[1]) + 0.04;
      spot.scale.set(1.25 * (most[0] - least[0]) + margin, 1.25 * (most[1] - least[1]) + margin, 1);
      spot.position.set(u * cos + v * sin, u * sin - v * cos, Math.min(least[2], 0) + 0.003); // MeshCat turns its scene: z is up
      spot.rotation.z = turn;
    }
  }
}
