"""Opens pages of `tribodyn report` in headless Chromium and fails on what a reader would see go wrong.

Usage: python3 report_page.py [--browser PROGRAM] [--pictures DIR] REPORT.html ...

Python's standard library and Chromium are all it needs: the browser is driven by its DevTools protocol over a pair of pipes.
Each page is opened 1280 and 400 px wide, light and dark, with scripts and without, and as print. Failures are errors of the
console, requests to anywhere else, a page wider than its window, clipped text, text without contrast, drawings without size and
charts without drawn pixels; with scripts also false numbers at the ticks of an axis, a cursor without read-out, and zoom, reset and legends that change nothing.
"""

import argparse
import base64
import fcntl
import json
import os
import select
import subprocess
import sys
import tempfile
import time
from pathlib import Path

DEADLINE_S = 60.0
WIDTHS = [1280, 400]

# What can be seen wrong in the page as it stands; a list of sentences.
LOOK = r"""
(scripts => {
  const wrong = [], round = Math.round;
  const name = e => e.closest("figure")?.id || e.closest("section")?.querySelector("h2")?.id || e.tagName.toLowerCase();
  const short = t => JSON.stringify(t.trim().slice(0, 40));
  const shown = e => e.checkVisibility({ visibilityProperty: true, opacityProperty: true }) && e.getClientRects().length > 0;
  const wide = document.documentElement.scrollWidth, window_ = document.documentElement.clientWidth;
  if (wide > window_) wrong.push(`the page is ${wide} px wide in a window of ${window_} px`);

  // Contrast after WCAG 2: 4.5 for text.
  const rgb = c => { const m = c.match(/[\d.]+/g).map(Number); return { v: m.slice(0, 3), a: m.length > 3 ? m[3] : 1 }; };
  const linear = c => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  const luminance = v => 0.2126 * linear(v[0]) + 0.7152 * linear(v[1]) + 0.0722 * linear(v[2]);
  const ground = e => { for (; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor); if (c.a > 0.5) return c.v; } return [255, 255, 255]; };
  const contrast = (a, b) => { const [x, y] = [luminance(a), luminance(b)].sort((p, q) => q - p); return (x + 0.05) / (y + 0.05); };

  // Boxes that scroll by themselves show what they hide.
  const scrolls = e => { for (; e && e !== document.body; e = e.parentElement) { const o = getComputedStyle(e).overflowX; if (o === "auto" || o === "scroll") return true; } return false; };
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const clipped = new Map();
  for (let node; (node = walker.nextNode());) {
    const e = node.parentElement;
    if (!node.data.trim() || ["SCRIPT", "STYLE", "NOSCRIPT", "title", "desc"].includes(e.tagName) || !shown(e)) continue;
    const svg = e.closest("svg");
    const range = document.createRange();
    range.selectNodeContents(node);
    const box = svg ? e.getBoundingClientRect() : range.getBoundingClientRect();
    const style = getComputedStyle(e);
    const ratio = contrast(rgb(svg ? style.fill : style.color).v, ground(svg ?? e));
    if (ratio < 4.5) clipped.set(`${name(e)}: contrast ${ratio.toFixed(1)} of text ${short(node.data)}`, 1);
    if (svg) {
      const frame = svg.getBoundingClientRect();
      if (box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1)
        clipped.set(`${name(e)}: text ${short(node.data)} is cut off by the edge of its drawing`, 1);
      const size = parseFloat(style.fontSize) * frame.width / svg.viewBox.baseVal.width;
      if (size < 8 && e.tagName !== "tspan") clipped.set(`${name(e)}: text of ${size.toFixed(1)} px in a drawing`, 1);
    } else {
      if ((box.left < -1 || box.right > window_ + 1) && !scrolls(e)) clipped.set(`${name(e)}: text ${short(node.data)} leaves the window`, 1);
      for (let p = e; p && p !== document.body; p = p.parentElement) {
        if (getComputedStyle(p).overflowX !== "hidden") continue;
        const frame = p.getBoundingClientRect();
        if (box.right > frame.right + 1 || box.left < frame.left - 1) clipped.set(`${name(e)}: text ${short(node.data)} is clipped`, 1);
      }
    }
  }
  wrong.push(...clipped.keys());

  let drawings = 0, charts = 0;
  for (const figure of document.querySelectorAll("figure")) {
    let seen = 0;
    for (const svg of figure.querySelectorAll("svg")) {
      if (!shown(svg)) continue;
      seen += 1; drawings += 1;
      const box = svg.getBoundingClientRect();
      if (box.width < 100 || box.height < 100) wrong.push(`${figure.id}: a drawing of ${round(box.width)} by ${round(box.height)} px`);
      if (![...svg.querySelectorAll("path, rect")].some(p => { const b = p.getBBox(); return b.width > 0 && b.height > 0 && p.getAttribute("fill") !== "#FFFFFF"; }))
        wrong.push(`${figure.id}: nothing is drawn`);
    }
    for (const canvas of figure.querySelectorAll("canvas")) {
      if (!shown(canvas)) continue;
      seen += 1; charts += 1;
      const { width, height } = canvas;
      if (width < 100 || height < 60) { wrong.push(`${figure.id}: a chart of ${width} by ${height} px`); continue; }
      const pixels = canvas.getContext("2d").getImageData(0, 0, width, height).data;
      let coloured = 0, edge = 0;
      for (let i = 0, p = 0; i < pixels.length; i += 4, p += 1) {
        if (pixels[i + 3] < 40) continue;
        const [r, g, b] = [pixels[i], pixels[i + 1], pixels[i + 2]];
        if (Math.max(r, g, b) - Math.min(r, g, b) > 60) coloured += 1;
        const x = p % width, y = (p / width) | 0;
        if (x === 0 || x === width - 1 || y === 0 || y === height - 1) edge += 1;
      }
      if (coloured < 0.3 * width) wrong.push(`${figure.id}: no curve in a chart (${coloured} coloured pixels)`);
      if (edge > 0) wrong.push(`${figure.id}: ${edge} pixels at the edge of a chart: a number is cut off`);
    }
    if (seen === 0) wrong.push(`${figure.id}: nothing of the figure is to be seen`);
  }
  if (document.querySelectorAll("figure").length === 0) wrong.push("the page has no figures");
  if (scripts && charts === 0) wrong.push("scripts are on and no chart is interactive");
  if (!scripts && charts > 0) wrong.push("charts are there without scripts");
  return { wrong, drawings, charts };
})
"""

