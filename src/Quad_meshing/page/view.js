// The view: camera, drawing on demand, one picture or two side by side. Coordinates are those of the model less its
// center, over its radius.

const scene = JSON.parse(document.getElementById("scene").textContent);
const canvas = document.getElementById("canvas"), sideBySide = document.getElementById("side-by-side");
let renderer = null, layers = [], marked = null, isAsked = false;
const root = new THREE.Scene(), camera = new THREE.PerspectiveCamera(35, 1, 0.01, 100);

// Bits of THREE.Layers: 0 is for both sides, 1 for the left one, 2 for the right one.
function lookAt(sides)
{
  camera.layers.mask = sides.reduce((mask, side) => mask | (1 << side), 1);
}

// Fits the camera to a picture; the smaller side of it sees the angle.
const angle = 35 * Math.PI / 180;
function fit(width, height)
{
  camera.aspect = width / height;
  camera.fov = 2 * Math.atan(Math.tan(angle / 2) / Math.min(camera.aspect, 1)) * 180 / Math.PI;
  camera.updateProjectionMatrix();
}

function render()
{
  isAsked = false;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  if(renderer === null || width === 0 || height === 0)
    return;
  renderer.setSize(width, height, false);
  renderer.setScissorTest(true);
  const pictures = sideBySide.checked ? [[1], [2]] : [[1, 2]];
  pictures.forEach((sides, i) =>
  {
    const w = width / pictures.length;
    fit(w, height);
    lookAt(sides);
    renderer.setViewport(i * w, 0, w, height);
    renderer.setScissor(i * w, 0, w, height);
    renderer.render(root, camera);
  });
}

function redraw()
{
  if(!isAsked)
    window.requestAnimationFrame(render);
  isAsked = true;
}

function resetView(controls)
{
  const distance = 1.1 / Math.sin(angle / 2);
  camera.position.set(0.55, 0.45, 0.75).normalize().multiplyScalar(distance);
  camera.up.set(0, 1, 0);
  controls.target.set(0, 0, 0);
  controls.update();
  redraw();
}

// Picks at a place of the canvas, in pixels from its upper left corner.
function pick(x, y)
{
  const parts = sideBySide.checked ? 2 : 1, width = canvas.clientWidth / parts, height = canvas.clientHeight;
  const side = Math.min(Math.floor(x / width), parts - 1), pointer = { x: x - side * width, y: y };
  fit(width, height);
  camera.updateMatrixWorld();
  lookAt(parts === 2 ? [side + 1] : [1, 2]);
  const shown = layers.filter(l => l.group.visible && l.object.layers.test(camera.layers));
  const direction = new THREE.Vector3(2 * pointer.x / width - 1, 1 - 2 * pointer.y / height, 0.5);
  direction.unproject(camera).sub(camera.position).normalize();
  const face = pickFace(shown, new THREE.Ray(camera.position, direction));
  const limit = face === null ? Infinity : face.distance + 0.02;
  const picked = pickMark(shown, camera, pointer, width, height, limit) || face;
  if(marked !== null)
    root.remove(marked);
  marked = picked === null ? null : outline(picked);
  if(marked !== null)
    root.add(marked);
  showPicked(picked, scene);
  redraw();
  return picked === null ? null : { layer: picked.layer.data.name, element: picked.element };
}

try
{
  renderer = new THREE.WebGLRenderer({ canvas: canvas, antialias: true, preserveDrawingBuffer: true });
  renderer.setPixelRatio(window.devicePixelRatio || 1);
  renderer.setClearColor(0xffffff);
}
catch(error)
{
  document.getElementById("hint").textContent = "This browser offers no WebGL: there are the figures, but no pictures.";
}
layers = scene.layers.map(data => new Layer(data));
layers.forEach(layer => root.add(layer.group));
sideBySide.checked = scene.side_by_side;
fillPanel(scene, layers, redraw);

const controls = new THREE.OrbitControls(camera, canvas);
controls.addEventListener("change", redraw);
controls.screenSpacePanning = true;
resetView(controls);
document.getElementById("reset-view").addEventListener("click", () => resetView(controls));
sideBySide.addEventListener("change", redraw);
window.addEventListener("resize", redraw);

// A click is a press and a release at one place.
let pressed = null;
canvas.addEventListener("pointerdown", e => { pressed = [e.offsetX, e.offsetY]; });
canvas.addEventListener("pointerup", e =>
{
  if(pressed !== null && Math.hypot(e.offsetX - pressed[0], e.offsetY - pressed[1]) < 4)
    pick(e.offsetX, e.offsetY);
  pressed = null;
});

// For programs that drive the page: draw at once, pick at a place of the canvas, look at the layers.
window.quadMeshingPage = { render: render, pick: pick, layers: layers, scene: scene };
