#!/usr/bin/python3
"""Opens pages of `weft plan --format html` in headless Chromium and uses them as a person does: with pointer and
keyboard, in light and dark colours. Prints every fault, and fails if there is one.
  page_in_chromium.py FOLDER PAGE.html...     screenshots are written to FOLDER
Needs the Debian packages chromium and python3-websocket."""
import base64
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.request

import websocket

START_S = 600
ANSWER_S = 600


class Browser:
    """One tab of the browser, controlled with the DevTools protocol."""

    def __init__(self):
        self.folder = tempfile.mkdtemp(prefix="weft-chromium-")
        self.process = subprocess.Popen(
            ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--hide-scrollbars",
             "--remote-debugging-port=0", "--remote-allow-origins=*", "--user-data-dir=" + self.folder, "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, "HOME": self.folder})
        self.socket = websocket.create_connection(self.address(), timeout=ANSWER_S)
        self.next_id = 0
        self.complaints = []
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")

    def address(self):
        end = time.monotonic() + START_S
        while time.monotonic() < end:
            try:
                port = pathlib.Path(self.folder, "DevToolsActivePort").read_text().splitlines()[0]
                with urllib.request.urlopen(f"http://127.0.0.1:{port}/json/list") as answer:
                    pages = [target for target in json.load(answer) if target["type"] == "page"]
                if pages:
                    return pages[0]["webSocketDebuggerUrl"]
            except (OSError, IndexError, ValueError):
                pass
            time.sleep(0.1)
        raise RuntimeError("chromium did not start")

    def hear(self, message):
        method, values = message.get("method"), message.get("params", {})
        if method == "Runtime.exceptionThrown":
            self.complaints.append("exception: " + json.dumps(values["exceptionDetails"])[:500])
        if method == "Runtime.consoleAPICalled" and values["type"] in ("error", "warning", "assert"):
            self.complaints.append("console: " + json.dumps(values["args"])[:500])
        if method == "Log.entryAdded" and values["entry"]["level"] in ("error", "warning"):
            self.complaints.append("log: " + values["entry"]["text"])
        if method == "Network.requestWillBeSent" and not values["request"]["url"].startswith("file:"):
            self.complaints.append("request: " + values["request"]["url"])
        return method

    def call(self, method, **values):
        self.next_id += 1
        self.socket.send(json.dumps({"id": self.next_id, "method": method, "params": values}))
        while True:
            message = json.loads(self.socket.recv())
            self.hear(message)
            if message.get("id") == self.next_id:
                if "error" in message:
                    raise RuntimeError(method + ": " + json.dumps(message["error"]))
                return message["result"]

    def open(self, path):
        self.call("Page.navigate", url=pathlib.Path(path).resolve().as_uri())
        while self.hear(json.loads(self.socket.recv())) != "Page.loadEventFired":
            pass

    def value(self, script):
        result = self.call("Runtime.evaluate", expression=script, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(script + ": " + json.dumps(result["exceptionDetails"])[:500])
        return result["result"].get("value")

    def key(self, name):
        code = {"Tab": 9, "Enter": 13, "Escape": 27, "End": 35, "ArrowRight": 39, "f": 70, "0": 48, "+": 187, "-": 189}[name]
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=name, code=name, windowsVirtualKeyCode=code,
                      **({"text": "\r"} if name == "Enter" and kind == "keyDown" else {}))

    def point_at(self, x, y, click=False):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        for kind in ("mousePressed", "mouseReleased") if click else ():
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def wheel(self, x, y, up):
        self.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=-100 if up else 100, modifiers=2)

    def drag(self, x, y, by_x, by_y):
        self.call("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", clickCount=1)
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + by_x, y=y + by_y, button="left", buttons=1)
        self.call("Input.dispatchMouseEvent", type="mouseReleased", x=x + by_x, y=y + by_y, button="left", clickCount=1)

    def look(self, scheme, width_px, height_px):
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        self.call("Emulation.setDeviceMetricsOverride", width=width_px, height=height_px, deviceScaleFactor=1, mobile=False)

    def screenshot(self, path):
        picture = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        pathlib.Path(path).write_bytes(picture)
        return picture

    def close(self):
        self.socket.close()
        self.process.terminate()
        self.process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


# JavaScript that scrolls to an item and returns a point where no other item covers it.
SPOT = """(() => { const item = document.querySelector(%s); if (!item) return null;
  item.scrollIntoView({ block: "center", inline: "center" });
  const box = item.getBoundingClientRect(), way = item.querySelector("path.hit"), spots = [];
  for (let i = 1; i < 20; ++i) { if (!way) break;
    const at = way.getPointAtLength(way.getTotalLength() * i / 20).matrixTransform(way.getScreenCTM());
    spots.push([at.x, at.y]); }
  for (let i = 1; i < 20; ++i) for (let k = 1; k < 20; ++k) spots.push([box.x + box.width * k / 20, box.y + box.height * i / 20]);
  return spots.find(([x, y]) => document.elementFromPoint(x, y)?.closest(".i") === item) ?? "covered"; })()"""