# Runs before the page's own scripts: remembers the texts of each canvas with where they stand, since it was last cleared.
TEXTS = r"""
(() => {
  const of = window.textsOf = new WeakMap(), context = CanvasRenderingContext2D.prototype;
  const { fillText, clearRect } = context;
  context.fillText = function (text, x, y, ...more) {
    const p = this.getTransform().transformPoint({ x, y });
    if (!of.has(this.canvas)) of.set(this.canvas, []);
    of.get(this.canvas).push([String(text), p.x, p.y]);
    return fillText.call(this, text, x, y, ...more);
  };
  context.clearRect = function (...all) { of.delete(this.canvas); return clearRect.apply(this, all); };
})()
"""

# Numbers along an axis that are not those of their places: on a line they must rise as the places do. The first and the last
# number of an axis say its scale, and no number between them may be off by more than a hundredth of a step.
TICKS = r"""
(() => {
  const wrong = [];
  const value = t => /^[−-]?\d+(\.\d+)?(e[−-]?\d+)?$/.test(t) ? Number(t.replaceAll("−", "-")) : null;
  for (const canvas of document.querySelectorAll("figure canvas")) {
    const numbers = (window.textsOf.get(canvas) ?? []).map(([t, x, y]) => [value(t), x, y, t]).filter(n => n[0] != null);
    for (const [along, across] of [[1, 2], [2, 1]]) {
      const lines = Map.groupBy(numbers, n => Math.round(n[across]));
      for (const line of lines.values()) {
        const places = [...new Map(line.map(n => [Math.round(n[along]), n])).values()].sort((a, b) => a[along] - b[along]);
        if (places.length < 3) continue;
        const [first, last] = [places[0], places.at(-1)], slope = (last[0] - first[0]) / (last[along] - first[along]);
        const step = Math.abs(last[0] - first[0]) / (places.length - 1), name = canvas.closest("figure").id;
        const off = places.find(n => Math.abs(first[0] + slope * (n[along] - first[along]) - n[0]) > 0.02 * step + 1.5 * Math.abs(slope));
        if (step === 0 || off) wrong.push(`${name}: ticks ${places.map(n => n[3]).join(", ")} are not those of their places`);
      }
    }
  }
  return wrong;
})()
"""

