"""Makes the pictures of the documentation anew: docs/images, from the reports of the examples.

    .venv/bin/python tools/pictures.py

It needs Playwright and Pillow (installed for the tests) and a Chromium; LINKWRIGHT_CHROMIUM names one that isn't on the
path.
"""

import io
import os
import shutil
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from PIL import Image
from playwright.sync_api import sync_playwright

import linkwright

ROOT = Path(__file__).resolve().parents[1]
IMAGES = ROOT / "docs" / "images"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")


@dataclass(frozen=True)
class Picture:
    """A part of an example's report: from the section ``top`` down, at a sampled pose, with the size in CSS pixels."""

    file: str
    example: str
    top: str | None
    pose: int
    width: int = 1500
    height: int = 1010


PICTURES = (
    Picture("paper_feeder.png", "paper_feeder", None, 160),
    Picture("paper_feeder_forces.png", "paper_feeder", "force", 160),
)


@dataclass(frozen=True)
class Film:
    """The drawing of an example's report in motion: every ``stride``-th of its sampled poses, ``pause`` ms each."""

    file: str
    example: str
    stride: int
    pause: int
    width: int = 560


FILMS = (Film("paper_feeder.gif", "paper_feeder", 6, 45),)


def film(browser: Any, film: Film, report: Path) -> None:
    """Open the report, step through the poses and save the drawing of each."""
    page = browser.new_page(
        viewport={"width": film.width, "height": 1000}, color_scheme="light", reduced_motion="reduce"
    )
    page.goto(report.as_uri())
    slider, frames = page.get_by_role("slider", name="time"), []
    for pose in range(0, int(slider.get_attribute("max")), film.stride):
        slider.fill(str(pose))
        page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        shot = page.locator("#drawing svg").first.screenshot()
        frames.append(Image.open(io.BytesIO(shot)).convert("RGB").quantize(48, dither=Image.Dither.NONE))
    frames[0].save(
        IMAGES / film.file, save_all=True, append_images=frames[1:], duration=film.pause, loop=0, optimize=True
    )
    page.close()


def take(browser: Any, picture: Picture, report: Path) -> None:
    """Open the report, set the pose and save what is on screen."""
    size = {"width": picture.width, "height": picture.height}
    page = browser.new_page(viewport=size, color_scheme="light", reduced_motion="reduce")
    page.goto(report.as_uri())
    page.get_by_role("slider", name="time").fill(str(picture.pose))
    page.evaluate("() => document.activeElement.blur()")  # no frame around the slider
    if picture.top is not None:
        page.locator(f"#{picture.top}").evaluate("section => section.scrollIntoView()")
    page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    page.screenshot(path=IMAGES / picture.file)
    page.close()


def main() -> int:
    """Run each example once, then take its pictures."""
    os.environ.setdefault("SOURCE_DATE_EPOCH", "1767225600")  # the date that the reports show: the same in each run
    path = os.environ.get("LINKWRIGHT_CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as play:
        browser = play.chromium.launch(executable_path=path, args=["--no-sandbox"])
        for example in dict.fromkeys(each.example for each in (*PICTURES, *FILMS)):
            out = Path(folder, example)
            linkwright.run(ROOT / "examples" / f"{example}.yaml", out)
            for made in (*PICTURES, *FILMS):
                if made.example == example:
                    (film if isinstance(made, Film) else take)(browser, made, out / "report.html")
                    sys.stdout.write(f"{(IMAGES / made.file).relative_to(ROOT)}\n")
        browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
