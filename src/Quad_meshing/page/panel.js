// The panel: switches of layers, tables and histograms.

function make(name, parent, text)
{
  const node = document.createElement(name);
  if(text !== undefined)
    node.textContent = text;
  if(parent)
    parent.appendChild(node);
  return node;
}

function unitText(unit)
{
  return unit === "" ? "" : " (" + unit + ")";
}

function drawLegend(node, layer)
{
  node.textContent = "";
  const numbers = layer.numbers[layer.coloredBy];
  if(!numbers)
    return;
  const range = rangeOf(numbers);
  if(numbers.scale === "categories")
    return;
  if(numbers.scale === "signed")
  {
    for(const value of Array.from(new Set(numbers.values)).sort((a, b) => a - b))
    {
      const swatch = make("span", node);
      swatch.className = "swatch";
      swatch.style.background = cssColor(signedColor(value));
      node.append(" " + numberText(value) + "  ");
    }
    return;
  }
  node.append(numberText(range.low));
  make("i", node).style.background =
    "linear-gradient(to right," + sequence.map(c => cssColor(c)).join(",") + ")";
  node.append(numberText(range.high) + (numbers.unit === "" ? "" : " " + numbers.unit));
}

// One layer: a switch, the choice of its color, and its opacity if it has faces.
function addSwitch(parent, layer, redraw)
{
  const row = make("div", parent);
  row.className = "layer";
  const label = make("label", row), box = make("input", label);
  box.type = "checkbox";
  box.checked = layer.data.visible;
  box.dataset.layer = layer.data.name;
  const swatch = make("span", label);
  swatch.className = "swatch";
  swatch.style.background = layer.data.color;
  label.append(" " + layer.data.name + " (" + layer.size + ")");
  const details = make("div", row);
  details.hidden = !box.checked;
  box.addEventListener("change", () =>
  {
    layer.group.visible = box.checked;
    details.hidden = !box.checked;
    redraw();
  });
  if(layer.numbers.length > 0)
  {
    const select = make("select", details);
    [{ name: "one color", unit: "" }].concat(layer.numbers).forEach((n, i) =>
    {
      const option = make("option", select, n.name + unitText(n.unit));
      option.value = i - 1;
    });
    select.value = layer.coloredBy;
    const legend = make("div", details);
    legend.className = "legend";
    drawLegend(legend, layer);
    select.addEventListener("change", () =>
    {
      layer.coloredBy = Number(select.value);
      layer.setColors();
      drawLegend(legend, layer);
      redraw();
    });
  }
  if(layer.data.kind === "faces")
  {
    const slider = make("input", details);
    slider.type = "range";
    slider.min = 0.1;
    slider.max = 1;
    slider.step = 0.05;
    slider.value = 1;
    slider.title = "opacity";
    slider.addEventListener("input", () =>
    {
      layer.setOpacity(Number(slider.value));
      redraw();
    });
  }
}

function addTable(parent, title, rows)
{
  if(rows.length === 0)
    return;
  make("h2", parent, title);
  const table = make("table", parent);
  for(const row of rows)
  {
    const tr = make("tr", table);
    row.forEach(text => make("td", tr, text));
  }
}

function addHistogram(parent, histogram)
{
  make("h2", parent, histogram.name + unitText(histogram.unit));
  const ns = "http://www.w3.org/2000/svg", svg = document.createElementNS(ns, "svg");
  svg.setAttribute("class", "histogram");
  svg.setAttribute("viewBox", "0 0 300 90");
  parent.appendChild(svg);
  const n = histogram.counts.length, most = Math.max(1, ...histogram.counts), width = 300 / n;
  const element = (name, attributes, text) =>
  {
    const e = document.createElementNS(ns, name);
    Object.keys(attributes).forEach(key => e.setAttribute(key, attributes[key]));
    e.textContent = text;
    svg.appendChild(e);
    return e;
  };
  const step = (histogram.high - histogram.low) / n;
  histogram.counts.forEach((count, i) =>
  {
    const height = 74 * count / most;
    const bar = element("rect", { x: i * width + 0.5, y: 76 - height, width: Math.max(width - 1, 0.5), height: height }, "");
    const title = document.createElementNS(ns, "title");
    title.textContent = numberText(histogram.low + i * step) + " to " + numberText(histogram.low + (i + 1) * step) +
      ": " + count;
    bar.appendChild(title);
  });
  element("text", { x: 0, y: 87 }, numberText(histogram.low));
  element("text", { x: 300, y: 87, "text-anchor": "end" }, numberText(histogram.high));
}

function fillPanel(scene, layers, redraw)
{
  document.title = scene.title;
  document.getElementById("title").textContent = scene.title;
  document.getElementById("message").textContent = scene.message;
  const switches = document.getElementById("switches"), groups = new Map();
  for(const layer of layers)
  {
    if(!groups.has(layer.data.group))
    {
      const div = make("div", switches);
      make("h2", div, layer.data.group);
      groups.set(layer.data.group, div);
    }
    addSwitch(groups.get(layer.data.group), layer, redraw);
  }
  const tables = document.getElementById("tables");
  scene.histograms.forEach(h => addHistogram(tables, h));
  addTable(tables, "Figures", scene.figures);
  addTable(tables, "Options", scene.options);
  addTable(tables, "About this page", scene.remarks.map(r => [r]));
}
