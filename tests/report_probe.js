// Appended to a copy of report.html by cli_test: works the page as a reader would and leaves what it
// found in the document for the test to read.
window.addEventListener("load", () => setTimeout(async () => {
  const found = [];
  const wait = () => new Promise((done) => setTimeout(done, 150));
  const canvas = document.getElementById("canvas");
  const pixel = (x, y) => [...canvas.getContext("2d").getImageData(x, y, 1, 1).data].slice(0, 3).join(",");
  const set = async (id, value) => {
    const control = document.getElementById(id);
    control.value = value;
    control.dispatchEvent(new Event(control.type === "range" ? "input" : "change"));
    await wait();
  };
  try {
    await wait();
    found.push("rows=" + document.querySelectorAll("#table tbody tr").length);
    found.push("series=" + document.querySelectorAll("#plot path.series").length);
    document.querySelectorAll("#metrics button")[2].click();
    found.push("metric=" + document.querySelector("#metrics button.on").textContent);
    found.push("kinds=" + [...document.getElementById("left").options].map((o) => o.value).join(";"));
    await set("left", "none");
    await set("right", "reference");
    await set("zoom", "4");
    await set("frame", "0");
    found.push("drawn0=" + canvas.dataset.drawn);
    const slider = pixel(4, canvas.height - 4);
    await set("mode", "flip");
    canvas.focus();
    canvas.dispatchEvent(new KeyboardEvent("keydown", { key: " " }));
    await wait();
    found.push("flips=" + (pixel(4, canvas.height - 4) !== slider || "same"));
    await set("mode", "difference");
    found.push("drawn1=" + canvas.dataset.drawn);
    await set("mode", "side");
    await set("left", "flip of none");
    await set("frame", document.getElementById("frame").max);
    found.push("drawn2=" + canvas.dataset.drawn);
    found.push("size=" + (canvas.width > 100 && canvas.height > 50));
  } catch (error) {
    found.push("error=" + error.stack);
  }
  const out = document.createElement("pre");
  out.id = "probe";
  out.textContent = "PROBE " + found.join(" | ") + " END";
  document.body.appendChild(out);
}, 50));