# Middle of the first chart, its read-outs, and what it shows.
FIRST = r"""
(() => {
  const u = document.querySelector("figure.live-shown .uplot"), over = u.querySelector(".u-over"), c = u.querySelector("canvas");
  u.scrollIntoView({ block: "center" });
  const b = over.getBoundingClientRect();
  const press = t => [...u.closest("figure").querySelectorAll("button")].find(e => e.textContent === t);
  window.press = press;
  return { x: b.left, y: b.top, width: b.width, height: b.height, picture: c.toDataURL().slice(-4000) + c.toDataURL().length,
    values: [...u.querySelectorAll(".u-value")].map(e => e.textContent) };
})()
"""


class Browser:
    """Chromium behind two pipes; messages are JSON ended by a zero byte."""

    def __init__(self, program, profile):
        to_read, self.to = os.pipe()
        self.of, of_write = os.pipe()
        # Descriptors 3 and 4 are where the browser listens and answers.
        ends = [fcntl.fcntl(fd, fcntl.F_DUPFD, 10) for fd in (to_read, of_write)]

        def wire():
            os.dup2(ends[0], 3)
            os.dup2(ends[1], 4)

        options = ["--headless=new", "--remote-debugging-pipe", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run",
                   "--disable-extensions", "--disable-background-networking", "--disable-dev-shm-usage", f"--user-data-dir={profile}"]
        self.process = subprocess.Popen([program, *options, "about:blank"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL, preexec_fn=wire, pass_fds=(3, 4))
        for fd in (to_read, of_write, *ends):
            os.close(fd)
        self.buffer, self.number, self.events, self.session = b"", 0, [], None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        self.call("Page.addScriptToEvaluateOnNewDocument", source=TEXTS)

    def receive(self, until):
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.of], [], [], max(0.0, until - time.monotonic()))
            part = os.read(self.of, 1 << 20) if ready else b""
            if not part:
                sys.exit("error: the browser ended" if ready else f"error: no answer of the browser within {DEADLINE_S:.0f} s")
            self.buffer += part
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        until = time.monotonic() + DEADLINE_S
        while True:
            answer = self.receive(until)
            if answer.get("id") != self.number:
                self.events.append(answer)
            elif "error" in answer:
                sys.exit(f"error: {method}: {answer['error']['message']}")
            else:
                return answer["result"]

    def wait(self, method):
        until = time.monotonic() + DEADLINE_S
        while not any(event.get("method") == method for event in self.events):
            self.events.append(self.receive(until))

    def evaluate(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True)
        if "exceptionDetails" in answer:
            sys.exit(f"error: {answer['exceptionDetails'].get('exception', {}).get('description', expression)}")
        return answer["result"].get("value")

    def frames(self):
        """Time for what is drawn at the next frame; a timer of the page would not fire where scripts are off."""
        time.sleep(0.08)

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def view(self, width, scheme, media, scripts):
        self.call("Emulation.setScriptExecutionDisabled", value=not scripts)
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)
        self.call("Emulation.setEmulatedMedia", media=media, features=[{"name": "prefers-color-scheme", "value": scheme}])

    def open(self, url):
        self.events.clear()
        self.call("Page.navigate", url=url)
        self.wait("Page.loadEventFired")

    def complaints(self, url):
        """Errors of the console and requests to anywhere but the page."""
        for event in self.events:
            of, what = event.get("method"), event.get("params", {})
            if of == "Runtime.exceptionThrown":
                details = what["exceptionDetails"]
                yield "exception: " + details.get("exception", {}).get("description", details["text"])
            elif of == "Runtime.consoleAPICalled" and what["type"] in ("error", "warning", "assert"):
                yield "console: " + " ".join(str(a.get("value", a.get("description"))) for a in what["args"])
            elif of == "Log.entryAdded" and what["entry"]["level"] == "error":
                yield "console: " + what["entry"]["text"]
            elif of == "Network.requestWillBeSent":
                to = what["request"]["url"]
                if to.split("#")[0] != url and not to.startswith("data:"):
                    yield f"a request to {to}"

    def picture(self, path, width):
        height = self.evaluate("document.documentElement.scrollHeight")
        clip = {"x": 0, "y": 0, "width": width, "height": min(height, 16000), "scale": 1}
        data = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=True, clip=clip)["data"]
        path.write_bytes(base64.b64decode(data))


