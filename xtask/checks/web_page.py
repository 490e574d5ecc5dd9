"""Opens the page of `cargo xtask web` in headless Chromium, types bearings, and holds its numbers against the command's JSON.

Usage: python3 web_page.py FOLDER [--command PROGRAM] [--browser PROGRAM] [--pictures DIR]

Recordings and tables are opened in it too. Failures are numbers that differ, messages that do not come, a page wider than its
window, text without contrast, errors of the console, and requests to anywhere else. Without a command, numbers are not compared.
"""

import argparse
import base64
import functools
import http.server
import json
import math
import random
import re
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

from report_page import Browser

# Products are rounded before they are added in the browser, at once by the command: solutions differ by what Newton leaves.
TOLERANCE = 1e-9
# Digits of the cards.
SHOWN = 2e-3
WIDTHS = [1280, 400]

# A designation as typed, radial and axial load, speed; the model that follows the raceway control.
BEARINGS = [
    ("6206", 2000, 300, 3000, "usual", "traction"),
    ("7210", 500, 2000, 9000, "ag", "steady-orbit"),
    ("6004-2RS C3", 400, 100, 6000, "grease", "traction"),
    ("7014CDGA/P4A", 200, 900, 12000, "usual", "traction"),
]

# Text without contrast (WCAG 2: 4.5), and what is wider than the window.
LOOK = r"""
(() => {
  const wrong = [], wide = document.documentElement.scrollWidth, frame = document.documentElement.clientWidth;
  if (wide > frame) wrong.push(`the page is ${wide} px wide in a window of ${frame} px`);
  const rgb = c => { const m = c.match(/[\d.]+/g).map(Number); return { v: m.slice(0, 3), a: m.length > 3 ? m[3] : 1 }; };
  const linear = c => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  const luminance = v => 0.2126 * linear(v[0]) + 0.7152 * linear(v[1]) + 0.0722 * linear(v[2]);
  const ground = e => { for (; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor); if (c.a > 0.5) return c.v; } return [255, 255, 255]; };
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), found = new Set();
  for (let node; (node = walker.nextNode());) {
    const e = node.parentElement;
    if (!node.data.trim() || ["SCRIPT", "STYLE", "TITLE", "title"].includes(e.tagName) || !e.checkVisibility({ visibilityProperty: true })) continue;
    const svg = e.closest("svg"), style = getComputedStyle(e);
    const [x, y] = [luminance(rgb(svg ? style.fill : style.color).v), luminance(ground(e))].sort((p, q) => q - p);
    const ratio = (x + 0.05) / (y + 0.05);
    if (ratio < 4.5) found.add(`contrast ${ratio.toFixed(1)} of ${JSON.stringify(node.data.trim().slice(0, 40))}`);
    if (svg) {
      const box = e.getBoundingClientRect(), of = svg.getBoundingClientRect();
      if (box.left < of.left - 1 || box.right > of.right + 1 || box.top < of.top - 1 || box.bottom > of.bottom + 1)
        found.add(`text ${JSON.stringify(node.data)} is cut off by the edge of its drawing`);
    }
  }
  for (const label of document.querySelectorAll("input, select"))
    if (!label.labels?.length) found.add(`${label.name || label.id}: no label`);
  return [...wrong, ...found];
})()
"""


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def served(folder):
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_address[1]}/"


def until(browser, expression, seconds=120.0):
    begun = time.monotonic()
    while not browser.evaluate(f"!!({expression})"):
        if time.monotonic() - begun > seconds:
            told = [*browser.complaints(""), browser.evaluate("document.getElementById('state')?.textContent")]
            sys.exit(f"error: not within {seconds:.0f} s: {expression}; {told}")
        time.sleep(0.1)


def key(browser, name, code, text=None, **more):
    browser.call("Input.dispatchKeyEvent", type="keyDown", key=name, code=name, windowsVirtualKeyCode=code, **({"text": text} if text else {}), **more)
    browser.call("Input.dispatchKeyEvent", type="keyUp", key=name, code=name, windowsVirtualKeyCode=code, **more)


