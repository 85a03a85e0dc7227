#!/usr/bin/env python3
"""Opens pages of --html in headless Chromium: they load without errors, every switch shows something and nothing else, two
pictures stand side by side, elements can be picked, and a screenshot is not empty.

usage: check_html_page.py FOLDER [MESH...]

FOLDER holds the programs. Pages are made of meshes that are generated here, and of the given ones. The exit code is 77
where there is no Chromium, or the programs were built without three.js.
"""

import base64
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import zlib

SKIPPED = 77
LARGEST_PAGE = 20e6  # bytes, for 100000 triangles and 4000 quads

ERRORS = """<script>window.pageErrors = [];
window.addEventListener("error", e => pageErrors.push(e.message));
console.error = text => pageErrors.push(String(text));</script>"""

# Drives the page and leaves what it finds in an element.
DRIVER = """<script>
function drive()
{
  const page = window.quadMeshingPage, canvas = document.getElementById("canvas"), found = { layers: [] };
  const gl = canvas.getContext("webgl");
  const picture = () =>
  {
    page.render();
    const w = gl.drawingBufferWidth, h = gl.drawingBufferHeight, p = new Uint8Array(4 * w * h);
    gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, p);
    const drawn = [0, 0];
    let sum = 0;
    for(let i = 0; i < p.length; i += 4)
      if(p[i] + p[i + 1] + p[i + 2] < 3 * 250)
      {
        ++drawn[(i / 4) % w < w / 2 ? 0 : 1];
        sum = (sum * 31 + p[i] + 256 * p[i + 1] + 65536 * p[i + 2]) % 4294967291;
      }
    return { left: drawn[0], right: drawn[1], all: drawn[0] + drawn[1], sum: sum };
  };
  const side = document.getElementById("side-by-side");
  if(side.checked)
    side.click();
  found.start = picture();
  const boxes = Array.from(document.querySelectorAll("#switches input[type=checkbox]"));
  boxes.forEach(b => { if(b.checked) b.click(); });
  found.nothing = picture();
  boxes.forEach((box, i) =>
  {
    const layer = page.layers[i], entry = { name: layer.data.name, side: layer.data.side, size: layer.size,
      kind: layer.data.kind };
    box.click();
    entry.alone = picture();
    const select = box.closest(".layer").querySelector("select");
    if(select)
    {
      entry.colorings = [];
      for(const option of select.options)
      {
        select.value = option.value;
        select.dispatchEvent(new Event("change"));
        entry.colorings.push(picture().sum);
      }
    }
    // the middle of the model, or the first place along a row and a column that something is picked at
    entry.picked = null;
    const w = canvas.clientWidth, h = canvas.clientHeight;
    for(let k = 0; k < 400 && entry.picked === null; ++k)
      entry.picked = page.pick(w / 2 + (k % 20 - 10) * w / 60, h / 2 + (Math.floor(k / 20) - 10) * h / 60);
    entry.text = document.getElementById("picked").textContent;
    if(entry.picked === null)
      page.pick(0, 0);
    side.click();
    page.pick(0, 0); // away with the mark
    entry.beside = picture();
    side.click();
    box.click();
    found.layers.push(entry);
  });
  found.bars = document.querySelectorAll("svg rect").length;
  found.rows = document.querySelectorAll("#tables tr").length;
  found.title = document.title;
  found.message = document.getElementById("message").textContent;
  return found;
}
let found = {};
try { found = drive(); } catch(error) { pageErrors.push(String(error.stack)); }
found.errors = pageErrors;
const node = document.createElement("pre");
node.id = "found";
node.textContent = btoa(JSON.stringify(found));
document.body.appendChild(node);
</script></body>"""

failures = []


def check(condition, what):
    if not condition:
        failures.append(what)
        print("FAILED: " + what)


