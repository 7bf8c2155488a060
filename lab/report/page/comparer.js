// Two images of one frame on a canvas: slider, flip, side by side or difference, at any whole zoom.
"use strict";

function makeComparer(ui) {
  const context = ui.canvas.getContext("2d");
  const state = { kinds: {}, frames: [], at: 0, split: 0.5, x: 0, y: 0, flipped: false, timer: null };
  const decoded = new Map();

  function picture(what) {
    const frames = state.kinds[what];
    const uri = frames && frames[state.frames[state.at]];
    if (!uri) return null;
    if (!decoded.has(uri)) {
      const image = new Image();
      image.onload = draw;
      image.src = uri;
      decoded.set(uri, image);
      // Decoded pictures are large: keep the last few dozen.
      if (decoded.size > 64) decoded.delete(decoded.keys().next().value);
    }
    const image = decoded.get(uri);
    return image.complete && image.naturalWidth > 0 ? image : null;
  }

  const zoom = () => Number(ui.zoom.value);
  const frame = () => state.frames[state.at] || 0;

  function pixelsOf(image) {
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth;
    canvas.height = image.naturalHeight;
    const own = canvas.getContext("2d");
    own.drawImage(image, 0, 0);
    return { canvas, own, pixels: own.getImageData(0, 0, canvas.width, canvas.height) };
  }

  function difference(a, b) {
    const one = pixelsOf(a);
    const two = pixelsOf(b).pixels.data;
    const to = one.pixels.data;
    for (let i = 0; i < to.length; i += 4) {
      for (let c = 0; c < 3; ++c) to[i + c] = Math.min(255, 4 * Math.abs(to[i + c] - two[i + c]));
    }
    one.own.putImageData(one.pixels, 0, 0);
    return one.canvas;
  }

  function put(image, from, to, offset) {
    const width = ui.canvas.width;
    context.save();
    context.beginPath();
    context.rect(from, 0, to - from, ui.canvas.height);
    context.clip();
    const w = image.width || image.naturalWidth;
    const h = image.height || image.naturalHeight;
    context.drawImage(image, offset - state.x * scale(), -state.y * scale(), w * scale(), h * scale());
    context.restore();
    return width;
  }

  // Device pixels per image pixel: zoom 1 fits the width.
  function scale() { return state.fit * zoom(); }

  function label(text, x, right) {
    context.font = `${14 * devicePixelRatio}px system-ui, sans-serif`;
    const width = context.measureText(text).width + 16;
    context.fillStyle = "#000a";
    context.fillRect(right ? x - width : x, 0, width, 26 * devicePixelRatio);
    context.fillStyle = "#fff";
    context.fillText(text, (right ? x - width : x) + 8, 18 * devicePixelRatio);
  }

  function draw() {
    const left = picture(ui.left.value);
    const right = picture(ui.right.value);
    const first = left || right;
    if (!first) return;
    const side = ui.mode.value === "side";
    const width = Math.max(1, Math.round(ui.canvas.clientWidth * devicePixelRatio));
    const shown = side ? 2 * first.naturalWidth : first.naturalWidth;
    state.fit = width / shown;
    const height = Math.max(1, Math.round(first.naturalHeight * state.fit));
    if (ui.canvas.width !== width || ui.canvas.height !== height) {
      ui.canvas.width = width;
      ui.canvas.height = height;
    }
    context.fillStyle = "#202020";
    context.fillRect(0, 0, width, height);
    context.imageSmoothingEnabled = scale() < 1;
    if (!left || !right) {
      put(first, 0, width, 0);
    } else if (ui.mode.value === "difference") {
      put(difference(left, right), 0, width, 0);
      label(`|${ui.left.value} − ${ui.right.value}| x 4`, 0, false);
    } else if (side) {
      put(left, 0, width / 2, 0);
      put(right, width / 2, width, width / 2);
      label(ui.left.value, 0, false);
      label(ui.right.value, width, true);
    } else if (ui.mode.value === "flip") {
      put(state.flipped ? right : left, 0, width, 0);
      label(state.flipped ? ui.right.value : ui.left.value, 0, false);
    } else {
      const split = Math.round(state.split * width);
      put(left, 0, split, 0);
      put(right, split, width, 0);
      context.fillStyle = "#fff";
      context.fillRect(split - 1, 0, 2, height);
      label(ui.left.value, 0, false);
      label(ui.right.value, width, true);
    }
    ui.canvas.dataset.drawn = `${ui.left.value}|${ui.right.value}|${ui.mode.value}|${frame()}|${zoom()}`;
  }

  function setFrame(wanted) {
    if (!state.frames.length) return;
    let best = 0;
    state.frames.forEach((f, i) => {
      if (Math.abs(f - wanted) < Math.abs(state.frames[best] - wanted)) best = i;
    });
    show(best);
  }

  function show(at) {
    state.at = Math.min(Math.max(at, 0), Math.max(state.frames.length - 1, 0));
    ui.range.value = state.at;
    ui.number.textContent = state.frames.length ? frame() : "none embedded";
    ui.onFrame(frame());
    draw();
  }

  function fill(select, names, wanted) {
    const before = select.value;
    select.textContent = "";
    for (const name of names) {
      const option = document.createElement("option");
      option.value = option.textContent = name;
      select.appendChild(option);
    }
    select.value = names.includes(before) && before !== "" ? before : wanted;
  }

  function setSource(kinds) {
    state.kinds = kinds;
    const names = Object.keys(kinds);
    const plain = names.filter((name) => !name.startsWith("flip of "));
    const techniques = plain.filter((name) => name !== "reference");
    fill(ui.left, names, techniques[techniques.length - 1] || names[0]);
    fill(ui.right, names, names.includes("reference") ? "reference" : techniques[0]);
    const frames = new Set();
    for (const name of names) for (const f of Object.keys(kinds[name])) frames.add(Number(f));
    state.frames = [...frames].sort((a, b) => a - b);
    ui.range.max = Math.max(state.frames.length - 1, 0);
    show(state.frames.length - 1);
  }

  function zoomAt(factor, px, py) {
    const options = [...ui.zoom.options].map((o) => Number(o.value));
    const before = scale();
    const next = options[options.indexOf(zoom()) + factor];
    if (next === undefined) return;
    ui.zoom.value = next;
    state.x += px / before - px / scale();
    state.y += py / before - py / scale();
    draw();
  }

  function place(event) {
    const box = ui.canvas.getBoundingClientRect();
    return { x: (event.clientX - box.left) * devicePixelRatio, y: (event.clientY - box.top) * devicePixelRatio };
  }

  let drag = null;
  ui.canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  ui.canvas.addEventListener("pointerdown", (event) => {
    drag = { ...place(event), move: event.button === 2 || event.shiftKey || ui.mode.value !== "slider" };
    ui.canvas.setPointerCapture(event.pointerId);
    if (!drag.move) { state.split = drag.x / ui.canvas.width; draw(); }
  });
  ui.canvas.addEventListener("pointermove", (event) => {
    const p = place(event);
    if (drag && drag.move) {
      state.x -= (p.x - drag.x) / scale();
      state.y -= (p.y - drag.y) / scale();
      drag = { ...p, move: true };
      draw();
    } else if (drag) {
      state.split = Math.min(Math.max(p.x / ui.canvas.width, 0), 1);
      draw();
    }
    const x = Math.floor(p.x / scale() + state.x);
    const y = Math.floor(p.y / scale() + state.y);
    ui.readout.textContent = `pixel (${x}, ${y}).`;
  });
  ui.canvas.addEventListener("pointerup", () => { drag = null; });
  ui.canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const p = place(event);
    zoomAt(event.deltaY < 0 ? 1 : -1, p.x, p.y);
  }, { passive: false });
  ui.canvas.addEventListener("keydown", (event) => {
    if (event.key === " ") { state.flipped = !state.flipped; draw(); }
    else if (event.key === "ArrowRight") show(state.at + 1);
    else if (event.key === "ArrowLeft") show(state.at - 1);
    else return;
    event.preventDefault();
  });
  for (const select of [ui.left, ui.right, ui.mode]) select.onchange = draw;
  ui.zoom.onchange = () => {
    if (zoom() === 1) state.x = state.y = 0;
    draw();
  };
  ui.range.oninput = () => show(Number(ui.range.value));
  ui.play.onclick = () => {
    if (state.timer) {
      clearInterval(state.timer);
      state.timer = null;
    } else {
      state.timer = setInterval(() => show((state.at + 1) % Math.max(state.frames.length, 1)), 100);
    }
    ui.play.textContent = state.timer ? "stop" : "play";
  };
  // For flip view, a press of the canvas flips.
  ui.canvas.addEventListener("click", () => {
    if (ui.mode.value === "flip") { state.flipped = !state.flipped; draw(); }
  });

  return { setSource, setFrame, frame, draw };
}