def typed(browser, name, value):
    """As a person types: focus, everything marked, the new text."""
    browser.evaluate(f"(e => {{ e.focus(); e.select?.(); }})(document.querySelector('[name={name}]'))")
    browser.call("Input.insertText", text=str(value))


def chosen(browser, name, value):
    browser.evaluate(f"(e => {{ e.value = {json.dumps(value)}; e.dispatchEvent(new Event('input', {{ bubbles: true }})); }})(document.querySelector('[name={name}]'))")


def filled(browser, bearing):
    designation, radial, axial, speed, lubricant, _ = bearing
    before = browser.evaluate("Number(document.documentElement.dataset.quick ?? 0)")
    chosen(browser, "lubricant", lubricant)
    for name, value in (("angle", 40 if designation == "7210" else ""), ("designation", designation), ("radial", radial), ("axial", axial), ("speed", speed)):
        if value == "":
            browser.evaluate("(e => { e.value = ''; e.dispatchEvent(new Event('input', { bubbles: true })); })(document.querySelector('[name=angle]'))")
        else:
            typed(browser, name, value)
    until(browser, f"Number(document.documentElement.dataset.quick) >= {before} + 6")


def answered(browser, kind, bearing):
    """The answer with all its digits, by the page's own module."""
    designation, radial, axial, speed, lubricant, _ = bearing
    question = {"ask": kind, "designation": designation, "radial": radial, "axial": axial, "speed": speed, "lubricant": lubricant}
    if designation == "7210":
        question["angle"] = 40
    expression = f"import('./solver.js').then(({{ Solver }}) => new Solver().ask('test', {json.dumps(question)}))"
    answer = browser.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
    if "exceptionDetails" in answer:
        sys.exit(f"error: {answer['exceptionDetails']}")
    return answer["result"]["value"]


def numbers(value, path=""):
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from numbers(inner, f"{path}.{name}")
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from numbers(inner, f"{path}[{index}]")
    elif isinstance(value, float | int) and not isinstance(value, bool):
        # Parts of a vector have its size.
        yield re.sub(r"\[\d+\]|_[xyz](?=_)", "[]", path), path, float(value)


# What is left over of a search, and what is 0 but for rounding, has no digits to compare.
LEFT = re.compile(r"residual|iterations|warm|error_estimate|multiplier|pocket_lead|_tangential_|wear_rate")


def differences(ours, theirs):
    """Pairs of a relative difference, against the largest value of that name, and the path."""
    ours, theirs = list(numbers(ours)), {path: value for _, path, value in numbers(theirs)}
    scale = {}
    for name, path, value in ours:
        scale[name] = max(scale.get(name, 0.0), abs(value), abs(theirs.get(path, 0.0)))
    for name, path, value in ours:
        if path in theirs and not LEFT.search(path) and scale[name] > 1e-12:
            yield abs(value - theirs[path]) / scale[name], path


