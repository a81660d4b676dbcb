"""The bar of long work: when it shows, and what it says."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from linkwright.blocks import Progress
from linkwright.cli import progress
from linkwright.cli.progress import ProgressBar, duration, rate


class Clock:
    """A time that the test sets."""

    now = 100.0

    def monotonic(self) -> float:
        return self.now


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr(progress, "time", clock)
    return clock


def drawn(clock: Clock, seconds: float, terminal: bool, shown: bool | None) -> str:
    """What a work of so many seconds leaves on the stream; it is resumed at a quarter and ends at three quarters."""
    stream = io.StringIO()
    bar = ProgressBar("sweep [x]", shown, Console(file=stream, force_terminal=terminal, width=120))
    tell: Progress = bar
    with bar:
        tell(1_000_000, 4_000_000)
        for part in range(1, 11):
            clock.now += seconds / 10
            tell(1_000_000 + part * 200_000, 4_000_000)
    return stream.getvalue()


@pytest.mark.parametrize("seconds", [0.9, 4.0])
@pytest.mark.parametrize("terminal", [True, False])
@pytest.mark.parametrize("shown", [None, True, False])
def test_it_shows_on_a_terminal_or_when_told_to(
    seconds: float, terminal: bool, shown: bool | None, clock: Clock
) -> None:
    wanted = seconds > 1 and (terminal if shown is None else shown)
    assert bool(drawn(clock, seconds, terminal, shown)) == wanted


def test_it_says_share_rate_and_time_left(clock: Clock) -> None:
    """Poses done before this run began count to the share, not to the rate."""
    text = drawn(clock, 4.0, True, None)
    assert "sweep [x]" in text
    assert "75%" in text
    assert "500 k poses/s" in text
    assert "0:02 left" in text


def test_few_pieces_are_counted(clock: Clock) -> None:
    """After a work of many poses, for one bar: neither its poses nor its time count."""
    stream = io.StringIO()
    with ProgressBar("run", True, Console(file=stream, force_terminal=True, width=120)) as bar:
        bar(0, 10**6)
        clock.now += 50.0
        bar(10**6, 10**6)
        for done in range(4):
            bar(done, 6)
            clock.now += 2.0
            bar(done, 6)
    assert "3 of 6, 0:08 left" in stream.getvalue() and "50%" in stream.getvalue()


def test_rates_and_times() -> None:
    speeds = {0.5: "0.5", 999.4: "999", 999.6: "1 k", 38.21e6: "38.2 M", 999.9e3: "1 M", 2.5e9: "2.5 G"}
    assert {speed: rate(speed) for speed in speeds} == speeds
    assert [duration(v) for v in (0.4, 59.6, 3600, 86_461)] == ["0:00", "1:00", "1:00:00", "24:01:01"]


@pytest.mark.parametrize("seconds", [0.9, 4.0])
def test_what_stood_there_ends_right_before_it_shows(seconds: float, clock: Clock) -> None:
    """A spinner goes on until there is a bar in its place."""
    ended: list[float] = []
    stream = Console(file=io.StringIO(), force_terminal=True, width=120)
    with ProgressBar("cycle", None, stream, lambda: ended.append(clock.now)) as bar:
        for part in range(5):
            clock.now = 100.0 + seconds * part / 4
            bar(part, 4)
    assert ended == ([] if seconds < 1 else [101.0])
