// The 3D view of a page: what is shown, and the controls around it.
"use strict";
(async () => {
  const $ = id => document.getElementById(id);
  const data = JSON.parse($("view-data").textContent);
  const canvas = $("view"), stage = $("view-stage"), say = text => { $("view-status").textContent = text; };
  const still = text => { stage.classList.add("still"); say(text + ": the picture above stands in for the 3D view."); };
  if (!window.DecompressionStream) return still("This browser cannot unpack points");
  let sets, renderer;
  try {
    sets = await Promise.all(data.sets.map(set => unpackSet(data, set)));
  } catch {
    return still("The points of this page cannot be read");
  }
  try {
    renderer = new Renderer(canvas, data, sets);
  } catch {
    return still("This browser cannot compile the 3D view");
  }
  if (!renderer.gl) return still("This browser draws no WebGL 2");

  const camera = new Camera(data), coloring = new Coloring(data, sets);
  const look = { sizeFactor: 1, isShaded: data.shaded };
  let wave = data.waves.length - 1, frame = 0, tool = "", picked = [], box = null, profile = null, profileWidth = camera.reach / 50;

  /** What the tools look at. */
  const view = {
    data, camera, canvas,
    get box() { return box; },
    get shown() {
      const { set, shown } = data.waves[wave] ?? { set: 0, shown: sets[0].count };
      return { set: sets[set], count: shown };
    },
  };

  function draw() {
    frame = 0;
    renderer.resize(camera);
    const { set, count } = view.shown;
    renderer.draw(camera, set, count, { ...look, isLit: look.isShaded && coloring.isLit, box });
    drawMarks();
    canvas.dataset.frames = 1 + Number(canvas.dataset.frames || 0);
  }
  function redraw() {
    if (!frame) frame = requestAnimationFrame(draw);
    writeLink();
  }
  function recolor() {
    coloring.apply();
    renderer.setColors();
    drawStrip();
    redraw();
  }

  // ---- Marks over the picture: chosen points, the box and its handles, a scale bar, north.
  const px = place => camera.project(camera.projection().m, place, canvas.clientWidth, canvas.clientHeight);
  const faces = [0, 1, 2].flatMap(axis => ["low", "high"].map(end => ({ axis, end })));
  const middleOf = ({ axis, end }) => [0, 1, 2].map(k => k === axis ? box[end][k] : (box.low[k] + box.high[k]) / 2);

  function drawMarks() {
    const w = canvas.clientWidth, h = canvas.clientHeight;
    let svg = "";
    if (box) {
      const corner = i => px([0, 1, 2].map(k => (i >> k & 1 ? box.high : box.low)[k])), corners = [...Array(8).keys()].map(corner);
      for (let i = 0; i < 8; i++)
        for (let k = 0; k < 3; k++)
          if (!(i >> k & 1) && corners[i] && corners[i | 1 << k])
            svg += `<path class="box" d="M${corners[i].slice(0, 2)}L${corners[i | 1 << k].slice(0, 2)}"/>`;
      faces.forEach((face, i) => {
        const at = px(middleOf(face));
        if (at) svg += `<circle class="handle" data-face="${i}" cx="${at[0]}" cy="${at[1]}" r="8"/>`;
      });
    }
    const at = picked.map(p => px(p.place)), ends = at.map((p, i) => [p, at[i + 1] ?? (tool === "area" && i > 1 ? at[0] : null)]);
    for (const [a, b] of ends) if (a && b) svg += `<path d="M${a.slice(0, 2)}L${b.slice(0, 2)}"/>`;
    at.forEach((p, i) => {
      if (p) svg += `<circle cx="${p[0]}" cy="${p[1]}" r="5"/><text x="${p[0] + 9}" y="${p[1] - 7}">${nameOf(i)}</text>`;
    });
    if (tool) svg += `<path class="cross" d="M${w / 2 - 8} ${h / 2}h16M${w / 2} ${h / 2 - 8}v16"/>`;
    $("view-marks").innerHTML = svg + scaleBar(w, h) + northArrow(w, h);
  }
  const nameOf = i => i < 26 ? String.fromCharCode(65 + i) : String(i + 1);

  function scaleBar(w, h) {
    const perLength = camera.pxPerLength(h), most = w / 5 / perLength, ten = 10 ** Math.floor(Math.log10(most));
    const length = ten * [5, 2, 1].find(s => s * ten <= most), wide = length * perLength, x = w - 14, y = h - 14;
    const text = endText(length, length) + " " + data.unit + (camera.isFlat ? "" : " in the middle");
    const panel = Math.max(wide, 7 * text.length) + 16;
    return `<rect class="plate" x="${w - panel - 6}" y="${h - 42}" width="${panel}" height="36" rx="5"/>`
      + `<path class="scale" d="M${x - wide} ${y - 6}v6h${wide}v-6"/><text class="label" x="${x}" y="${y - 12}">${text}</text>`;
  }

  function northArrow(w, h) {
    if (!data.north) return "";
    const { right, above } = camera.axes(), x = dot(camera.north, right), y = -dot(camera.north, above), seen = Math.hypot(x, y);
    if (seen < 0.1) return "";
    const long = 18 * Math.min(1, seen / 0.4) / seen, cx = w - 30, cy = h - 84, [nx, ny] = [x * long, y * long];
    const [ax, ay] = [-ny * 0.45, nx * 0.45];
    return `<rect class="plate" x="${w - 54}" y="${h - 112}" width="48" height="66" rx="5"/>`
      + `<path class="north" d="M${cx + nx} ${cy + ny}L${cx - nx + ax} ${cy - ny + ay}L${cx - nx * 0.5} ${cy - ny * 0.5}Z"/>`
      + `<path class="north back" d="M${cx + nx} ${cy + ny}L${cx - nx - ax} ${cy - ny - ay}L${cx - nx * 0.5} ${cy - ny * 0.5}Z"/>`
      + `<text class="label middle" x="${cx}" y="${h - 51}">N</text>`;
  }

  // ---- Picking and measuring.
  function pick(x, y, radius) {
    const index = frontPoint(view, x, y, radius);
    if (index < 0) return say("No point there.");
    if (picked.length >= tools[tool].most) picked = [];
    picked.push(pointOf(data, view.shown.set, index));
    describe();
    redraw();
  }

  function describe() {
    const rows = picked.map((p, i) => [nameOf(i), coordinates(p.texts)]), results = tool ? measure(data, tool, picked) : [];
    if (tool === "point" && picked[0]?.set) rows.push(...attributesOf(data, picked[0]));
    $("view-measured").replaceChildren(...[...results, ...rows].flatMap(row => row.map((text, i) =>
      Object.assign(document.createElement(i ? "dd" : "dt"), { textContent: text }))));
    if (tool) say(results.length ? results.map(r => r.join(" ")).join(", ") + "." : picked.length
      ? (tools[tool].most > picked.length ? "Point " + nameOf(picked.length - 1) + " is set; choose another." : "Point " + rows[0][1])
      : tools[tool].text + ", or turn it under the cross and press Enter.");
    profile = tool === "profile" && picked.length === 2 ? picked : null;
    drawStrip();
  }

  function setTool(name) {
    if (name !== tool) picked = [];
    tool = name;
    for (const id in tools) $("view-" + id).setAttribute("aria-pressed", id === tool);
    canvas.classList.toggle("picks", !!tool);
    describe();
    if (!tool) say("");
    redraw();
  }
  for (const id in tools)
    $("view-" + id).addEventListener("click", () => { setTool(tool === id ? "" : id); canvas.focus({ preventScroll: true }); });

  // ---- The height profile.
  let strip = null;
  function drawStrip() {
    $("view-strip").hidden = !profile;
    strip = profile && profileOf(view, profile, profileWidth);
    if (!strip) return;
    drawProfile($("view-strip-canvas"), strip, strip.length, data.unit);
    $("view-strip-text").textContent = grouped(strip.points.length, 0) + " of the points here";
  }
  const download = (blob, name) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = document.title.replace(/[^\w.-]+/g, "-") + name;
    link.click();
    URL.revokeObjectURL(link.href);
  };
  $("view-strip-width").addEventListener("change", e => {
    if (e.target.valueAsNumber > 0) profileWidth = e.target.valueAsNumber;
    drawStrip();
    writeLink();
  });
  $("view-strip-csv").addEventListener("click", () =>
    download(new Blob([profileCsv(view, strip)], { type: "text/csv" }), "-profile.csv"));
  $("view-strip-save").addEventListener("click", () =>
    $("view-strip-canvas").toBlob(blob => download(blob, "-profile.png")));

  // ---- The clip box.
  const boxInputs = [...document.querySelectorAll("#view-box input")];
  function setBox(to) {
    box = to;
    $("view-clip").setAttribute("aria-pressed", !!box);
    $("view-box").hidden = !box;
    if (box) {
      // Rounded outwards: no point of the box is outside what the line names.
      const steps = 10 ** data.clipDecimals, geo = (place, k) => (data.origin[k] + place * data.size[k]) * steps;
      const ends = [...box.low.map((v, k) => Math.floor(geo(v, k) + 1e-6)), ...box.high.map((v, k) => Math.ceil(geo(v, k) - 1e-6))];
      boxInputs.forEach((input, i) => { input.value = (ends[i] / steps).toFixed(data.clipDecimals); });
      const line = boxInputs.map(input => input.value).join();
      $("view-box-line").textContent = "fastpoints export " + (data.source || "FILE") + " --clip " + line + " -o part.laz";
    }
    drawStrip();
    redraw();
  }
  boxInputs.forEach((input, i) => input.addEventListener("change", () => {
    const k = i % 3, place = (input.valueAsNumber - data.origin[k]) / (data.size[k] || 1), next = structuredClone(box);
    if (Number.isFinite(place)) next[i < 3 ? "low" : "high"][k] = place;
    setBox(next);
  }));
  $("view-clip").addEventListener("click", () => setBox(box ? null : { low: [0, 0, 0], high: [1, 1, 1] }));
  $("view-marks").addEventListener("pointerdown", e => {
    const face = faces[e.target.dataset.face];
    if (!face) return;
    e.preventDefault();
    $("view-marks").setPointerCapture(e.pointerId);
    const start = structuredClone(box), { axis, end } = face, from = [e.clientX, e.clientY];
    const a = middleOf(face), b = a.map((v, k) => v + (k === axis ? 0.01 : 0)), [p, q] = [px(a), px(b)];
    if (!p || !q) return;
    const [dx, dy] = [(q[0] - p[0]) * 100, (q[1] - p[1]) * 100], squared = dx * dx + dy * dy;
    const move = e => {
      const by = squared > 1 ? ((e.clientX - from[0]) * dx + (e.clientY - from[1]) * dy) / squared : 0;
      const next = structuredClone(start), other = start[end === "low" ? "high" : "low"][axis];
      const to = Math.max(0, Math.min(1, start[end][axis] + by));
      next[end][axis] = end === "low" ? Math.min(to, other) : Math.max(to, other);
      setBox(next);
    };
    const done = () => {
      $("view-marks").removeEventListener("pointermove", move);
      $("view-marks").removeEventListener("lostpointercapture", done);
    };
    $("view-marks").addEventListener("pointermove", move);
    $("view-marks").addEventListener("lostpointercapture", done);
  });

  // ---- Input: one pointer turns (shifted or by another button: moves), two pinch. The wheel zooms once the view was clicked, and
  // a finger turns once it was tapped, so that a reader scrolls past it.
  const pointers = new Map();
  let moved = 0, hover = null;
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y) };
  };
  const pan = (dx, dy) => camera.pan(dx, dy, canvas.clientHeight);
  canvas.addEventListener("pointerdown", e => {
    if (data.path) stop();
    canvas.setPointerCapture(e.pointerId);
    pointers.set(e.pointerId, { x: e.offsetX, y: e.offsetY });
    moved = pointers.size > 1 ? 99 : 0;
  });
  canvas.addEventListener("pointermove", e => {
    const before = pointers.get(e.pointerId);
    if (!before) return e.pointerType === "mouse" ? lookUnder(e.offsetX, e.offsetY) : undefined;
    const two = pointers.size === 2 ? spread() : null, dx = e.offsetX - before.x, dy = e.offsetY - before.y;
    pointers.set(e.pointerId, { x: e.offsetX, y: e.offsetY });
    moved += Math.abs(dx) + Math.abs(dy);
    if (two) {
      const now = spread();
      camera.zoom(two.apart / Math.max(1, now.apart));
      pan(now.x - two.x, now.y - two.y);
    } else if (e.shiftKey || e.buttons & 6) pan(dx, dy);
    else camera.turn(dx * 0.006, dy * 0.006);
    redraw();
  });
  for (const type of ["pointerup", "pointercancel"])
    canvas.addEventListener(type, e => {
      if (pointers.delete(e.pointerId) && type === "pointerup" && tool && moved < 5) pick(e.offsetX, e.offsetY);
    });
  canvas.addEventListener("pointerleave", () => lookUnder(-99, -99));
  canvas.addEventListener("contextmenu", e => e.preventDefault());
  canvas.addEventListener("wheel", e => {
    if (document.activeElement !== canvas && !document.fullscreenElement) return;
    e.preventDefault();
    camera.zoom(Math.exp(Math.max(-1, Math.min(1, e.deltaY / 400))));
    redraw();
  }, { passive: false });

  /** Shows the coordinates of the point under the pointer, once a frame. */
  function lookUnder(x, y) {
    if (!hover) requestAnimationFrame(() => {
      const index = frontPoint(view, hover.x, hover.y, 4);
      hover = null;
      $("view-under").textContent = index < 0 ? "" : coordinates(pointOf(data, view.shown.set, index).texts);
    });
    hover = { x, y };
  }

  const views = {
    home: () => camera.look(data.camera), top: () => camera.fit(0, Math.PI / 2), front: () => camera.fit(0, 0),
    side: () => camera.fit(-Math.PI / 2, 0),
  };
  const show = name => {
    if (data.path) stop();
    renderer.resize(camera);
    views[name]();
    redraw();
  };
  for (const name in views) $("view-" + name).addEventListener("click", () => show(name));
  canvas.addEventListener("keydown", e => {
    const key = e.key, step = 0.1, move = canvas.clientHeight / 12;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const viewKeys = { h: "home", Home: "home", t: "top", f: "front", s: "side" };
    const toolKeys = { i: "point", m: "distance", r: "height", a: "angle", q: "area", p: "profile" };
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    if (arrows[key]) e.shiftKey ? pan(-arrows[key][0] * move, -arrows[key][1] * move)
      : camera.turn(arrows[key][0] * step, arrows[key][1] * step);
    else if (key === "+" || key === "=") camera.zoom(0.8);
    else if (key === "-") camera.zoom(1.25);
    else if (viewKeys[key]) show(viewKeys[key]);
    else if (toolKeys[key]) setTool(tool === toolKeys[key] ? "" : toolKeys[key]);
    else if (key === "c") setBox(box ? null : { low: [0, 0, 0], high: [1, 1, 1] });
    else if (key === "Escape" && tool) setTool("");
    else if (key === "Backspace" && picked.length) { picked.pop(); describe(); }
    else if (key === "Enter" && tool) pick(canvas.clientWidth / 2, canvas.clientHeight / 2, 12);
    else return;
    e.preventDefault();
    redraw();
  });

  // ---- What to colour by, its legend and its range.
  const css = color => "#" + [0, 8, 16].map(s => (color >> s & 255).toString(16).padStart(2, "0")).join("");
  function legend() {
    const list = $("view-legend"), { column, range } = coloring;
    list.replaceChildren();
    $("view-range").hidden = !range;
    if (coloring.isCategory)
      return column.categories.forEach(category => {
        if (!category.count) return;
        const button = document.createElement("button"), swatch = document.createElement("i");
        swatch.style.background = "#" + category.color;
        button.type = "button";
        button.append(swatch, category.name);
        button.title = grouped(category.count, 0) + " of the points here";
        button.setAttribute("aria-pressed", !coloring.hidden.has(category.value));
        button.addEventListener("click", () => {
          if (!coloring.hidden.delete(category.value)) coloring.hidden.add(category.value);
          button.setAttribute("aria-pressed", !coloring.hidden.has(category.value));
          recolor();
        });
        list.append(button);
      });
    if (!range) return;
    const bar = document.createElement("b"), text = v => Object.assign(document.createElement("span"),
      { textContent: endText(v, range.step) });
    bar.style.background = "linear-gradient(90deg," + [0, 51, 102, 153, 204, 255].map(i => css(range.table[i])).join() + ")";
    list.append(text(range.low), bar, text(range.high), range.unit ? " " + range.unit : "");
    for (const end of ["low", "high"]) {
      const slider = $("view-range-" + end);
      slider.value = 1000 * (range[end] - range.min) / (range.max - range.min || 1);
      slider.setAttribute("aria-valuetext", endText(range[end], range.step));
      $("view-range-" + end + "-text").textContent = endText(range[end], range.step);
    }
    $("view-rest").checked = coloring.hidesRest;
  }
  for (const end of ["low", "high"])
    $("view-range-" + end).addEventListener("input", e => {
      const { range } = coloring, raw = range.min + (range.max - range.min) * e.target.valueAsNumber / 1000;
      const v = range.isWhole ? Math.round(raw) : raw;
      range[end] = end === "low" ? Math.min(v, range.high) : Math.max(v, range.low);
      legend();
      recolor();
    });
  $("view-rest").addEventListener("change", e => { coloring.hidesRest = e.target.checked; recolor(); });
  const choice = $("view-color");
  choice.append(...coloring.modes.map(m => new Option(m.name, m.id)));
  choice.addEventListener("change", () => {
    coloring.setMode(Number(choice.value));
    // The file's own colours have light in them already.
    setShaded(!coloring.isRgb);
    legend();
    recolor();
  });
  function setShaded(on) {
    $("view-shade").setAttribute("aria-pressed", look.isShaded = on);
    redraw();
  }
  $("view-shade").addEventListener("click", () => setShaded(!look.isShaded));
  $("view-size").addEventListener("input", e => { look.sizeFactor = 2 ** e.target.valueAsNumber; redraw(); });
  $("view-full").addEventListener("click", () =>
    document.fullscreenElement ? document.exitFullscreen() : $("view-figure").requestFullscreen());
  $("view-save").addEventListener("click", () => canvas.toBlob(blob => download(blob, ".png")));

  // ---- Playing: the waves of a preview, or a flight along its path; both are a slider with steps.
  const time = $("view-time"), steps = data.path ? data.path.cameras.length : data.waves.length;
  let timer = 0;
  function showStep(step) {
    time.value = step;
    if (data.path) camera.look(data.path.cameras[step]);
    else wave = step;
    const text = data.path ? "frame " + step * data.path.every : data.waves[step].text;
    $("view-time-text").textContent = text;
    time.setAttribute("aria-valuetext", text);
    document.querySelectorAll(".waves").forEach(chart =>
      chart.querySelectorAll(".mark").forEach((mark, i) => mark.classList.toggle("now", i === step)));
    redraw();
  }
  function stop() {
    timer = clearInterval(timer);
    $("view-play").textContent = "▶ Play";
  }
  $("view-play").addEventListener("click", () => {
    if (timer) return stop();
    let step = Number(time.value) + 1 < steps ? Number(time.value) + (data.path ? 1 : 0) : 0;
    $("view-play").textContent = "❚❚ Pause";
    showStep(step);
    timer = setInterval(() => {
      if (++step >= steps) return stop();
      showStep(step);
    }, data.path ? 1000 / 60 * data.path.every : 900);
  });
  time.addEventListener("input", () => { stop(); showStep(Number(time.value)); });
  time.max = steps - 1;
  $("view-player").hidden = steps < 2;

  // ---- The address says what is shown, so that a link shows the same.
  let writing = 0;
  function writeLink() {
    clearTimeout(writing);
    writing = setTimeout(() => {
      const parameters = new URLSearchParams();
      if (!data.path) parameters.set("camera", camera.toText());
      coloring.toParameters(parameters);
      if (look.sizeFactor !== 1) parameters.set("size", String(Math.log2(look.sizeFactor)));
      if (look.isShaded !== !coloring.isRgb) parameters.set("shading", look.isShaded ? "on" : "off");
      if (box) parameters.set("box", boxInputs.map(i => i.value).join());
      if (tool) parameters.set("tool", tool);
      if (tool === "profile") parameters.set("width", String(profileWidth));
      if (picked.length) parameters.set("points", picked.map(p => p.texts.join()).join(";"));
      written = "#" + parameters.toString().replace(/%2C/g, ",").replace(/%3B/g, ";");
      history.replaceState(null, "", written);
    }, 200);
  }
  let written = "";
  function readLink() {
    const parameters = new URLSearchParams(location.hash.slice(1));
    const numbers = key => (parameters.get(key) ?? "").split(",").filter(t => t !== "").map(Number);
    coloring.fromParameters(parameters);
    choice.value = coloring.mode;
    look.sizeFactor = 2 ** Math.max(-2, Math.min(3, Number(parameters.get("size")) || 0));
    $("view-size").value = Math.log2(look.sizeFactor);
    setShaded(parameters.has("shading") ? parameters.get("shading") === "on" : !coloring.isRgb);
    if (parameters.has("camera")) camera.fromText(parameters.get("camera"));
    const ends = numbers("box"), place = (v, k) => (v - data.origin[k]) / (data.size[k] || 1);
    setBox(ends.length === 6 && ends.every(Number.isFinite)
      ? { low: ends.slice(0, 3).map(place), high: ends.slice(3).map(place) } : null);
    if (Number(parameters.get("width")) > 0) profileWidth = Number(parameters.get("width"));
    $("view-strip-width").value = Number(profileWidth.toPrecision(3));
    setTool(tools[parameters.get("tool")] ? parameters.get("tool") : "");
    const points = (parameters.get("points") ?? "").split(";").filter(t => t).map(t => t.split(","));
    if (tool && points.every(p => p.length === 3 && p.every(t => Number.isFinite(Number(t)))))
      picked = points.slice(0, tools[tool].most).map(p => placeOf(data, p));
    if (picked.length) describe();
    legend();
    recolor();
  }
  addEventListener("hashchange", () => { if (location.hash !== written) readLink(); });

  canvas.addEventListener("webglcontextlost", () => still("The graphics card was lost (reload the page)"));
  new ResizeObserver(redraw).observe(canvas);
  stage.classList.add("live");
  $("view-tools").disabled = false;
  if (steps > 1) showStep(data.path ? 0 : steps - 1);
  if (!data.path) camera.look(data.camera);
  readLink();
})();
