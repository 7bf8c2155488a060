// Table, plots and controls. `data` is { results: results.json, images: {source: {what: {frame: URI}}} }.
"use strict";

const metrics = [
  { key: "psnr", name: "PSNR", unit: "dB", decimals: 2, better: 1 },
  { key: "ssim", name: "SSIM", unit: "", decimals: 4, better: 1 },
  { key: "flip", name: "FLIP", unit: "67 px/deg", decimals: 4, better: -1 },
  { key: "flip30", name: "FLIP30", unit: "30 px/deg", decimals: 4, better: -1 },
  { key: "tpsnr", name: "tPSNR", unit: "dB", decimals: 2, better: 1 },
  { key: "flicker", name: "flicker", unit: "", decimals: 4, better: -1 },
  { key: "disoccluded", name: "disoccluded", unit: "dB", decimals: 2, better: 1 },
  { key: "sharpness", name: "sharpness", unit: "", decimals: 3, better: 0 },
  { key: "jod", name: "JOD", unit: "", decimals: 3, better: 1 },
];
const colors = d3.scale.category10();
const results = data.results;
const sources = results.runs.map((run) => run.source).filter((s, i, all) => all.indexOf(s) === i);
const byId = (id) => document.getElementById(id);
let source = sources[0];
let metric = metrics[0];

const runsHere = () => results.runs.filter((run) => run.source === source);
const color = (run) => colors(run.technique);
const shown = (value, decimals) =>
  value === null || value === undefined ? "–" : value.toFixed(decimals);

function element(parent, tag, text, className) {
  const made = parent.appendChild(document.createElement(tag));
  if (text !== undefined) made.textContent = text;
  if (className) made.className = className;
  return made;
}

function drawTable() {
  const columns = [];
  for (const m of metrics) {
    columns.push({ ...m, value: (run) => (run.mean ? run.mean[m.key] : null) });
    if (m.key === "flicker") {
      columns.push({ name: "residue", unit: "", decimals: 4, better: -1,
                     value: (run) => (run.residue ? run.residue.sigma_mean : null) });
    }
    if (m.key !== "psnr" || !runsHere().some((run) => run.still && run.moving)) continue;
    for (const part of ["still", "moving"]) {
      columns.push({ ...m, name: part, value: (run) => (run[part] ? run[part].psnr : null) });
    }
  }
  columns.push({ name: "settles", unit: "frames", decimals: 0, better: 0,
                 value: (run) => (run.convergence ? run.convergence.frames : null) });
  columns.push({ name: "resolve", unit: "ms", decimals: 2, better: 0,
                 value: (run) => run.cost.gpu_ms.median });
  columns.push({ name: "history", unit: "MiB", decimals: 2, better: 0,
                 value: (run) => run.cost.history_bytes / 1048576 });
  // A figure that none of these runs has takes no room.
  const has = (c) => runsHere().some((run) => typeof c.value(run) === "number");
  const shownColumns = columns.filter(has);
  const table = byId("table");
  table.textContent = "";
  const root = element(table, "table");
  const head = element(element(root, "thead"), "tr");
  element(head, "th", "technique");
  for (const c of shownColumns) element(element(head, "th", c.name), "small", c.unit);
  const body = element(root, "tbody");
  const runs = runsHere();
  for (const run of runs) {
    const row = element(body, "tr");
    const name = element(row, "td");
    element(name, "span", undefined, "swatch").style.background = color(run);
    name.appendChild(document.createTextNode(run.technique));
    name.title = JSON.stringify(run.settings);
    for (const c of shownColumns) {
      const value = c.value(run);
      const all = runs.map(c.value).filter((v) => typeof v === "number");
      const best = c.better !== 0 && runs.length > 1 && typeof value === "number" &&
        all.every((v) => v * c.better <= value * c.better);
      element(row, "td", shown(value, c.decimals), best ? "best" : "");
    }
  }
}