SPOT_OF_OPENER = """(() => { const opener = document.querySelector("#graph .open"); if (!opener) return null;
  opener.scrollIntoView({ block: "center" }); const at = opener.getBoundingClientRect(); return [at.x + at.width / 2, at.y + at.height / 2]; })()"""
# JavaScript for the text of an article, and for the text of the explanation, both without white space.
ARTICLE = '(document.getElementById(%s)?.textContent ?? "none").replace(/\\s+/g, "")'
EXPLAINED = 'document.getElementById("explained").textContent.replace(/\\s+/g, "")'
# JavaScript that returns the texts which extend beyond their box or drawing.
STICKS_OUT = """(() => { const out = [];
  for (const item of document.querySelectorAll("svg .pass, svg .batch, svg .block, svg .cell")) {
    const box = item.querySelector(".box, .mark").getBBox();
    for (const text of item.querySelectorAll("text")) { const t = text.getBBox();
      if (t.x < box.x || t.x + t.width > box.x + box.width || t.y < box.y - 1 || t.y + t.height > box.y + box.height + 2)
        out.push(text.textContent + " of " + item.getAttribute("aria-label")); } }
  for (const svg of document.querySelectorAll("#graph svg")) {
    const boxes = [...svg.querySelectorAll(".pass .box")].map((box) => box.getBBox());
    for (const name of svg.querySelectorAll(".edgename")) { const t = name.getBBox();
      if (boxes.some((b) => t.x < b.x + b.width && b.x < t.x + t.width && t.y < b.y + b.height && b.y < t.y + t.height))
        out.push(name.textContent + " on an edge covers a box"); } }
  for (const svg of document.querySelectorAll("svg")) { const whole = svg.getBoundingClientRect();
    for (const text of svg.querySelectorAll("text")) { const t = text.getBoundingClientRect();
      if (t.left < whole.left - 1 || t.right > whole.right + 1 || t.top < whole.top - 1 || t.bottom > whole.bottom + 1)
        out.push(text.textContent + " leaves its drawing"); } }
  return out; })()"""
# JavaScript that returns the names of edges which do not lie on their edge, or which another edge crosses.
STRAY_NAMES = """(() => { const out = [];
  const text = (edge) => edge.querySelector(".edgename")?.textContent ?? edge.getAttribute("aria-label").split(": ").pop();
  for (const svg of document.querySelectorAll("#graph svg")) {
    const edges = [...svg.querySelectorAll(".edge")].map((edge) => { const way = edge.querySelector(".line"), spots = [];
      for (let at = 0; at <= way.getTotalLength(); at += 2) spots.push(way.getPointAtLength(at));
      return { edge, spots, resources: text(edge).split(",")[0].split(" ")[0] }; });
    for (const { edge, spots, resources } of edges) { const name = edge.querySelector(".edgename"); if (!name) continue;
      const box = name.getBBox(), inside = (p) => p.x > box.x && p.x < box.x + box.width && p.y > box.y && p.y < box.y + box.height;
      if (!spots.some(inside)) out.push("the name " + name.textContent + " of " + edge.getAttribute("aria-label") + " lies off its edge");
      for (const other of edges) if (other.resources !== resources && other.spots.some(inside))
        out.push(other.edge.getAttribute("aria-label") + " runs through the name " + name.textContent); } }
  return out; })()"""
# JavaScript that returns the queues which have a row in the timeline but no submission.
EMPTY_ROWS = """(() => { const rows = [...document.querySelectorAll("#timeline .lanes li")];
  const batches = [...document.querySelectorAll("#timeline .batch .box")].map((box) => box.getBoundingClientRect());
  return rows.filter((row) => { const at = row.getBoundingClientRect();
    return !batches.some((b) => b.top < at.bottom && at.top < b.bottom); }).map((row) => row.textContent); })()"""
# JavaScript that returns the items which the explanation at the bottom of the page covers.
COVERED = """(() => { const bar = document.getElementById("inspector"), at = bar.getBoundingClientRect(), found = new Set();
  bar.style.visibility = "hidden";
  for (let x = at.left + 5; x < Math.min(at.right, innerWidth); x += 20)
    for (let y = at.top + 5; y < Math.min(at.bottom, innerHeight); y += 10)
      for (const part of document.elementsFromPoint(x, y)) { const of = part.closest("section, header"); if (of) found.add(of.id || "the header"); }
  bar.style.visibility = "";
  return [...found]; })()"""