def printed(command, *arguments):
    done = subprocess.run([command, *map(str, arguments), "--json"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"error: {' '.join(map(str, arguments))}: {done.stderr}")
    return json.loads(done.stdout)


def compared(browser, command, folder):
    worst = 0.0
    for bearing in BEARINGS:
        designation, radial, axial, speed, _, model = bearing
        filled(browser, bearing)
        quick, full = answered(browser, "quick", bearing), answered(browser, "full", bearing)
        for answer in (quick, full):
            if "error" in answer:
                yield f"{designation}: {answer['error']}"
                return
        shown = {name: browser.evaluate(f"parseFloat(document.getElementById('{name}')?.textContent)") for name in ("life", "pressure", "k-axial", "bpfo", "ball-load")}
        sheet = quick["sheet"]
        expected = {"life": sheet["rating"]["rating_life_l10_mrev"], "pressure": sheet["rating"]["peak_pressure_max_pa"] * 1e-9,
                    "k-axial": sheet["stiffness"][2][2] * 1e-6, "bpfo": sheet["rating"]["frequencies"]["ball_pass_outer_hz"], "ball-load": sheet["ball_load_max_n"]}
        for name, value in expected.items():
            if not math.isclose(shown[name] or math.nan, value, rel_tol=SHOWN):
                yield f"{designation}: the page shows {name} {shown[name]}, its module says {value}"
        if not command:
            continue
        case = folder / "page.ron"
        case.write_text(quick["text"])
        pairs = [
            ("sheet", quick["sheet"], printed(command, "sheet", case, "--radial", radial, "--axial", axial, "--speed", speed)),
            ("check", {k: v for k, v in quick["derived"].items() if k != "sources"}, printed(command, "check", case)),
            ("jones-harris", quick["solution"], printed(command, "solve", case, "--model", "jones-harris")),
            (model, full["solution"], printed(command, "solve", case, "--model", model)),
        ]
        for name, ours, theirs in pairs:
            found = sorted(differences(ours, theirs), reverse=True)
            if not found:
                yield f"{designation}, {name}: nothing to compare"
                continue
            (most, path), count = found[0], len(found)
            print(f"{designation}, {name}: {count} numbers, largest relative difference {most:.1e} ({path})")
            worst = max(worst, most)
            if not most <= TOLERANCE:
                yield f"{designation}, {name}: {path} differs by {most:.1e} of its size, allowed is {TOLERANCE:.0e}"
    print(f"largest relative difference {worst:.1e}")


def handled(browser):
    """Keyboard, refusals, the link, and the stop of a search."""
    typed(browser, "designation", "9999")
    until(browser, "!document.getElementById('problem').hidden")
    message = browser.evaluate("document.getElementById('problem').textContent")
    if "9999" not in message or "allowed" not in message:
        yield f"a bearing that is not there is answered by {message!r}"
    typed(browser, "designation", "6206")
    until(browser, "document.getElementById('problem').hidden")
    typed(browser, "radial", "1e")
    until(browser, "!document.getElementById('problem').hidden && document.querySelector('[name=radial]').getAttribute('aria-invalid') === 'true'")
    typed(browser, "radial", "2 pounds")
    until(browser, "document.getElementById('problem').textContent.includes('N, kN, lbf')")
    for text in ("562.0223607927 lbf", "2.5kN"):
        typed(browser, "radial", text)
        until(browser, "document.getElementById('problem').hidden && document.getElementById('pressure')")
        time.sleep(0.5)
        seen = browser.evaluate("parseFloat(document.getElementById('ball-load').textContent)")
        typed(browser, "radial", "2500")
        time.sleep(1.0)
        expected = browser.evaluate("parseFloat(document.getElementById('ball-load').textContent)")
        if seen != expected:
            yield f"{text} gives a ball load of {seen} N, 2500 N one of {expected} N"
    typed(browser, "radial", "2500")
    until(browser, "document.getElementById('problem').hidden && location.hash.includes('radial=2500')")
    seen = []
    browser.evaluate("document.querySelector('[name=designation]').focus()")
    for _ in range(9):
        key(browser, "Tab", 9)
        seen.append(browser.evaluate("document.activeElement.name || document.activeElement.id"))
    if not {"radial", "axial", "speed", "lubricant", "share"} <= set(seen):
        yield f"the Tab key goes to {seen} only"
    browser.evaluate("document.getElementById('turning').checked && document.getElementById('turning').click(); document.getElementById('view').focus()")
    time.sleep(0.5)
    picture = "document.getElementById('view').toDataURL()"
    before = browser.evaluate(picture)
    key(browser, "ArrowRight", 39)
    time.sleep(0.5)
    if browser.evaluate("document.getElementById('view').tagName === 'CANVAS'") and browser.evaluate(picture) == before:
        yield "an arrow key does not turn the bearing"
    life = browser.evaluate("document.getElementById('life').textContent")
    address = browser.evaluate("location.href")
    browser.open("about:blank")
    browser.open(address)
    until(browser, f"document.getElementById('life')?.textContent === {json.dumps(life)}")


def given(browser, path):
    """A file as a person opens it."""
    root = browser.call("DOM.getDocument")["root"]["nodeId"]
    node = browser.call("DOM.querySelector", nodeId=root, selector="#open")["nodeId"]
    browser.evaluate("delete document.documentElement.dataset.dropped; document.getElementById('dropped-problem').hidden = true")
    browser.call("DOM.setFileInputFiles", nodeId=node, files=[str(path)])
    until(browser, f"document.documentElement.dataset.dropped === {json.dumps(path.name)} || !document.getElementById('dropped-problem').hidden", 30)


def dropped(browser, command, folder):
    """Tables, a recording against the command's own numbers, and what is refused."""
    table = folder / "table.csv"
    table.write_text("time_s;a\n" + "\n".join(f"{k / 8};{str(math.cos(k)).replace('.', ',')}" for k in range(1000)))
    given(browser, table)
    shown = browser.evaluate("document.getElementById('dropped-numbers').textContent")
    rms = math.sqrt(sum(math.cos(k) ** 2 for k in range(1000)) / 1000)
    if not math.isclose(float(shown.rsplit("rms ", 1)[1]), rms, rel_tol=1e-5):
        yield f"a table whose rms is {rms:.6g} is shown as {shown!r}"
    for path in sorted((Path(__file__).parents[2] / "fixtures/fuzz/reader").glob("*.mcap")):
        given(browser, path)
        if browser.evaluate("document.getElementById('dropped-problem').hidden"):
            yield f"{path.name}, which is no recording, is taken"
    if not command:
        return
    recording = folder / "orbit.mcap"
    case = Path(__file__).parents[2] / "fixtures/cases/angular-7210.ron"
    answer = printed(command, "solve", case, "--model", "jones-harris", "-o", recording)
    given(browser, recording)
    if not browser.evaluate("document.getElementById('dropped-problem').hidden"):
        yield f"a recording is refused: {browser.evaluate('document.getElementById(`dropped-problem`).textContent')}"
        return
    data = base64.b64encode(recording.read_bytes()).decode()
    expression = f"import('./recording.js').then(({{ read }}) => {{ const all = read(Uint8Array.from(atob('{data}'), c => c.charCodeAt(0))); return {{ names: all.balls.names, first: all.balls.rows[0].map(row => [...row]), speed: all.states.get('cage_speed_rpm')[0] }}; }})"
    found = browser.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)["result"]["value"]
    worst = abs(found["speed"] / answer["cage_speed_rpm"] - 1)
    for name in ("load_inner_n", "load_outer_n", "contact_angle_outer_deg"):
        largest = max(abs(ball[name]) for ball in answer["balls"])
        for row, ball in zip(found["first"], answer["balls"]):
            worst = max(worst, abs(row[found["names"].index(name)] - ball[name]) / largest)
    print(f"recording in the page: {len(found['first'])} balls, largest relative difference {worst:.1e}")
    if len(found["first"]) != len(answer["balls"]) or not worst <= 1e-6:
        yield f"a recording's numbers differ by {worst:.1e} from those of the command"
    browser.evaluate("document.getElementById('dropped-play').textContent === 'Pause' && document.getElementById('dropped-play').click()")
    pictures = []
    for place in (0, 10):
        browser.evaluate(f"(e => {{ e.value = {place}; e.dispatchEvent(new Event('input')); }})(document.getElementById('dropped-time'))")
        time.sleep(0.5)
        pictures.append(browser.evaluate("document.getElementById('dropped-view').toDataURL?.()"))
    if pictures[0] == pictures[1]:
        yield "the recorded bearing does not move"
    yield from (f"with a recording: {text}" for text in browser.evaluate(LOOK))
    browser.evaluate("document.getElementById('dropped-close').click()")