def handled(browser):
    """What does not answer the reader's hand in the first chart."""
    first = browser.evaluate(FIRST)
    browser.frames()
    start = browser.evaluate(FIRST)
    y = start["y"] + 0.5 * start["height"]
    at = lambda part: start["x"] + part * start["width"]
    browser.mouse("mouseMoved", at(0.5), y)
    browser.frames()
    if not all(any(c.isdigit() for c in value) for value in browser.evaluate(FIRST)["values"]):
        yield "no read-out at the cursor"
    browser.mouse("mousePressed", at(0.4), y, button="left", clickCount=1)
    browser.mouse("mouseMoved", at(0.6), y, button="left")
    browser.mouse("mouseReleased", at(0.6), y, button="left", clickCount=1)
    browser.frames()
    zoomed = browser.evaluate(FIRST)["picture"]
    if zoomed == first["picture"]:
        yield "dragging does not zoom"
    browser.evaluate("document.querySelector('figure.live-shown .uplot .u-over').dispatchEvent(new MouseEvent('dblclick', {bubbles: true}))")
    browser.frames()
    again = browser.evaluate(FIRST)["picture"]
    if again != first["picture"]:
        yield "a double click does not bring the first view back"
    browser.evaluate("document.querySelector('figure.live-shown .uplot .u-series:nth-child(2) th').click()")
    browser.frames()
    if browser.evaluate(FIRST)["picture"] == again:
        yield "a legend entry does not hide its curve"
    browser.evaluate("document.querySelector('figure.live-shown .uplot .u-series:nth-child(2) th').click()")
    whole = browser.evaluate("(e => e && (e.click(), true))(press('Whole run'))")
    browser.frames()
    if whole and browser.evaluate(FIRST)["picture"] == again:
        yield "the whole run is not shown on demand"
    browser.evaluate("press('Steady part')?.click(); scrollTo(0, 0)")


def ticked(browser):
    """False numbers at the axes, at the first view and zoomed in by two and two: steps of 1, 2, 2.5 and 5 then all occur."""
    for zoom in range(8):
        yield from browser.evaluate(TICKS)
        browser.evaluate("document.querySelectorAll('button[aria-label=\"Zoom in\"]').forEach(b => b.click())")
        browser.frames()
    browser.evaluate("document.querySelectorAll('figure .uplot .u-over').forEach(e => e.dispatchEvent(new MouseEvent('dblclick', {bubbles: true})))")
    browser.frames()


def checked(browser, page, pictures):
    url = page.resolve().as_uri()
    views = [(w, s, "screen", on) for on in (True, False) for s in ("light", "dark") for w in WIDTHS]
    views.append((760, "dark", "print", True))
    wrong, drawings, charts = [], 0, 0
    for width, scheme, media, scripts in views:
        name = f"{media}-{width}-{scheme}-{'scripts' if scripts else 'plain'}"
        browser.view(width, scheme, media, scripts)
        browser.open(url)
        browser.frames()
        expected = scripts and media == "screen"
        seen = browser.evaluate(f"({LOOK})({json.dumps(expected)})")
        drawings, charts = max(drawings, seen["drawings"]), max(charts, seen["charts"])
        found = list(seen["wrong"])
        if media == "print" and browser.evaluate("getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)":
            found.append("paper is not white")
        if expected and scheme == "light":
            found.extend(handled(browser))
            found.extend(ticked(browser))
        found.extend(browser.complaints(url))
        wrong.extend(f"{page.parent.name}/{page.name}, {name}: {text}" for text in dict.fromkeys(found))
        if pictures:
            browser.picture(pictures / f"{page.parent.name}-{name}.png", width)
    print(f"{page}: {page.stat().st_size / 1e6:.2f} MB, {drawings} drawings, {charts} charts, {len(views)} views, {len(wrong)} failures")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("pages", nargs="+", type=Path)
    parser.add_argument("--browser", default="chromium")
    parser.add_argument("--pictures", type=Path, help="folder for a picture of each view")
    arguments = parser.parse_args()
    if arguments.pictures:
        arguments.pictures.mkdir(parents=True, exist_ok=True)
    began = time.monotonic()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(arguments.browser, profile)
        try:
            wrong = [text for page in arguments.pages for text in checked(browser, page, arguments.pictures)]
        finally:
            browser.process.kill()
            browser.process.wait()
    for text in wrong:
        print(f"failure: {text}")
    print(f"{len(arguments.pages)} pages in {time.monotonic() - began:.1f} s")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