# JavaScript for the number of visible boxes of passes in the graph.
BOXES = """[...document.querySelectorAll("#graph .pass .box")].filter((box) => box.checkVisibility({ visibilityProperty: true })).length"""
SCALE = """(() => { const svg = document.querySelector("#graph svg"); return svg.getBoundingClientRect().width / svg.viewBox.baseVal.width; })()"""
SMALLEST = """Math.min(...[...document.querySelectorAll("body *")].filter((e) => e.childNodes.length && e.innerText !== "")
  .map((e) => parseFloat(getComputedStyle(e).fontSize)))"""


def check_hover(browser, faults, style):
    """Moves the pointer over the first item of this kind. The page must show the explanation of the item."""
    selector = json.dumps(f"svg .i.{style}")
    spot = browser.value(SPOT % selector)
    if spot is None:
        return False
    if spot == "covered":
        faults.append(f"no pointer reaches the first {style}")
        return True
    browser.point_at(*spot)
    key = browser.value(f"document.querySelector({selector}).dataset.k.split(' ')[0]")
    if browser.value(EXPLAINED) != browser.value(ARTICLE % json.dumps(key)):
        faults.append(f"a pointer over {key} ({style}) does not explain it")
    if not browser.value('document.getElementById("tip").classList.contains("shown")'):
        faults.append(f"a pointer over {key} ({style}) shows no tip")
    if not browser.value(f'document.getElementById("tip").textContent === document.querySelector({selector}).ariaLabel'):
        faults.append(f"the tip of {key} ({style}) does not say what its label does")
    browser.point_at(1, 1)
    return True


def check_keyboard(browser, faults):
    """Uses the keyboard: Tab and arrows reach a barrier and show its explanation. Enter selects, Escape deselects."""
    for _ in range(60):
        browser.key("Tab")
        if browser.value('!!document.activeElement.closest("#timeline svg")'):
            break
    for _ in range(400):
        if browser.value('document.activeElement.classList.contains("barrier")'):
            break
        browser.key("ArrowRight")
    key = browser.value("document.activeElement.dataset.k?.split(' ')[0]") or ""
    if not key.startswith("b"):
        faults.append("the keyboard reaches no barrier, but " + key)
        return
    if browser.value(EXPLAINED) != browser.value(ARTICLE % json.dumps(key)):
        faults.append(f"{key} in focus is not explained")
    if browser.value('getComputedStyle(document.activeElement.querySelector(".mark")).strokeWidth') == "1px":
        faults.append(f"{key} in focus looks as if it weren't")
    browser.key("Enter")
    if not browser.value('document.body.classList.contains("selecting")'):
        faults.append(f"Enter does not select {key}")
    browser.key("Escape")
    if browser.value('document.body.classList.contains("selecting")'):
        faults.append("Escape does not let go")


def check_selection(browser, faults, folder, name):
    """Clicks on a pass. In all panels, only related items must remain bright."""
    spot = browser.value(SPOT % json.dumps("#timeline svg .pass"))
    if spot is None:
        return
    browser.point_at(*spot, click=True)
    browser.point_at(1, 1)
    key = browser.value("document.querySelector('#timeline svg .pass').dataset.k.split(' ')[0]")
    wrong = browser.value(
        "[...document.querySelectorAll('.i')].filter((e) => e.dataset.k.split(' ').includes('%s') && "
        "!e.classList.contains('on')).length" % key)
    if wrong:
        faults.append(f"{wrong} items of {key} are not bright when it is selected")
    browser.value("scrollTo(0, 0)")
    browser.screenshot(f"{folder}/{name}-selected.png")
    browser.key("Escape")


def check_zoom(browser, faults):
    """Changes the size of the graph with buttons, keys and the wheel, and moves the graph with the mouse."""
    def expect(what, good):
        if not good:
            faults.append(f"{what}: the graph is drawn at {browser.value(SCALE):.2f}")

    button = 'document.querySelector("#graph [data-zoom=%s]")'
    if not browser.value(f'!!{button % "fit"} && document.querySelector("#graph .zoom").checkVisibility()'):
        faults.append("nothing changes the size of the graph")
        return
    browser.value('document.getElementById("graph").scrollIntoView()')
    browser.value(f'{button % "full"}.click()')
    expect("100 %", abs(browser.value(SCALE) - 1) < 0.01)
    browser.value(f'{button % "fit"}.click()')
    fit = browser.value(SCALE)
    expect("fit", browser.value('(() => { const f = document.querySelector("#graph .scroll"); return f.scrollWidth <= f.clientWidth + 1; })()'))
    browser.value('document.querySelector("#graph svg .i").focus()')
    for key, good in (("0", lambda now: abs(now - 1) < 0.01), ("+", lambda now: now > 1.1), ("-", lambda now: abs(now - 1) < 0.01),
                      ("f", lambda now: abs(now - fit) < 0.01)):
        browser.key(key)
        expect("key " + key, good(browser.value(SCALE)))
    x, y = browser.value('(() => { const at = document.querySelector("#graph .scroll").getBoundingClientRect();'
                         ' return [at.left + at.width / 2, at.top + 10]; })()')
    browser.wheel(x, y, up=True)
    browser.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    expect("Ctrl and the wheel", abs(browser.value(SCALE) / fit - 1.25) < 0.02)
    browser.value("scrollTo(0, 0)")
    browser.value(f'{button % "full"}.click(); for (let i = 0; i < 4; ++i) {button % "in"}.click(); document.querySelector("#graph .scroll").scrollTo(0, 0);'
                  'document.getElementById("graph").scrollIntoView()')
    x, y = browser.value('(() => { const at = document.querySelector("#graph .scroll").getBoundingClientRect(); return [at.left + 200, at.top + 4]; })()')
    browser.drag(x, y, -50, 0)
    if browser.value('document.querySelector("#graph .scroll").scrollLeft') < 40:
        faults.append("the mouse does not drag the graph")