def diagnosed(browser, command, folder):
    """A made signal of a defect of the outer race, searched by the page and by the command."""
    rate, speed, bearing = 12_800, 1480, ("6206", 1000, 100, 1480, "usual", "traction")
    filled(browser, bearing)
    answer = answered(browser, "quick", bearing)
    case = folder / "vibration.ron"
    case.write_text(answer["text"])
    strikes, noise = answer["sheet"]["rating"]["frequencies"]["ball_pass_outer_hz"], random.Random(1)
    lines = ["time_s,acceleration"]
    for k in range(3 * rate):
        since = (k / rate * strikes) % 1.0 / strikes
        lines.append(f"{k / rate},{math.exp(-900 * since) * math.sin(2 * math.pi * 3200 * since) + noise.gauss(0.0, 0.1):.6f}")
    table = folder / "motor.csv"
    table.write_text("\n".join(lines))
    given(browser, table)
    browser.evaluate("document.getElementById('dropped-search').click()")
    until(browser, "document.querySelector('#dropped-envelope svg')", 60)
    shown = browser.evaluate("document.getElementById('dropped-verdict').textContent")
    if not shown.startswith("Fault: outer."):
        yield f"a defect of the outer race is told as {shown!r}"
    yield from (f"with a signal: {text}" for text in browser.evaluate(LOOK))
    if command:
        theirs = printed(command, "vibration", table, "--channel", "acceleration", "--rate", rate, "--bearing", case, "--speed", speed)
        if theirs["verdict"]["fault"] != "outer" or theirs["verdict"]["reasons"][0] not in shown:
            yield f"the command says {theirs['verdict']}, the page {shown!r}"
        print(f"signal in the page: {shown[:90]}")
    browser.evaluate("document.getElementById('dropped-close').click()")


