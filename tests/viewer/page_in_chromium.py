#!/usr/bin/python3
"""Opens pages of `weft plan --format html` in headless Chromium and uses them as a person does: with pointer, keyboard,
in light and dark. Prints what is wrong and fails when something is.
  page_in_chromium.py FOLDER PAGE.html...     FOLDER gets the screenshots
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

START_S = 30
ANSWER_S = 30


class Browser:
    """One tab, spoken to by the DevTools protocol."""

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
        code = {"Tab": 9, "Enter": 13, "Escape": 27, "End": 35, "ArrowRight": 39}[name]
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=name, code=name, windowsVirtualKeyCode=code,
                      **({"text": "\r"} if name == "Enter" and kind == "keyDown" else {}))

    def point_at(self, x, y, click=False):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        for kind in ("mousePressed", "mouseReleased") if click else ():
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

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


# Scrolls an item into view and finds a point where it lies on top.
SPOT = """(() => { const item = document.querySelector(%s); if (!item) return null;
  item.scrollIntoView({ block: "center", inline: "center" });
  const box = item.getBoundingClientRect(), way = item.querySelector("path.hit"), spots = [];
  for (let i = 1; i < 20; ++i) { if (!way) break;
    const at = way.getPointAtLength(way.getTotalLength() * i / 20).matrixTransform(way.getScreenCTM());
    spots.push([at.x, at.y]); }
  for (let i = 1; i < 20; ++i) for (let k = 1; k < 20; ++k) spots.push([box.x + box.width * k / 20, box.y + box.height * i / 20]);
  return spots.find(([x, y]) => document.elementFromPoint(x, y)?.closest(".i") === item) ?? "covered"; })()"""
# The text of an article and of what is explained, without blanks.
ARTICLE = '(document.getElementById(%s)?.textContent ?? "none").replace(/\\s+/g, "")'
EXPLAINED = 'document.getElementById("explained").textContent.replace(/\\s+/g, "")'
# Words that stick out of their box, or of their drawing.
STICKS_OUT = """(() => { const out = [];
  for (const item of document.querySelectorAll("svg .pass, svg .batch, svg .block, svg .cell")) {
    const box = item.querySelector(".box, .mark").getBBox();
    for (const text of item.querySelectorAll("text")) { const t = text.getBBox();
      if (t.x < box.x || t.x + t.width > box.x + box.width || t.y < box.y - 1 || t.y + t.height > box.y + box.height + 2)
        out.push(text.textContent + " of " + item.getAttribute("aria-label")); } }
  const boxes = [...document.querySelectorAll("#graph .pass .box")].map((box) => box.getBBox());
  for (const name of document.querySelectorAll("#graph .edgename")) { const t = name.getBBox();
    if (boxes.some((b) => t.x < b.x + b.width && b.x < t.x + t.width && t.y < b.y + b.height && b.y < t.y + t.height))
      out.push(name.textContent + " beside an edge covers a box"); }
  for (const svg of document.querySelectorAll("svg")) { const whole = svg.getBoundingClientRect();
    for (const text of svg.querySelectorAll("text")) { const t = text.getBoundingClientRect();
      if (t.left < whole.left - 1 || t.right > whole.right + 1 || t.top < whole.top - 1 || t.bottom > whole.bottom + 1)
        out.push(text.textContent + " leaves its drawing"); } }
  return out; })()"""
SMALLEST = """Math.min(...[...document.querySelectorAll("body *")].filter((e) => e.childNodes.length && e.innerText !== "")
  .map((e) => parseFloat(getComputedStyle(e).fontSize)))"""


def check_hover(browser, faults, style):
    """A pointer over the first item of this kind explains it."""
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
    """Tab and arrows reach a barrier, which is explained; Enter selects it, Escape lets it go."""
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
    """A click on a pass keeps what belongs to it bright in all panels, and nothing else."""
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
        picture = browser.screenshot(f"{folder}/{name}-{scheme}-{width_px}.png")
        if len(picture) < 20000:
            faults.append(f"the picture in {scheme} of {width_px} px is empty")
        pictures.add(picture)
    if len(pictures) != 3:
        faults.append("light and dark look the same")
    if browser.value(SMALLEST) < 11:
        faults.append("text is smaller than 11 px")
    browser.look("light", 1440, 1000)
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