def check_repeats(browser, faults):
    """Checks that a repeat of many iterations is drawn as one box, and that a click on its square expands the box."""
    rounds = browser.value('new Set([...document.querySelectorAll("#timeline .pass")].map((e) => e.dataset.k.split(" ")[0])).size')
    folded = browser.value(BOXES)
    if folded > 40 and browser.value('[...document.querySelectorAll("#timeline .title")].filter((e) => e.ariaLabel.includes("#")).length') > 40:
        faults.append(f"the rounds of repeats fill the graph: {folded} boxes")
    spot = browser.value(SPOT_OF_OPENER)
    if spot:
        browser.point_at(*spot, click=True)
        if browser.value(BOXES) < rounds:
            faults.append(f"an open repeat shows {browser.value(BOXES)} boxes of {rounds} passes")


def check_without_script(browser, path, faults):
    """Checks the page without scripts: drawings must be complete, and no control may be shown that needs a script."""
    browser.call("Emulation.setScriptExecutionDisabled", value=True)
    browser.open(path)
    if browser.value('document.querySelector("#graph .zoom")?.checkVisibility() ?? false'):
        faults.append("without a script there are buttons that do nothing")
    if abs(browser.value(SCALE) - 1) > 0.01:
        faults.append("without a script the graph has another size")
    browser.call("Emulation.setScriptExecutionDisabled", value=False)


def check_page(browser, path, folder):
    faults = []
    name = pathlib.Path(path).stem
    pictures = set()
    for scheme, width_px, height_px in (("light", 1440, 2400), ("dark", 1440, 2400), ("light", 800, 1200)):
        browser.look(scheme, width_px, height_px)
        browser.open(path)
        if browser.value("document.documentElement.scrollWidth > innerWidth"):
            faults.append(f"the page is wider than {width_px} px")
        faults += [f"at {width_px} px: {text}" for text in browser.value(STICKS_OUT)[:5]]
        for end in ("0", "1e6"):
            browser.value(f"for (const e of [document.scrollingElement, document.getElementById('content')]) e?.scrollTo(0, {end})")
            faults += [f"at {width_px} px the explanation covers {part}" for part in browser.value(COVERED)]
        browser.value("for (const e of [document.scrollingElement, document.getElementById('content')]) e?.scrollTo(0, 0)")
        picture = browser.screenshot(f"{folder}/{name}-{scheme}-{width_px}.png")
        if len(picture) < 20000:
            faults.append(f"the picture in {scheme} of {width_px} px is empty")
        pictures.add(picture)
    if len(pictures) != 3:
        faults.append("light and dark look the same")
    if browser.value(SMALLEST) < 11:
        faults.append("text is smaller than 11 px")
    faults += browser.value(STRAY_NAMES)[:5]
    faults += [f"a row for a queue without work: {row}" for row in browser.value(EMPTY_ROWS)]
    browser.look("light", 1440, 1000)
    check_without_script(browser, path, faults)
    browser.open(path)
    check_zoom(browser, faults)
    browser.open(path)
    check_repeats(browser, faults)
    browser.open(path)
    seen = [style for style in ("pass", "edge", "barrier", "wait", "batch", "cell", "life", "block", "alive")
            if check_hover(browser, faults, style)]
    if "barrier" in seen:
        browser.open(path)
        check_keyboard(browser, faults)
    check_selection(browser, faults, folder, name)
    faults += browser.complaints
    browser.complaints = []
    print(f"{name}: {', '.join(seen)}: " + ("good" if not faults else f"{len(faults)} faults"))
    for fault in faults:
        print("  " + fault)
    return not faults


def main():
    browser = Browser()
    try:
        good = [check_page(browser, page, sys.argv[1]) for page in sys.argv[2:]]
    finally:
        browser.close()
    return 0 if good and all(good) else 1


sys.exit(main())
