// The page of a paper: claims, then each item with its rows, plots, tables and pictures. `data` is
// what lab/paper/paper_page.cpp wrote.
"use strict";

function element(parent, tag, text, className) {
  const made = parent.appendChild(document.createElement(tag));
  if (text !== undefined) made.textContent = text;
  if (className) made.className = className;
  return made;
}

const shown = (value) => value === null ? "–" : Number(value.toPrecision(4)).toString();

function rowsTable(parent, rows, withItem) {
  const table = element(parent, "table");
  const head = element(element(table, "thead"), "tr");
  for (const name of [...(withItem ? ["item"] : []), "row", "published", "measured", "unit", "claim", ""]) {
    const isText = name === "row" || name === "unit" || name === "claim";
    element(head, "th", name, isText ? "text" : "");
  }
  const body = element(table, "tbody");
  for (const row of rows) {
    const line = element(body, "tr");
    if (withItem) element(line, "td", row.item);
    element(line, "td", row.row, "text");
    element(line, "td", shown(row.published));
    element(line, "td", shown(row.measured));
    element(line, "td", row.unit, "text");
    element(line, "td", row.claim, "text");
    const verdict = row.holds === null ? "" : row.holds ? "holds" : "does not hold";
    element(line, "td", verdict, row.holds === false ? "fails" : "holds");
  }
}

function textTable(parent, block) {
  const table = element(parent, "table");
  const head = element(element(table, "thead"), "tr");
  for (const name of block.columns) element(head, "th", name);
  const body = element(table, "tbody");
  for (const line of block.lines) {
    const row = element(body, "tr");
    for (const cell of line) element(row, "td", cell);
  }
}

function select(parent, text, values) {
  const label = element(parent, "label", text + " ");
  const made = element(label, "select");
  for (const value of values) element(made, "option", String(value)).value = value;
  return made;
}

// Any two pictures of a gallery on one canvas, made when first asked for.
function openComparer(parent, kinds, left) {
  const bar = element(parent, "div", undefined, "bar comparer-bar");
  const ui = {
    left: select(bar, "Left", []), right: select(bar, "Right", []),
    mode: select(bar, "View", ["slider", "flip", "side", "difference"]),
    zoom: select(bar, "Zoom", [1, 2, 4, 8, 16]),
    range: document.createElement("input"), number: document.createElement("output"),
    play: document.createElement("button"), onFrame: () => {} };
  const stage = element(parent, "div", undefined, "comparer");
  ui.canvas = element(stage, "canvas");
  ui.canvas.tabIndex = 0;
  ui.readout = element(element(parent, "p", undefined, "hint"), "span");
  const comparer = makeComparer(ui);
  comparer.setSource(kinds);
  ui.left.value = left;
  comparer.draw();
  return ui;
}

function gallery(parent, block, pictures) {
  const strip = element(parent, "div", undefined, "strip");
  const kinds = {};
  let comparer = null;
  for (const picture of block.pictures) {
    kinds[picture.label] = { 0: pictures[picture.index] };
    const figure = element(strip, "figure");
    const image = element(figure, "img");
    image.src = pictures[picture.index];
    image.alt = picture.label;
    // Whole zooms only: pixels are what is to be seen.
    image.width = picture.width * Math.max(1, Math.round(210 / picture.width));
    element(figure, "figcaption", picture.label);
    figure.title = "compare";
    figure.onclick = () => {
      if (!comparer) comparer = openComparer(parent, kinds, picture.label);
      comparer.left.value = picture.label;
      comparer.left.onchange();
    };
  }
}

const blocks = {
  lines: (parent, block) => plots.lines(element(parent, "div", undefined, "plot"), block),
  surfaces: (parent, block) => plots.surfaces(element(parent, "div", undefined, "plot"), block),
  heat: (parent, block) => plots.heat(element(parent, "div", undefined, "plot"), block),
  table: textTable,
  gallery: (parent, block, pictures) => gallery(parent, block, pictures),
};

const byId = (id) => document.getElementById(id);
const scale = data.scale;
byId("context").textContent =
  `${data.citation}. Run at ${scale.extent.join(" x ")}, ${scale.frames} frames in motion and ` +
  `${scale.still_frames} at rest, references of ${scale.samples} and ${scale.still_samples} samples ` +
  `a pixel. Reprise ${data.reprise}. ${data.command}`;

const claims = [];
for (const item of data.items) {
  const rows = item.rows.map((row) => ({ ...row, item: item.item }));
  claims.push(...rows.filter((row) => row.holds !== null));
  const link = element(byId("contents"), "a", item.item, item.complete ? "" : "open");
  link.href = "#" + item.item.replace(" ", "-");
  const section = element(byId("items"), "section");
  section.id = item.item.replace(" ", "-");
  element(section, "h2", `${item.item[0].toUpperCase()}${item.item.slice(1)}: ${item.title}`);
  for (const note of item.notes) element(section, "p", note, "hint");
  if (rows.length) rowsTable(section, rows, false);
  for (const block of item.blocks) {
    element(section, "h3", block.title);
    blocks[block.kind](section, block, item.pictures);
  }
}
rowsTable(byId("claims"), claims, true);
