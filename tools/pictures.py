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
COLOURS = 64
"""Of a film."""


def opened(browser: Any, report: Path, width: int, height: int) -> Any:
    """A report on screen, at rest."""
    size = {"width": width, "height": height}
    page = browser.new_page(viewport=size, color_scheme="light", reduced_motion="reduce")
    page.goto(report.as_uri())
    return page


def set_pose(page: Any, pose: int) -> None:
    """Show a sampled pose."""
    page.get_by_role("slider", name="time").fill(str(pose))
    page.evaluate("() => document.activeElement.blur()")  # no frame around the slider
    page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")


@dataclass(frozen=True)
class Picture:
    """A part of an example's report: from the section ``top`` down, at a sampled pose, with the size in CSS pixels and
    the boxes of the drawing that are ticked."""

    file: str
    example: str
    top: str | None
    pose: int
    width: int = 1500
    height: int = 1010
    ticked: tuple[str, ...] = ()

    def take(self, browser: Any, report: Path) -> None:
        """Save what is on screen."""
        page = opened(browser, report, self.width, self.height)
        if self.top is not None:
            page.locator(f"#{self.top}").evaluate("section => section.scrollIntoView()")
        for label in self.ticked:
            page.locator("#drawing").get_by_label(label, exact=True).check()
        set_pose(page, self.pose)
        page.screenshot(path=IMAGES / self.file)
        page.close()


@dataclass(frozen=True)
class Film:
    """The drawing of an example's report in motion: every ``stride``-th of its sampled poses, for ``pause`` ms each."""

    file: str
    example: str
    stride: int
    pause: int
    width: int = 500

    def take(self, browser: Any, report: Path) -> None:
        """Save the drawing of each pose, all in the colours of the first."""
        page = opened(browser, report, self.width, 1000)
        page.add_style_tag(content=".lw-tools { visibility: hidden }")
        frames: list[Image.Image] = []
        for pose in range(0, int(page.get_by_role("slider", name="time").get_attribute("max")), self.stride):
            set_pose(page, pose)
            shot = Image.open(io.BytesIO(page.locator("#drawing svg").first.screenshot())).convert("RGB")
            first = frames[0] if frames else shot.quantize(COLOURS, Image.Quantize.MAXCOVERAGE)
            frames.append(shot.quantize(palette=first, dither=Image.Dither.NONE))
        more: dict[str, Any] = {"save_all": True, "append_images": frames[1:], "duration": self.pause, "loop": 0}
        frames[0].save(IMAGES / self.file, optimize=True, **more)
        page.close()


PICTURES = (
    Picture("paper_feeder.png", "paper_feeder", None, 160),
    Picture("paper_feeder_forces.png", "paper_feeder", "plots", 18, height=830, ticked=("Reactions", "Moments")),
    Film("paper_feeder.gif", "paper_feeder", 6, 45),
)


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
                    picture.take(browser, out / "report.html")
                    sys.stdout.write(f"{(IMAGES / picture.file).relative_to(ROOT)}\n")
        browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