def box_mesh(sizes, triangles):
    """The sides of a box of unit cubes, as quads or cut in two."""
    number, points, faces = {}, [], []

    def vertex(p):
        if p not in number:
            number[p] = len(points)
            points.append(p)
        return number[p]

    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end in (0, sizes[axis]):
            for i in range(sizes[u]):
                for j in range(sizes[v]):
                    corners = []
                    for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        p = [0, 0, 0]
                        p[axis], p[u], p[v] = end, a, b
                        corners.append(vertex(tuple(p)))
                    if end == 0:
                        corners.reverse()
                    faces.extend([[corners[0], corners[1], corners[2]], [corners[0], corners[2], corners[3]]]
                                 if triangles else [corners])
    return points, faces


def write_off(name, points, faces):
    with open(name, "w", encoding="ascii") as file:
        file.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
        for p in points:
            file.write("%r %r %r\n" % tuple(p))
        for f in faces:
            file.write(" ".join(map(str, [len(f)] + f)) + "\n")


def run(program, *arguments):
    """Runs a program; whether its result is valid does not matter here."""
    command = [program] + list(arguments)
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=250,
                          check=False)
    print("%s: exit code %d %s" % (" ".join(map(os.path.basename, command)), done.returncode, done.stderr.strip()))
    if "without three.js" in done.stderr:
        print("skipped: the programs were built without three.js")
        sys.exit(SKIPPED)
    check(done.returncode in (0, 1), "exit code %d of %s" % (done.returncode, os.path.basename(program)))


def chromium(binary, *arguments):
    profile = os.path.abspath("chromium_profile")
    command = [binary, "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--no-first-run", "--disable-extensions",
               "--user-data-dir=" + profile, "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
               "--window-size=1000,600", "--virtual-time-budget=2000"] + list(arguments)
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=250, check=False).stdout


