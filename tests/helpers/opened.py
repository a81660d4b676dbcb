"""Reports on screen: opened in a browser without a network, with all that they complain about and ask for."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from linkwright.report import ReportData, page


class Opened:
    """A page on screen."""

    def __init__(self, browser: Any, path: Path, **settings: Any) -> None:
        settings = {"viewport": {"width": 1400, "height": 900}, "reduced_motion": "reduce"} | settings
        self.context = browser.new_context(**settings)
        self.context.set_offline(True)
        self.page = self.context.new_page()
        self.complaints: list[str] = []
        self.requests: list[str] = []
        self.page.on("console", lambda m: self.complaints.append(m.text))
        self.page.on("pageerror", lambda e: self.complaints.append(str(e)))
        self.page.on("request", lambda r: self.requests.append(r.url))
        self.page.goto(path.as_uri())
        self.slider = self.page.get_by_role("slider", name="time")

    def pin(self, name: str) -> complex:
        """Centre of a point's circle on the screen, in pixels, y up."""
        box = self.page.locator(f'#drawing [data-point="{name}"]').bounding_box()
        return complex(box["x"] + box["width"] / 2, -box["y"] - box["height"] / 2)

    def legend(self, plot: int) -> list[str]:
        texts = self.page.locator("figure.plot").nth(plot).locator(".legend output").all_inner_texts()
        return [text.replace("−", "-") for text in texts]

    def settle(self) -> None:
        """Two frames: plots draw in the one after a change."""
        self.page.evaluate("() => new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r)))")

    def close(self) -> None:
        """Close it; it had nothing to complain about and asked for nothing but files."""
        assert self.complaints == []
        assert [url for url in self.requests if not url.startswith(("file:", "data:", "blob:"))] == []
        self.context.close()


class OpenedDrawing(Opened):
    """A report on screen, of which the drawing is looked at in its own pixels."""

    def __init__(self, browser: Any, path: Path, **settings: Any) -> None:
        super().__init__(browser, path, **{"viewport": {"width": 1400, "height": 1000}} | settings)
        self.drawing = self.page.locator("#drawing")
        self.picture = self.drawing.locator("svg.lw-drawing")

    def at(self, index: int) -> None:
        self.page.evaluate("i => linkwright.drawing.setIndex(i)", index)

    def set(self, name: str, value: float) -> None:
        """Give a named number of the file another value (SI)."""
        self.page.evaluate(
            """([name, value]) => { const { live } = linkwright;
            live.set(live.data.numbers.findIndex(each => each.name === name), value); }""",
            [name, value],
        )
        self.settle()

    def change(self, label: str, factor: float) -> None:
        """Multiply a number of the file."""
        self.page.evaluate(
            """([label, factor]) => { const { live } = linkwright;
            const i = live.data.numbers.findIndex(each => each.label === label);
            live.set(i, live.data.numbers[i].value * factor); }""",
            [label, factor],
        )
        self.settle()

    def pin(self, name: str) -> complex:
        """A point's place in the drawing, in its pixels, y up."""
        circle = self.picture.locator(f'[data-point="{name}"]')
        return complex(float(circle.get_attribute("cx")), -float(circle.get_attribute("cy")))

    def arrow(self, kind: str, name: str) -> tuple[complex, complex]:
        """Where an arrow begins, and its vector, in the drawing's pixels, y up; NaN and zero where it is too short."""
        d = self.picture.locator(f'.lw-{kind}[data-arrow="{name}"]').get_attribute("d")
        if not d:
            return complex(np.nan), 0j
        points = [complex(*(float(c) for c in at.split())).conjugate() for at in d.strip("MZ").split("L")]
        return points[0], points[3] - points[0]  # shaft, neck, a side of the head, its tip

    def readout(self) -> list[str]:
        box = self.drawing.locator(".lw-hover")
        return [text.replace("−", "-") for text in box.locator("b, span").all_inner_texts()] if box.is_visible() else []

    def show(self, *names: str) -> None:
        for name in names:
            self.drawing.get_by_label(name, exact=True).check()


def opened(browser: Any, file: Callable[[Any], Path], kind: type[Opened] = Opened) -> Iterator[Any]:
    """What a fixture yields that opens reports: ``file`` gives that of what is asked for."""
    found: list[Opened] = []

    def open_(asked: Any, **settings: Any) -> Opened:
        found.append(kind(browser, file(asked), **settings))
        return found[-1]

    yield open_
    for each in found:
        each.close()


def written(folder: Path) -> Callable[[ReportData], Path]:
    """Writes reports into a folder."""

    def write(data: ReportData) -> Path:
        path = folder / f"report{len([*folder.glob('report*.html')])}.html"
        path.write_text(page(data), encoding="utf-8")
        return path

    return write
