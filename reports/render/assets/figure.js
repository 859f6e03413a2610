// A figure opened by itself or on request in its page: values under the pointer, series that can be switched off, films.
// The file says what it shows: data-figure, data-panel, data-series, data-key, data-frame (panels.py, figures.py).
(() => {
  const svg = document.documentElement, about = JSON.parse(svg.dataset.figure);
  const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
  svg.setAttribute("width", "100%");
  svg.setAttribute("height", "100%");
  const made = (name, attributes, above = svg) => {
    const one = document.createElementNS(svg.namespaceURI, name);
    for (const [key, value] of Object.entries(attributes)) one.setAttribute(key, value);
    return above.appendChild(one);
  };
  const shown = group => group.style.display !== "none" && group.getAttribute("display") !== "none";

  // Series: their keys in the legend are buttons.
  for (const key of svg.querySelectorAll("[data-key]")) {
    const groups = svg.querySelectorAll(`[data-series="${key.dataset.key}"]`);
    const box = key.getBBox();
    made("rect", {...Object.fromEntries(["x", "y", "width", "height"].map(name => [name, box[name]])), fill: "transparent"}, key);
    for (const [name, value] of Object.entries({role: "button", tabindex: 0, "aria-pressed": true,
                                                "aria-label": about.labels[key.dataset.key]})) key.setAttribute(name, value);
    key.style.cursor = "pointer";
    const toggle = () => {
      const on = key.getAttribute("aria-pressed") !== "true";
      key.setAttribute("aria-pressed", on);
      key.style.opacity = on ? 1 : .45;
      for (const group of groups) group.style.display = on ? "" : "none";
    };
    key.addEventListener("click", toggle);
    key.addEventListener("keydown", event => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      toggle();
    });
  }

  // Values: of the vertex nearest to the pointer, or of the pointer where no series is near.
  const reading = made("g", {visibility: "hidden", "pointer-events": "none"});
  const dot = made("circle", {r: 3, fill: "none", stroke: "#b3261e", "stroke-width": 1.2}, reading);
  const paper = made("rect", {fill: "#fff", opacity: .9, height: 15}, reading);
  const words = made("text", {"font-size": 11, "font-family": "serif", fill: "#1d1d1b", role: "status"}, reading);
  const vertices = new Map();
  const verticesOf = group => {
    if (!vertices.has(group)) {
      const numbers = [...group.querySelectorAll("path, use")].filter(one => !one.closest("defs, marker")).flatMap(
        one => (one.localName === "use" ? `${one.getAttribute("x")} ${one.getAttribute("y")}` : one.getAttribute("d"))
          .match(/-?[\d.]+/g)?.map(Number) ?? []);
      vertices.set(group, numbers);
    }
    return vertices.get(group);
  };
  const value = (panel, place, axis) => {
    const share = axis ? 1 - (place - panel.box[1]) / panel.box[3] : (place - panel.box[0]) / panel.box[2];
    const [low, high] = panel["xy"[axis]], log = panel.log[axis];
    const at = log ? 10 ** (Math.log10(low) + share * Math.log10(high / low)) : low + share * (high - low);
    const digits = Math.max(0, 2 - Math.floor(Math.log10((log ? at : high - low) || 1)));
    return String(Number(at.toFixed(Math.min(digits, 12))));
  };
  const read = (x, y) => {
    const number = about.panels.findIndex(one => one && x >= one.box[0] && x <= one.box[0] + one.box[2]
                                                 && y >= one.box[1] && y <= one.box[1] + one.box[3]);
    reading.setAttribute("visibility", number < 0 ? "hidden" : "visible");
    if (number < 0) return;
    let nearest = {far: 30 ** 2, x, y, label: ""};
    for (const group of svg.querySelectorAll(`[data-panel="${number}"] [data-series]:not([data-area])`)) {
      if (!shown(group)) continue;
      const numbers = verticesOf(group);
      for (let n = 0; n + 1 < numbers.length; n += 2) {
        const far = (numbers[n] - x) ** 2 + (numbers[n + 1] - y) ** 2;
        if (far < nearest.far) nearest = {far, x: numbers[n], y: numbers[n + 1], label: about.labels[group.dataset.series].trim()};
      }
    }
    const panel = about.panels[number];
    words.textContent = `${nearest.label ? nearest.label + ": " : ""}${value(panel, nearest.x, 0)}, ${value(panel, nearest.y, 1)}`;
    dot.setAttribute("cx", nearest.x);
    dot.setAttribute("cy", nearest.y);
    const long = words.getComputedTextLength();
    const left = Math.min(nearest.x + 6, width - long - 4), above = Math.max(nearest.y - 7, 12);
    words.setAttribute("x", left);
    words.setAttribute("y", above);
    for (const [name, at] of [["x", left - 2], ["y", above - 11], ["width", long + 4]]) paper.setAttribute(name, at);
  };
  svg.addEventListener("pointermove", event => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    read(at.x, at.y);
  });
  svg.addEventListener("pointerleave", () => reading.setAttribute("visibility", "hidden"));

  // Films: one instant at a time, played on request.
  const frames = [...svg.querySelectorAll("[data-frame]")];
  if (!frames.length) return;
  const last = Math.max(...frames.map(one => Number(one.dataset.frame)));
  const place = made("foreignObject", {x: 0, y: height - 22, width, height: 22});
  const html = (name, attributes) => {
    const one = document.createElementNS("http://www.w3.org/1999/xhtml", name);
    Object.assign(one, attributes);
    one.style.cssText = "vertical-align: middle; margin: 0 4px; height: 18px; font: 12px serif";
    return place.appendChild(one);
  };
  const button = html("button", {textContent: "Play"});
  const slider = html("input", {type: "range", min: 0, max: last, value: frames.find(shown)?.dataset.frame ?? 0, ariaLabel: "Instant"});
  slider.style.width = "60%";
  const show = () => {
    for (const one of frames) one.setAttribute("display", one.dataset.frame === slider.value ? "inline" : "none");
  };
  let playing = 0;
  const play = on => {
    clearInterval(playing);
    playing = on ? setInterval(() => {
      slider.value = Number(slider.value) < last ? Number(slider.value) + 1 : 0;
      show();
    }, 200) : 0;
    button.textContent = on ? "Stop" : "Play";
  };
  button.addEventListener("click", () => play(!playing));
  slider.addEventListener("input", () => { play(false); show(); });
  if (location.hash === "#play" && !matchMedia("(prefers-reduced-motion: reduce)").matches) {
    slider.value = 0;
    play(true);
  }
})();
