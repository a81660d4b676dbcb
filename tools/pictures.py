"""Makes the pictures of the documentation anew: docs/images, from the reports of the examples.

    .venv/bin/python tools/pictures.py

It needs Playwright (installed for the tests) and a Chromium; LINKWRIGHT_CHROMIUM names one that isn't on the path.
"""

import os
import shutil
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

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
        for example in dict.fromkeys(picture.example for picture in PICTURES):
            out = Path(folder, example)
            linkwright.run(ROOT / "examples" / f"{example}.yaml", out)
            for picture in PICTURES:
                if picture.example == example:
                    take(browser, picture, out / "report.html")
                    sys.stdout.write(f"{(IMAGES / picture.file).relative_to(ROOT)}\n")
        browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
