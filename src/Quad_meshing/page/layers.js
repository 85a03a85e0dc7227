// Layers: from the arrays of the scene to what three.js draws.

function decode(base64, type)
{
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for(let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  return new type(bytes.buffer);
}

// Light comes from the eye; back sides are darker.
const faceVertexShader = `
attribute vec3 color;
attribute vec2 grid;
varying vec3 v_color, v_normal, v_position;
varying vec2 v_grid;
void main()
{
  v_color = color;
  v_grid = grid;
  v_normal = normalMatrix * normal;
  vec4 p = modelViewMatrix * vec4(position, 1.0);
  v_position = p.xyz;
  gl_Position = projectionMatrix * p;
}`;
const faceFragmentShader = `
uniform float opacity;
uniform bool has_grid;
varying vec3 v_color, v_normal, v_position;
varying vec2 v_grid;
void main()
{
  vec3 color = v_color;
  if(has_grid)
  {
    // Lines of the integer grid, about a pixel wide, which fade where the cells are smaller than that.
    vec2 pixel = max(fwidth(v_grid), vec2(1e-6));
    vec2 away = abs(fract(v_grid + 0.5) - 0.5) / pixel;
    float line = 1.0 - smoothstep(0.2, 1.2, min(away.x, away.y));
    vec2 cell = mod(floor(v_grid), 2.0);
    color *= abs(cell.x - cell.y) > 0.5 ? 0.86 : 1.0;
    color = mix(color, vec3(0.05, 0.15, 0.35), line * clamp(0.5 / max(pixel.x, pixel.y), 0.0, 1.0));
  }
  float light = abs(dot(normalize(v_normal), normalize(v_position)));
  gl_FragColor = vec4(color * (0.35 + 0.65 * light) * (gl_FrontFacing ? 1.0 : 0.7), opacity);
}`;
// Lines and points are drawn a little nearer to the eye than the faces that they lie in.
const markVertexShader = `
attribute vec3 color;
uniform float size;
varying vec3 v_color;
void main()
{
  v_color = color;
  vec4 p = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * vec4(0.997 * p.xyz, 1.0);
  gl_PointSize = size;
}`;
const markFragmentShader = `
uniform bool is_round;
varying vec3 v_color;
void main()
{
  vec2 d = gl_PointCoord - 0.5;
  if(is_round && dot(d, d) > 0.25)
    discard;
  gl_FragColor = vec4(v_color, 1.0);
}`;

function markMaterial(pointSize)
{
  return new THREE.ShaderMaterial({ vertexShader: markVertexShader, fragmentShader: markFragmentShader,
    uniforms: { size: { value: pointSize * (window.devicePixelRatio || 1) }, is_round: { value: pointSize > 1 } } });
}

function attribute(array, size)
{
  return new THREE.BufferAttribute(array, size);
}

class Layer
{
  constructor(data)
  {
    this.data = data;
    this.points = decode(data.points, Float32Array);
    this.corners = decode(data.corners, Uint32Array);
    this.first = decode(data.first, Uint32Array);
    this.grid = data.grid === "" ? null : decode(data.grid, Float32Array);
    this.numbers = data.numbers.map(n => Object.assign({}, n, { values: decode(n.values, Float32Array) }));
    this.coloredBy = data.colored_by;
    this.group = new THREE.Group();
    this.object = this["make_" + data.kind]();
    this.group.add(this.object);
    for(const object of [this.group].concat(this.group.children))
      object.layers.set(data.side);
    this.setColors();
    this.group.visible = data.visible;
  }

  get size() { return this.first.length - 1; }
  point(i) { return new THREE.Vector3().fromArray(this.points, 3 * i); }
  cornersOf(element) { return Array.from(this.corners.subarray(this.first[element], this.first[element + 1])); }

  // Sets the corners of the drawn primitives: number of the corner, and the element it belongs to.
  makeGeometry(corner, element)
  {
    this.element = element;
    const positions = new Float32Array(3 * corner.length);
    corner.forEach((c, i) => positions.set(this.points.subarray(3 * this.corners[c], 3 * this.corners[c] + 3), 3 * i));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", attribute(positions, 3));
    geometry.setAttribute("color", attribute(new Float32Array(3 * corner.length), 3));
    return geometry;
  }

  make_faces()
  {
    const corner = [], element = [];
    for(let e = 0; e < this.size; ++e)
      for(let c = this.first[e] + 1; c + 1 < this.first[e + 1]; ++c)
      {
        corner.push(this.first[e], c, c + 1);
        element.push(e, e, e);
      }
    const geometry = this.makeGeometry(corner, element);
    const normals = new Float32Array(3 * corner.length);
    let last = -1, normal = null;
    element.forEach((e, i) =>
    {
      if(e !== last)
        normal = this.normalOf(e);
      last = e;
      normals.set(normal, 3 * i);
    });
    geometry.setAttribute("normal", attribute(normals, 3));
    const grid = new Float32Array(2 * corner.length);
    if(this.grid !== null)
      corner.forEach((c, i) => grid.set(this.grid.subarray(2 * c, 2 * c + 2), 2 * i));
    geometry.setAttribute("grid", attribute(grid, 2));
    const material = new THREE.ShaderMaterial({ vertexShader: faceVertexShader, fragmentShader: faceFragmentShader,
      uniforms: { opacity: { value: 1 }, has_grid: { value: this.grid !== null } },
      extensions: { derivatives: true }, side: THREE.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    if(this.data.edges)
      this.group.add(this.makeSides());
    return new THREE.Mesh(geometry, material);
  }

  // Newell's normal of a polygon; that of a quad is along the cross product of its diagonals.
  normalOf(e)
  {
    const n = new THREE.Vector3(), corners = this.cornersOf(e), cross = new THREE.Vector3();
    corners.forEach((c, i) => n.add(cross.crossVectors(this.point(c), this.point(corners[(i + 1) % corners.length]))));
    return n.normalize().toArray();
  }

  makeSides()
  {
    const sides = new Set(), ends = [], n = this.points.length / 3;
    for(let e = 0; e < this.size; ++e)
      this.cornersOf(e).forEach((a, i, corners) =>
      {
        const b = corners[(i + 1) % corners.length], key = Math.min(a, b) * n + Math.max(a, b);
        if(!sides.has(key))
        {
          sides.add(key);
          ends.push(a, b);
        }
      });
    const positions = new Float32Array(3 * ends.length);
    ends.forEach((p, i) => positions.set(this.points.subarray(3 * p, 3 * p + 3), 3 * i));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", attribute(positions, 3));
    geometry.setAttribute("color", attribute(new Float32Array(3 * ends.length).fill(0.15), 3));
    return new THREE.LineSegments(geometry, markMaterial(1));
  }

  make_lines()
  {
    const corner = [], element = [];
    for(let e = 0; e < this.size; ++e)
      for(let c = this.first[e]; c + 1 < this.first[e + 1]; ++c)
      {
        corner.push(c, c + 1);
        element.push(e, e);
      }
    return new THREE.LineSegments(this.makeGeometry(corner, element), markMaterial(1));
  }

  make_points()
  {
    const corner = [], element = [];
    for(let e = 0; e < this.size; ++e)
    {
      corner.push(this.first[e]);
      element.push(e);
    }
    return new THREE.Points(this.makeGeometry(corner, element), markMaterial(9));
  }

  // Colors the elements by one of their numbers, or all alike if coloredBy is -1.
  setColors()
  {
    const plain = new THREE.Color(this.data.color).toArray(), colors = this.object.geometry.attributes.color;
    const numbers = this.numbers[this.coloredBy], range = numbers ? rangeOf(numbers) : null;
    let last = -1, color = plain;
    this.element.forEach((e, i) =>
    {
      if(numbers && e !== last)
        color = colorOfNumber(numbers.values[e], numbers, range);
      last = e;
      colors.array.set(color, 3 * i);
    });
    colors.needsUpdate = true;
  }

  setOpacity(opacity)
  {
    this.object.material.uniforms.opacity.value = opacity;
    this.object.material.transparent = opacity < 1;
    this.object.material.depthWrite = opacity === 1;
    this.object.material.needsUpdate = true;
  }
}
