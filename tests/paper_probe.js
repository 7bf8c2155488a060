// Appended to a copy of paper.html by paper_cli_test: works the page as a reader would and leaves
// what it found in the document for the test to read.
window.addEventListener("load", () => setTimeout(async () => {
  const found = [];
  const wait = () => new Promise((done) => setTimeout(done, 150));
  const count = (selector) => document.querySelectorAll(selector).length;
  try {
    await wait();
    found.push("items=" + count("#items > section"));
    found.push("claims=" + (count("#claims tbody tr") > 0));
    found.push("cells=" + (count("path.cell") > 0));
    found.push("series=" + (count("path.series") > 0));
    found.push("heat=" + count("canvas.heat"));
    found.push("pictures=" + (count(".strip img") > 0));
    document.querySelector(".strip figure").onclick();
    await wait();
    const canvas = document.querySelector(".comparer canvas");
    found.push("drawn=" + canvas.dataset.drawn);
    found.push("size=" + (canvas.width > 100 && canvas.height > 50));
  } catch (error) {
    found.push("error=" + error.stack);
  }
  const out = document.createElement("pre");
  out.id = "probe";
  out.textContent = "PROBE " + found.join(" | ") + " END";
  document.body.appendChild(out);
}, 50));