// Error by frames since something in front moved away; nothing where nothing did.
function drawAges() {
  const section = byId("ages");
  const runs = runsHere().filter((run) => run.ages.length > 0);
  section.textContent = "";
  if (runs.length === 0) return;
  element(section, "h2", "PSNR by frames since disocclusion (dB)");
  const root = element(section, "table");
  const head = element(element(root, "thead"), "tr");
  element(head, "th", "technique");
  for (const a of runs[0].ages) element(head, "th", `${a.age}`).title = `${a.pixels} pixels`;
  const body = element(root, "tbody");
  for (const run of runs) {
    const row = element(body, "tr");
    const name = element(row, "td");
    element(name, "span", undefined, "swatch").style.background = color(run);
    name.appendChild(document.createTextNode(run.technique));
    for (const a of run.ages) element(row, "td", shown(a.psnr, 2));
  }
}

function drawPlot() {
  const plot = byId("plot");
  plot.textContent = "";
  const runs = runsHere();
  const width = Math.max(plot.clientWidth, 300);
  const height = 280;
  const margin = { left: 56, right: 12, top: 10, bottom: 34 };
  const svg = d3.select(plot).append("svg").attr("viewBox", `0 0 ${width} ${height}`);
  const points = runs.map((run) => run.frames.filter((f) => typeof f[metric.key] === "number"));
  const values = [].concat(...points).map((f) => f[metric.key]).filter((v) => v < 199);
  const frames = Math.max(1, ...runs.map((run) => run.frames.length - 1));
  const x = d3.scale.linear().domain([0, frames]).range([margin.left, width - margin.right]);
  const y = d3.scale.linear().domain(values.length ? d3.extent(values) : [0, 1]).nice()
    .range([height - margin.bottom, margin.top]).clamp(true);
  const counted = runs.length ? runs[0].frames.findIndex((f) => f.counted) : 0;
  if (counted > 0) {
    svg.append("rect").attr("class", "warm-up").attr("x", x(0)).attr("y", margin.top)
      .attr("width", x(counted) - x(0)).attr("height", height - margin.top - margin.bottom);
  }
  svg.append("g").attr("class", "axis").attr("transform", `translate(0,${height - margin.bottom})`)
    .call(d3.svg.axis().scale(x).orient("bottom").tickFormat(d3.format("d")));
  svg.append("g").attr("class", "axis").attr("transform", `translate(${margin.left},0)`)
    .call(d3.svg.axis().scale(y).orient("left").ticks(6));
  svg.append("text").attr("class", "note").attr("x", width / 2).attr("y", height - 3)
    .text("frame (shaded: not counted)");
  const line = d3.svg.line().x((f) => x(f.frame)).y((f) => y(f[metric.key]));
  runs.forEach((run, i) => {
    svg.append("path").attr("class", "series").attr("stroke", color(run)).attr("d", line(points[i]))
      .append("title").text(run.technique);
  });
  const cursor = svg.append("line").attr("id", "cursor").attr("y1", margin.top)
    .attr("y2", height - margin.bottom).attr("stroke", "#888").attr("stroke-dasharray", "3 3");
  drawPlot.mark = (frame) => cursor.attr("x1", x(frame)).attr("x2", x(frame));
  drawPlot.mark(comparer.frame());
  svg.on("click", function () { comparer.setFrame(Math.round(x.invert(d3.mouse(this)[0]))); });
}

function fillMetrics() {
  const measured = (m) =>
    results.runs.some((run) => run.frames.some((f) => typeof f[m.key] === "number"));
  for (const m of metrics.filter(measured)) {
    const button = element(byId("metrics"), "button", m.name);
    button.type = "button";
    button.onclick = () => {
      metric = m;
      for (const other of byId("metrics").children) other.classList.toggle("on", other === button);
      drawPlot();
    };
    button.classList.toggle("on", m === metric);
  }
}

function showSource(name) {
  source = name;
  comparer.setSource(data.images[source] || {});
  drawTable();
  drawAges();
  drawPlot();
}

const comparer = makeComparer({
  canvas: byId("canvas"), left: byId("left"), right: byId("right"), mode: byId("mode"),
  zoom: byId("zoom"), range: byId("frame"), number: byId("frame-number"), play: byId("play"),
  readout: byId("readout"), onFrame: (frame) => drawPlot.mark && drawPlot.mark(frame),
});

byId("context").textContent =
  `${results.extent.join(" x ")}, ${results.device.name}, Reprise ${results.reprise}. ` +
  `${results.command}`;
for (const name of sources) element(byId("source"), "option", name);
byId("source").onchange = (event) => showSource(event.target.value);
fillMetrics();
showSource(source);
window.addEventListener("resize", () => { drawPlot(); comparer.draw(); });
