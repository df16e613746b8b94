// Shows the explanation of the item under the pointer or with the keyboard focus. A selected item keeps its explanation
// on screen, and only the items related to it stay bright. The page is complete without this script, because every item
// is also a link to its explanation.
"use strict";
(() => {
  const root = document.body;
  const explained = document.getElementById("explained");
  const tip = document.getElementById("tip");
  const items = [...document.querySelectorAll(".i")];
  const hint = [...explained.childNodes];
  const keysOf = (item) => item.dataset.k.split(" ");
  const byKey = new Map();   // Maps a key to the items that represent it or are related to it.
  const bySelf = new Map();  // Maps a key to the items that represent it.
  let selected = null;

  const add = (map, key, item) => map.has(key) ? map.get(key).push(item) : map.set(key, [item]);
  for (const item of items) {
    const keys = keysOf(item);
    add(bySelf, keys[0], item);
    for (const key of keys) add(byKey, key, item);
  }

  function show(key) {
    const article = key && document.getElementById(key);
    const nodes = article ? [...article.cloneNode(true).childNodes] : hint;
    explained.replaceChildren(...nodes);
    explained.classList.toggle("kept", key !== null && key === selected);
  }

  function mark() {
    for (const item of items) item.classList.remove("on", "near", "selected");
    root.classList.toggle("selecting", selected !== null);
    if (selected === null) return;
    const on = new Set(byKey.get(selected) ?? []);
    for (const self of bySelf.get(selected) ?? []) {
      self.classList.add("selected");
      for (const key of keysOf(self)) for (const item of bySelf.get(key) ?? []) on.add(item);
    }
    for (const item of on) {
      item.classList.add("on");
      if (!item.classList.contains("edge")) continue;
      for (const key of keysOf(item)) for (const end of bySelf.get(key) ?? []) end.classList.add("near");
    }
  }

  function select(key) {
    selected = key === null || key === selected || !document.getElementById(key) ? null : key;
    mark();
    show(selected);
  }

  function showTip(item, x, y) {
    tip.textContent = item.getAttribute("aria-label");
    tip.classList.add("shown");
    const width = tip.offsetWidth, height = tip.offsetHeight;
    const left = Math.max(8, Math.min(x + 14, innerWidth - width - 8));
    const top = y + 20 + height > innerHeight ? y - height - 12 : y + 20;
    tip.style.transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
  }
  const hideTip = () => tip.classList.remove("shown");

  const itemAt = (event) => event.target.closest?.(".i");
  root.addEventListener("pointerover", (event) => {
    const item = itemAt(event);
    if (!item) return;
    show(keysOf(item)[0]);
    showTip(item, event.clientX, event.clientY);
  });
  root.addEventListener("pointermove", (event) => {
    const item = itemAt(event);
    if (item) showTip(item, event.clientX, event.clientY);
  });
  root.addEventListener("pointerout", (event) => {
    if (!itemAt(event)) return;
    hideTip();
    show(selected);
  });
  root.addEventListener("focusin", (event) => {
    const item = itemAt(event);
    if (!item || !item.matches(":focus-visible")) return;
    show(keysOf(item)[0]);
    const box = item.getBoundingClientRect();
    showTip(item, box.left, box.bottom - 16);
  });
  root.addEventListener("focusout", () => {
    hideTip();
    show(selected);
  });
  root.addEventListener("click", (event) => {
    const link = event.target.closest?.("a[href^='#']");
    const key = link?.getAttribute("href").slice(1);
    if (!link || !bySelf.has(key)) return;
    // A link inside an explanation leads to another explanation, so it keeps its normal effect.
    if (link.closest("article")) return;
    event.preventDefault();
    select(key);
  });

  // The Tab key stops once per drawing or list. The arrow keys move the focus between the items in it.
  const groups = [...document.querySelectorAll("svg, .labels, tbody")].map((group) => [...group.querySelectorAll(".i:not(.title)")]);
  // The pass names above the columns represent the same passes as the boxes below. They get no Tab stop, so that each
  // pass is reached only once.
  for (const title of document.querySelectorAll(".title")) title.setAttribute("tabindex", "-1");
  for (const group of groups) group.forEach((item, index) => item.setAttribute("tabindex", index === 0 ? "0" : "-1"));
  const steps = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };
  root.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      hideTip();
      return select(null);
    }
    const item = itemAt(event);
    const group = item && groups.find((each) => each.includes(item));
    if (!group) return;
    const last = group.length - 1;
    const step = steps[event.key];
    const ends = { Home: 0, End: last };
    const to = step ? group.indexOf(item) + step : ends[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const next = group[Math.max(0, Math.min(to, last))];
    item.setAttribute("tabindex", "-1");
    next.setAttribute("tabindex", "0");
    next.focus();
    next.scrollIntoView({ block: "nearest", inline: "nearest" });
  });

  // All drawings with pass columns scroll sideways together, so that their columns stay aligned.
  const charts = [...document.querySelectorAll(".chart .scroll")];
  for (const chart of charts)
    chart.addEventListener("scroll", () => {
      for (const other of charts) if (other.scrollLeft !== chart.scrollLeft) other.scrollLeft = chart.scrollLeft;
    });

  // Zoom of the graph drawings: in and out around a point, to the width of the panel, or to the original size.
  const graph = document.getElementById("graph");
  const drawings = [...graph.querySelectorAll("svg")].map((svg) =>
    ({ svg, frame: svg.parentElement, width: svg.viewBox.baseVal.width, height: svg.viewBox.baseVal.height }));
  const controls = graph.querySelector(".zoom");
  const leastScale = 0.1, mostScale = 4, zoomStep = 1.25;
  // A drawing is first scaled to the width of the panel, but not below this scale, because its letters would
  // be too small to read.
  const leastLegible = 0.7;
  let scale = 1;

  function zoom(wanted, x, y) {
    const before = scale;
    scale = Math.min(mostScale, Math.max(Math.min(leastScale, fitting()), wanted));
    for (const { svg, frame, width, height } of drawings) {
      const left = x === undefined ? frame.clientWidth / 2 : x - frame.getBoundingClientRect().left;
      const top = y === undefined ? frame.clientHeight / 2 : y - frame.getBoundingClientRect().top;
      const atX = (frame.scrollLeft + left) / before, atY = (frame.scrollTop + top) / before;
      svg.setAttribute("width", width * scale);
      svg.setAttribute("height", height * scale);
      frame.scrollLeft = atX * scale - left;
      frame.scrollTop = atY * scale - top;
    }
    controls.querySelector("output").textContent = `${Math.round(scale * 100)} %`;
  }
  const shown = () => drawings.find(({ frame }) => frame.checkVisibility?.({ visibilityProperty: true }) ?? frame.clientHeight > 0);
  const fitting = () => {
    const drawing = shown();
    return drawing && drawing.frame.clientWidth > 0 ? drawing.frame.clientWidth / drawing.width : 1;
  };
  const zooms = { in: () => zoom(scale * zoomStep), out: () => zoom(scale / zoomStep), fit: () => zoom(fitting()), full: () => zoom(1) };
  const zoomKeys = { "+": "in", "=": "in", "-": "out", f: "fit", 0: "full" };
  // Minimum height in pixels of the scrollable area, so that a small drawing can still be dragged.
  const leastHeight = 120;
  if (drawings.length > 0) {
    controls.hidden = false;
    for (const { frame, height } of drawings) frame.style.minHeight = `${Math.min(height, leastHeight)}px`;
    controls.addEventListener("click", (event) => zooms[event.target.closest("button")?.dataset.zoom]?.());
    graph.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || !zoomKeys[event.key]) return;
      event.preventDefault();
      zooms[zoomKeys[event.key]]();
    });
    zoom(Math.min(1, Math.max(leastLegible, fitting())));
  }
  for (const { frame } of drawings) {
    frame.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      zoom(scale * zoomStep ** (-Math.sign(event.deltaY)), event.clientX, event.clientY);
    }, { passive: false });
    // Dragging empty space with the mouse scrolls the drawing.
    frame.addEventListener("pointerdown", (event) => {
      if (event.pointerType !== "mouse" || event.button !== 0 || event.target.closest("a")) return;
      const from = { x: event.clientX + frame.scrollLeft, y: event.clientY + frame.scrollTop };
      const drag = (moved) => frame.scrollTo(from.x - moved.clientX, from.y - moved.clientY);
      frame.setPointerCapture(event.pointerId);
      frame.classList.add("held");
      frame.addEventListener("pointermove", drag);
      frame.addEventListener("lostpointercapture", () => {
        frame.classList.remove("held");
        frame.removeEventListener("pointermove", drag);
      }, { once: true });
    });
  }

  // The "+" link of a repeat opens the drawing that shows all iterations, instead of the drawing that shows the repeat
  // as one box.
  const rounds = graph.querySelector("details.rounds");
  for (const opener of graph.querySelectorAll(".open"))
    opener.addEventListener("click", (event) => {
      event.preventDefault();
      rounds.open = true;
      rounds.querySelector("summary").focus();
      rounds.scrollIntoView({ block: "nearest" });
    });

  const fromAddress = () => {
    const key = location.hash.slice(1);
    if (bySelf.has(key)) selected = null, select(key);
  };
  addEventListener("hashchange", fromAddress);
  fromAddress();
})();