def png_rows(data):
    """The rows of a PNG of eight bits per channel, as bytes, and the number of channels."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, packed, width, height, channels = 8, b"", 0, 0, 0
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert depth == 8
            channels = {2: 3, 6: 4}[color]
        elif kind == b"IDAT":
            packed += body
        place += 12 + length
    raw, rows, size = zlib.decompress(packed), [], width * channels
    last = bytearray(size)
    for y in range(height):
        method, row = raw[y * (size + 1)], bytearray(raw[y * (size + 1) + 1:(y + 1) * (size + 1)])
        for i in range(size):
            left = row[i - channels] if i >= channels else 0
            up, corner = last[i], last[i - channels] if i >= channels else 0
            if method == 1:
                row[i] = (row[i] + left) & 255
            elif method == 2:
                row[i] = (row[i] + up) & 255
            elif method == 3:
                row[i] = (row[i] + (left + up) // 2) & 255
            elif method == 4:
                guess = left + up - corner
                nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))
                row[i] = (row[i] + nearest[2]) & 255
        rows.append(bytes(row))
        last = row
    return rows, channels


def drawn_share(png):
    """The share of pixels right of the panel that are not white."""
    with open(png, "rb") as file:
        rows, channels = png_rows(file.read())
    width = len(rows[0]) // channels
    begin = width * 35 // 100
    dark = sum(1 for row in rows for x in range(begin, width) if min(row[channels * x:channels * x + 3]) < 240)
    return dark / (len(rows) * (width - begin))


def check_page(binary, page, layers):
    with open(page, encoding="utf-8") as file:
        text = file.read()
    check(len(text) < LARGEST_PAGE, "%s has %d bytes" % (page, len(text)))
    check(re.search(r"<(script|link|img|iframe)[^>]*\b(src|href)\s*=", text.split('id="scene"')[0]) is None,
          page + " loads other files")
    driven = "driven_" + page
    with open(driven, "w", encoding="utf-8") as file:
        # the first head and the last body are those of the page itself
        begin, end = text.index("<head>") + len("<head>"), text.rindex("</body>")
        file.write(text[:begin] + ERRORS + text[begin:end] + DRIVER + text[end + len("</body>"):])
    dom = chromium(binary, "--dump-dom", "file://" + os.path.abspath(driven)).decode("utf-8", "replace")
    match = re.search(r'<pre id="found">([A-Za-z0-9+/=]*)</pre>', dom)
    check(match is not None, page + " was not driven")
    if match is None:
        return
    found = json.loads(base64.b64decode(match.group(1)).decode("latin-1"))
    check(found["errors"] == [], "%s has errors: %s" % (page, found["errors"]))
    if "rows" not in found:
        return
    names = [layer["name"] for layer in found["layers"]]
    print("%s: %d bytes, layers %s" % (page, len(text), ", ".join(names)))
    for name in layers:
        check(name in names, "%s has no layer %s" % (page, name))
    check(found["start"]["all"] > 1000, page + " shows nothing at the beginning")
    check(found["nothing"]["all"] == 0, page + " shows something with all switches off")
    for layer in found["layers"]:
        what = "%s, layer %s" % (page, layer["name"])
        check(layer["size"] > 0, what + " is empty")
        check(layer["alone"]["all"] > 0, what + " is not drawn")
        check(layer["picked"] is not None and layer["picked"]["layer"] == layer["name"], what + " cannot be picked")
        check("number" in layer["text"], what + ": no numbers of what was picked")
        beside = layer["beside"]
        check((beside["left"] > 0) == (layer["side"] != 2), what + " is not where it belongs at the left")
        check((beside["right"] > 0) == (layer["side"] != 1), what + " is not where it belongs at the right")
        if layer["kind"] == "faces" and layer["name"] == "quads":
            check("scaled Jacobian" in layer["text"], what + ": no scaled Jacobian of what was picked")
            check(len(set(layer["colorings"])) > 2, what + ": its colors do not change")
    check(found["rows"] > 5, page + " has no tables")
    picture = page.replace(".html", ".png")
    chromium(binary, "--screenshot=" + os.path.abspath(picture), "file://" + os.path.abspath(page))
    check(os.path.exists(picture) and drawn_share(picture) > 0.02, page + ": the screenshot is empty")


def main():
    folder, meshes = sys.argv[1], sys.argv[2:]
    binary = next((path for path in map(shutil.which, ("chromium", "chromium-browser", "google-chrome")) if path), None)
    if binary is None:
        print("skipped: there is no Chromium to open pages with")
        return SKIPPED

    def program(name):
        return os.path.join(folder, name)

    write_off("cube.off", *box_mesh((3, 3, 3), True))
    points, faces = box_mesh((1, 1, 1), False)
    write_off("coarse.off", [[3 * x for x in p] for p in points], faces)  # a layout: the sides of the cube
    # One face is a triangle; the name must not confuse the reader of the page.
    write_off("quads.off", *box_mesh((4, 3, 2), False))
    points, faces = box_mesh((2, 2, 2), False)
    write_off("mixed <!--<script>.off", points, faces[1:] + [faces[0][:3]])

    maps = ["triangles", "integer grid", "cross field", "singularities", "quads", "irregular vertices", "base complex"]
    run(program("quadrangulate"), "cube.off", "result.obj", "--target-quads", "150", "--html", "cube.html")
    check_page(binary, "cube.html", maps + ["sharp edges, kept", "feature edges"])
    for i, mesh in enumerate(meshes):
        page = "mesh_%d.html" % i
        run(program("quadrangulate"), mesh, "result.obj", "--target-quads", "1000", "--html", page)
        check_page(binary, page, ["triangles", "quads"])
    run(program("quad_mesh_statistics"), "quads.off", "--html", "quads.html")
    check_page(binary, "quads.html", ["quads", "irregular vertices"])
    run(program("quad_mesh_statistics"), "mixed <!--<script>.off", "--html", "mixed.html")
    check_page(binary, "mixed.html", ["faces"])
    run(program("quadrangulate_layout"), "cube.off", "coarse.off", "layout.obj", "--quads", "600", "--html", "layout.html")
    check_page(binary, "layout.html", ["triangles", "features", "arcs as they are given", "quads"])
    run(program("optimize_quad_structure"), "quads.off", "optimized.obj", "--html", "structure.html")
    check_page(binary, "structure.html", ["quads", "base complex"])
    run(program("geodesic_distance"), "cube.off", "distances.txt", "--vertices", "0", "--html", "distances.html")
    check_page(binary, "distances.html", ["triangles", "isolines"])

    print("%d failures" % len(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