def viewed(browser, width, scheme):
    """Without motion: a browser without a graphics processor draws slowly."""
    browser.view(width, scheme, "screen", True)
    features = [{"name": "prefers-color-scheme", "value": scheme}, {"name": "prefers-reduced-motion", "value": "reduce"}]
    browser.call("Emulation.setEmulatedMedia", media="screen", features=features)


def complaints(browser, url):
    for text in browser.complaints(url):
        if not text.startswith(f"a request to {url}") and not text.startswith("a request to blob:"):
            yield text


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--command")
    parser.add_argument("--browser", default="chromium")
    parser.add_argument("--pictures", type=Path, help="folder for a picture of each view")
    arguments = parser.parse_args()
    if arguments.pictures:
        arguments.pictures.mkdir(parents=True, exist_ok=True)
    url, wrong = served(arguments.folder), []
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as work:
        browser = Browser(arguments.browser, Path(work) / "profile")
        try:
            for scheme in ("light", "dark"):
                for width in WIDTHS:
                    viewed(browser, width, scheme)
                    begun = time.monotonic()
                    browser.open("about:blank")
                    browser.open(url)
                    until(browser, "document.getElementById('cards').childElementCount > 5 && document.querySelector('#curve svg')")
                    if scheme == "light" and width == WIDTHS[0]:
                        print(f"first answer after {time.monotonic() - begun:.1f} s")
                    until(browser, "document.documentElement.dataset.full")
                    wrong.extend(f"{width} px, {scheme}: {text}" for text in [*browser.evaluate(LOOK), *complaints(browser, url)])
                    if arguments.pictures:
                        browser.picture(arguments.pictures / f"page-{width}-{scheme}.png", width)
            viewed(browser, WIDTHS[0], "light")
            browser.open("about:blank")
            browser.open(url)
            until(browser, "document.getElementById('cards').childElementCount > 5")
            wrong.extend(handled(browser))
            wrong.extend(dropped(browser, arguments.command, Path(work)))
            wrong.extend(diagnosed(browser, arguments.command, Path(work)))
            wrong.extend(compared(browser, arguments.command, Path(work)))
            wrong.extend(complaints(browser, url))
        finally:
            browser.process.kill()
            browser.process.wait()
    for text in wrong:
        print(f"failure: {text}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
