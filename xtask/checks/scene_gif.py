"""Makes an animated picture of a recording, by the page in headless Chromium: frames from one ball's place to the next one's.

Usage: python3 scene_gif.py RUN.mcap -o SCENE.gif [--frames N] [--size PX] [--browser PROGRAM]   (Pillow 9 or later)

That of the README:
    tribodyn new 7210 --angle 40
    tribodyn run 7210B.ron -o run.mcap --duration 0.01 --set 'recording.ball_rate=kHz(25.6)'
    python3 xtask/checks/scene_gif.py run.mcap -o docs/img/7210.gif
"""

import argparse
import base64
import io
import sys
import tempfile
import time
from pathlib import Path

from PIL import Image
from report_page import Browser
from web_page import given, served, viewed

PAGE = Path(__file__).parents[2] / "crates/web/page"
# Azimuths of ball 0 and the number of balls, by the page's own reader.
ORBIT = """import('./recording.js').then(({{ read }}) => {{
  const {{ balls }} = read(Uint8Array.from(atob('{data}'), c => c.charCodeAt(0))), place = balls.names.indexOf('azimuth_deg');
  return {{ count: balls.rows[0].length, azimuths: balls.rows.map(rows => rows[0][place]) }};
}})"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("recording", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--frames", type=int, default=24)
    parser.add_argument("--size", type=int, default=440)
    parser.add_argument("--browser", default="chromium")
    arguments = parser.parse_args()
    data = base64.b64encode(arguments.recording.read_bytes()).decode()
    pictures = []
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as work:
        browser = Browser(arguments.browser, Path(work) / "profile")
        try:
            viewed(browser, 1280, "light")
            browser.open(served(PAGE))
            time.sleep(1.0)
            given(browser, arguments.recording.resolve())
            found = browser.call("Runtime.evaluate", expression=ORBIT.format(data=data), returnByValue=True, awaitPromise=True)["result"]["value"]
            azimuths, count = found["azimuths"], found["count"]
            turned = [(azimuth - azimuths[0]) % 360 for azimuth in azimuths]
            end = next((place for place, angle in enumerate(turned) if 360 / count <= angle < 180), None)
            if end is None or end < arguments.frames:
                sys.exit(f"error: {end or len(turned)} states of balls until one is where the next one was; needed are {arguments.frames} or more")
            browser.evaluate("Object.assign(document.getElementById('dropped-view').style, { width: '%dpx' })" % arguments.size)
            for frame in range(arguments.frames):
                place = round(frame * end / arguments.frames)
                browser.evaluate(f"(e => {{ e.value = {place}; e.dispatchEvent(new Event('input')); }})(document.getElementById('dropped-time'))")
                time.sleep(0.4)
                shown = browser.evaluate("document.getElementById('dropped-view').toDataURL()")
                picture = Image.open(io.BytesIO(base64.b64decode(shown.split(",", 1)[1]))).convert("RGB")
                pictures.append(picture.resize((arguments.size, arguments.size), Image.Resampling.LANCZOS))
        finally:
            browser.process.kill()
            browser.process.wait()
    # One palette for all frames, so that what stands still does not flicker.
    sheet = Image.new("RGB", (arguments.size, arguments.size * len(pictures)))
    for row, picture in enumerate(pictures):
        sheet.paste(picture, (0, row * arguments.size))
    palette = sheet.quantize(256, dither=Image.Dither.NONE)
    frames = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    frames[0].save(arguments.output, save_all=True, append_images=frames[1:], duration=70, loop=0, optimize=True)
    print(f"{arguments.output}: {len(frames)} frames, {arguments.output.stat().st_size * 1e-3:.0f} kB")


if __name__ == "__main__":
    main()
