// Lines of a width: WebGL draws hairlines only, so each piece becomes a strip that faces the camera. A line is so many metres wide,
// yet never thinner on the screen than can be seen: a path stays a line, however far one looks from.
const LINE_CORNERS = `
attribute vec3 start, end, startColour, endColour;
uniform vec2 pane;
uniform float metres, least;
varying vec3 shade;
void main() {
  vec4 a = modelViewMatrix * vec4(start, 1.0), b = modelViewMatrix * vec4(end, 1.0);
  const float near = -0.02; // what is behind the eye is cut off
  if (a.z > near && b.z < near) a = mix(a, b, (near - a.z) / (b.z - a.z));
  else if (b.z > near && a.z < near) b = mix(b, a, (near - b.z) / (a.z - b.z));
  vec4 p = projectionMatrix * a, q = projectionMatrix * b;
  vec2 way = (q.xy / q.w - p.xy / p.w) * pane;
  way = length(way) > 0.0001 ? normalize(way) : vec2(1.0, 0.0);
  vec4 here = position.x < 0.5 ? p : q;
  float wide = max(least, metres * projectionMatrix[1][1] * pane.y * 0.5 / here.w);
  vec2 shift = (vec2(-way.y, way.x) * position.y + way * (position.x * 2.0 - 1.0)) * wide * 0.5;
  here.xy += shift * 2.0 / pane * here.w;
  gl_Position = here;
  shade = position.x < 0.5 ? startColour : endColour;
}`;
const LINE_PAINT = `
uniform vec3 colour;
uniform float opacity;
varying vec3 shade;
void main() { gl_FragColor = vec4(colour * shade, opacity); }`;

// The pieces as strips, in place of the hairlines, which stay for the pointer to find. `pane` is the picture's size in pixels.
function widen(three, object, pane) {
  const { metres = 0, least = 1 } = object.userData, { position, color } = object.geometry.attributes;
  const geometry = new three.InstancedBufferGeometry();
  geometry.setAttribute("position", new three.Float32BufferAttribute([0, -1, 0, 0, 1, 0, 1, -1, 0, 1, 1, 0], 3));
  geometry.setIndex([0, 2, 1, 1, 2, 3]);
  const pairs = (names, array) => {
    const both = new three.InstancedInterleavedBuffer(array, 6, 1);
    names.forEach((name, index) => geometry.setAttribute(name, new three.InterleavedBufferAttribute(both, 3, 3 * index)));
  };
  pairs(["start", "end"], position.array);
  pairs(["startColour", "endColour"], color ? color.array : new Float32Array(position.array.length).fill(1));
  geometry.instanceCount = position.count / 2;
  object.geometry.computeBoundingBox();
  geometry.boundingBox = object.geometry.boundingBox;
  const { material } = object;
  const uniforms = { pane: { value: pane }, metres: { value: metres }, least: { value: least },
    colour: { value: material.color }, opacity: { value: material.opacity } };
  const paint = new three.ShaderMaterial({ uniforms, vertexShader: LINE_CORNERS, fragmentShader: LINE_PAINT,
    transparent: material.transparent, side: three.DoubleSide });
  const strips = new three.Mesh(geometry, paint);
  Object.assign(strips, { frustumCulled: false, raycast: () => {} });
  material.visible = false;
  object.add(strips);
  object.geometry.addEventListener("dispose", () => { geometry.dispose(); paint.dispose(); });
}
