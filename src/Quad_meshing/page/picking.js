// Picking: which element lies under the pointer, and its numbers.

const pickRadius = 8; // pixels, for points and lines

// The nearest face of visible layers along a ray.
function pickFace(layers, ray)
{
  const caster = new THREE.Raycaster(ray.origin, ray.direction);
  let best = null;
  for(const layer of layers.filter(l => l.data.kind === "faces"))
    for(const hit of caster.intersectObject(layer.object))
      if(best === null || hit.distance < best.distance)
        best = { layer: layer, element: layer.element[3 * hit.faceIndex], distance: hit.distance };
  return best;
}

// The point or line nearest to the pointer on the screen that no face hides.
function pickMark(layers, camera, pointer, width, height, limit)
{
  let best = null, nearest = pickRadius;
  const a = new THREE.Vector3(), b = new THREE.Vector3();
  const screen = (v, p) =>
  {
    v.copy(p).project(camera);
    v.set((v.x + 1) * width / 2, (1 - v.y) * height / 2, v.z);
  };
  for(const layer of layers.filter(l => l.data.kind !== "faces"))
  {
    const step = layer.data.kind === "lines" ? 2 : 1;
    for(let i = 0; i + step <= layer.element.length; i += step)
    {
      const positions = layer.object.geometry.attributes.position;
      const p = new THREE.Vector3().fromBufferAttribute(positions, i);
      const q = step === 2 ? new THREE.Vector3().fromBufferAttribute(positions, i + 1) : p;
      screen(a, p);
      screen(b, q);
      const dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
      const t = squared > 0 ? Math.min(Math.max(((pointer.x - a.x) * dx + (pointer.y - a.y) * dy) / squared, 0), 1) : 0;
      const d = Math.hypot(a.x + t * dx - pointer.x, a.y + t * dy - pointer.y);
      const depth = camera.position.distanceTo(p.clone().lerp(q, t));
      // points win against lines that pass through them
      const counted = step === 2 ? d + 2 : d;
      if(counted < nearest && depth < limit && Math.abs(a.z) < 1)
      {
        nearest = counted;
        best = { layer: layer, element: layer.element[i], distance: depth };
      }
    }
  }
  return best;
}

function showPicked(picked, scene)
{
  const node = document.getElementById("picked");
  node.textContent = "";
  if(picked === null)
  {
    node.textContent = "Click an element to read its numbers.";
    return;
  }
  const layer = picked.layer, corners = layer.cornersOf(picked.element);
  const rows = [["layer", layer.data.name], ["number", String(picked.element)]];
  for(const n of layer.numbers)
    rows.push([n.name, numberText(n.values[picked.element]) + (n.unit === "" ? "" : " " + n.unit)]);
  corners.slice(0, 4).forEach(c =>
    rows.push(["point", layer.point(c).toArray().map((x, k) => numberText(x * scene.radius + scene.center[k])).join(", ")]));
  const table = make("table", node);
  for(const row of rows)
  {
    const tr = make("tr", table);
    row.forEach(text => make("td", tr, text));
  }
}

// What is drawn around the picked element.
function outline(picked)
{
  const layer = picked.layer, corners = layer.cornersOf(picked.element), positions = [];
  corners.forEach((c, i) =>
  {
    if(layer.data.kind === "lines" && i + 1 === corners.length)
      return;
    positions.push(...layer.point(c).toArray(), ...layer.point(corners[(i + 1) % corners.length]).toArray());
  });
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", attribute(new Float32Array(positions), 3));
  const colors = new Float32Array(positions.length);
  for(let i = 0; i < colors.length; i += 3)
    colors.set([1, 0.1, 0.9], i);
  geometry.setAttribute("color", attribute(colors, 3));
  const isPoint = layer.data.kind === "points";
  const object = isPoint ? new THREE.Points(geometry, markMaterial(13)) : new THREE.LineSegments(geometry, markMaterial(1));
  object.layers.mask = layer.object.layers.mask;
  return object;
}
