// Plots of a paper's page: lines, surfaces in space, heat maps. Each takes a parent and a block of
// lab/paper/outcome.h.
"use strict";

const plots = (() => {
  const colors = d3.scale.category10();
  const heat = d3.scale.linear().domain([0, 0.25, 0.5, 0.75, 1])
    .range(["#0d0887", "#7e03a8", "#cc4778", "#f89540", "#f0f921"]).clamp(true);

  function svgIn(parent, width, height) {
    return d3.select(parent).append("svg").attr("width", width).attr("height", height)
      .attr("viewBox", `0 0 ${width} ${height}`);
  }

  function legend(parent, names) {
    const line = d3.select(parent).append("div").attr("class", "legend");
    names.forEach((name, i) => {
      const item = line.append("span");
      item.append("i").attr("class", "swatch").style("background", colors(i));
      item.append("b").style("font-weight", "400").text(name);
    });
  }

  function lines(parent, block) {
    const [width, height] = block.square ? [340, 316] : [760, 300];
    const margin = { left: 58, right: 12, top: 8, bottom: 38 };
    // Equal images have 200 dB, which would flatten all others.
    const most = (key) => key === "y" && /\bdB\b/.test(block.y) ? 199 : Infinity;
    const all = (key) => [].concat(...block.series.map((s) => s[key]))
      .filter((v) => Number.isFinite(v) && v < most(key));
    const svg = svgIn(parent, width, height);
    const scaleOf = (key, log) => log
      ? d3.scale.log().domain(d3.extent(all(key).filter((v) => v > 0)))
      : d3.scale.linear().domain(block.square ? [0, block.square] : d3.extent(all(key)));
    const x = scaleOf("x", block.log_x).range([margin.left, width - margin.right]);
    const y = scaleOf("y", block.log_y).nice().range([height - margin.bottom, margin.top])
      .clamp(true);
    // Powers are marked where they were measured when those are few; else about where d3 would.
    const ticks = (axis, key, log, count) => {
      const values = d3.set(all(key)).values().map(Number);
      if (!log) return axis.ticks(count);
      return values.length <= 8 ? axis.tickValues(values).tickFormat(d3.format("g"))
        : axis.ticks(count, (v) => Number(v.toPrecision(2)).toString());
    };
    svg.append("g").attr("class", "axis").attr("transform", `translate(0,${height - margin.bottom})`)
      .call(ticks(d3.svg.axis().scale(x).orient("bottom"), "x", block.log_x, 8));
    svg.append("g").attr("class", "axis").attr("transform", `translate(${margin.left},0)`)
      .call(ticks(d3.svg.axis().scale(y).orient("left"), "y", block.log_y, 6));
    svg.append("text").attr("class", "note").attr("text-anchor", "end")
      .attr("x", width - margin.right).attr("y", height - 4).text(block.x);
    svg.append("text").attr("class", "note").attr("transform", "rotate(-90)")
      .attr("text-anchor", "end").attr("x", -margin.top).attr("y", 12).text(block.y);
    block.series.forEach((series, i) => {
      const points = series.x.map((v, k) => [x(v), y(series.y[k])]);
      if (series.points) {
        svg.append("g").selectAll("circle").data(points).enter().append("circle").attr("r", 3)
          .attr("cx", (p) => p[0]).attr("cy", (p) => p[1]).attr("fill", colors(i));
      } else {
        svg.append("path").attr("class", "series").attr("stroke", colors(i))
          .attr("d", d3.svg.line()(points)).append("title").text(series.name);
      }
    });
    legend(parent, block.series.map((s) => s.name));
  }

  // A box seen from a corner above: (u, v, w) in [0, 1]^3 to the page, far cells first.
  function surfaces(parent, block) {
    const values = [].concat(...block.panels.map((p) => [].concat(...p.surfaces.map((s) => s.z))));
    const [low, high] = [Math.min(0, d3.min(values)), d3.max(values)];
    const [width, height] = [430, 380];
    const project = (u, v, w) => [
      width / 2 + (u - v) * 165, 250 + (u + v - 1) * 85 - w * 200];
    const path = (points) => "M" + points.map((p) => p.join(",")).join("L");
    const row = d3.select(parent).append("div").attr("class", "panels");
    for (const panel of block.panels) {
      const svg = svgIn(row.append("div").node(), width, height);
      svg.append("text").attr("class", "note").attr("x", 6).attr("y", 14).text(panel.name);
      const floor = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]];
      svg.append("path").attr("fill", "none").attr("stroke", "#8886")
        .attr("d", path(floor.map(([u, v]) => project(u, v, 0))));
      for (let i = 0; i <= 4; ++i) {
        const w = i / 4;
        svg.append("path").attr("fill", "none").attr("stroke", "#8884")
          .attr("d", path([project(0, 1, w), project(0, 0, w), project(1, 0, w)]));
        const at = project(0, 1, w);
        svg.append("text").attr("class", "note").attr("text-anchor", "end").attr("x", at[0] - 5)
          .attr("y", at[1] + 4).text(d3.format(".2f")(low + w * (high - low)));
      }
      const cells = [];
      panel.surfaces.forEach((surface, index) => {
        const [nx, ny] = [surface.x.length, surface.y.length];
        const u = (i) => i / (nx - 1);
        const v = (j) => j / (ny - 1);
        const w = (i, j) => (surface.z[j * nx + i] - low) / (high - low);
        for (let j = 0; j + 1 < ny; ++j) {
          for (let i = 0; i + 1 < nx; ++i) {
            const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
            cells.push({
              depth: i + j, height: d3.mean(corners.map(([a, b]) => w(a, b))), index,
              path: path(corners.map(([a, b]) => project(u(a), v(b), w(a, b)))) + "Z" });
          }
        }
      });
      cells.sort((a, b) => a.depth - b.depth || a.height - b.height);
      for (const cell of cells) {
        svg.append("path").attr("class", "cell").attr("d", cell.path)
          .attr("fill", heat(cell.height)).attr("fill-opacity", 0.82).attr("stroke", "#222")
          .attr("stroke-width", 0.6).append("title").text(panel.surfaces[cell.index].name);
      }
      const first = panel.surfaces[0];
      const right = project(1, 0.5, 0);
      const left = project(0.5, 1, 0);
      const range = (a) => `${a[0]} to ${a[a.length - 1]}`;
      svg.append("text").attr("class", "note").attr("x", left[0] - 70).attr("y", left[1] + 26)
        .attr("text-anchor", "middle").text(`${block.x}: ${range(first.x)}`);
      svg.append("text").attr("class", "note").attr("x", right[0] + 10).attr("y", right[1] + 26)
        .attr("text-anchor", "middle").text(`${block.y}: ${range(first.y)}`);
    }
    d3.select(parent).append("p").attr("class", "hint").text(
      `${block.z}, from top to bottom: ${block.panels[0].surfaces.map((s) => s.name).join(", ")}.`);
  }

  function heatMaps(parent, block) {
    const high = d3.max(block.maps, (m) => d3.max(m.z));
    const row = d3.select(parent).append("div").attr("class", "panels");
    for (const map of block.maps) {
      // Pixels or tiles both ways keep their shape.
      const side = 260;
      const down = block.x === block.y ? side * map.y.length / map.x.length : side;
      const figure = row.append("figure").style("margin", 0);
      const canvas = figure.append("canvas").attr("width", map.x.length).attr("height", map.y.length)
        .attr("class", "heat").style("width", side + "px").style("height", down + "px")
        .style("image-rendering", "pixelated").node();
      const context = canvas.getContext("2d");
      map.z.forEach((z, i) => {
        context.fillStyle = heat(z / high);
        context.fillRect(i % map.x.length, Math.floor(i / map.x.length), 1, 1);
      });
      figure.append("figcaption").attr("class", "hint").text(map.name);
    }
    d3.select(parent).append("p").attr("class", "hint").text(
      `Across: ${block.x}, ${d3.extent(block.maps[0].x).join(" to ")}; down: ${block.y}. ` +
      `${block.z}: dark 0 to yellow ${d3.format(".3f")(high)}.`);
  }

  return { lines, surfaces, heat: heatMaps };
})();
