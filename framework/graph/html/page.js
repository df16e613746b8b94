// What is pointed at or focused is explained; what is selected stays explained, and what it has to do with stays bright.
// The page is complete without this script: every item links to its explanation.
"use strict";
(() => {
  const root = document.body;
  const explained = document.getElementById("explained");
  const tip = document.getElementById("tip");
  const items = [...document.querySelectorAll(".i")];
  const hint = [...explained.childNodes];
  const keysOf = (item) => item.dataset.k.split(" ");
  const byKey = new Map();  // key -> items that stand for it or belong to it
  const bySelf = new Map();  // key -> items that stand for it
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
    if (link.closest("article")) return;  // in the text, links lead to text
    event.preventDefault();
    select(key);
  });

  // One stop of the Tab key for each drawing or list; arrow keys lead from item to item in it.
  const groups = [...document.querySelectorAll("svg, .labels, tbody")].map((group) => [...group.querySelectorAll(".i:not(.title)")]);
  // The names above the columns stand for the same passes as the boxes below them.
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

  // Drawings that share their columns scroll together.
  const charts = [...document.querySelectorAll(".chart .scroll")];
  for (const chart of charts)
    chart.addEventListener("scroll", () => {
      for (const other of charts) if (other.scrollLeft !== chart.scrollLeft) other.scrollLeft = chart.scrollLeft;
    });

  const fromAddress = () => {
    const key = location.hash.slice(1);
    if (bySelf.has(key)) selected = null, select(key);
  };
  addEventListener("hashchange", fromAddress);
  fromAddress();
})();
