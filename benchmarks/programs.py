"""Making programs of all signals: ``python benchmarks/programs.py [--before SRC] [--repeat 7] [MODEL ...]``.

Of each model the values, with rates, the tangents, with rates: processor time (ms) and instructions. ``--before``
measures another state of the package in alternation, such as ``git worktree add ../before REVISION`` and
``--before ../before/src``; then ratios are printed, too.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
MODELS = ("paper_feeder", "jansen_leg", "walker_legs", "class_four", "platform")
KINDS = ("values", "rates", "tangents", "tangents with rates")
Figures = dict[str, dict[str, tuple[float, int]]]


def measured(models: Sequence[str]) -> Figures:
    """Times (ms) and instructions by model and kind of program, in this process."""
    from linkwright.compilation import compile_mechanism
    from linkwright.graph.tangent import tangent
    from linkwright.model.document import load

    found: Figures = {}
    for model in models:
        compiled = compile_mechanism(load(EXAMPLES / f"{model}.yaml"))
        names = [signal.text for signal in compiled.quantities.signals.all() if signal.attribute != "arm"]

        makers: tuple[Callable[[], int], ...] = (
            lambda graph, names=names: graph.program(names).size,
            lambda graph, names=names: graph.program(names, rates=True).size,
            lambda graph, names=names: tangent(graph, names).size,
            lambda graph, names=names: tangent(graph, names, True).size,
        )  # type: ignore[assignment]
        for kind, make in zip(KINDS, makers, strict=True):
            graph = compile_mechanism(load(EXAMPLES / f"{model}.yaml")).graph
            start = time.process_time()
            size = make(graph)  # type: ignore[call-arg]
            found.setdefault(model, {})[kind] = 1e3 * (time.process_time() - start), size
    return found


def in_process(models: Sequence[str], source: Path | None) -> Figures:
    """The same by a process with the package of ``source`` if one is given."""
    environment = {**os.environ} | ({"PYTHONPATH": str(source)} if source else {})
    command = [sys.executable, __file__, "--once", *models]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    figures: Figures = json.loads(done.stdout)
    return figures


def main(arguments: Sequence[str] | None = None) -> None:
    """Print medians, and their ratios to those of the state before."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", nargs="*", default=[*MODELS])
    parser.add_argument("--before", type=Path, help="the src folder of another state")
    parser.add_argument("--repeat", type=int, default=7)
    parser.add_argument("--once", action="store_true", help="measure once and print JSON")
    options = parser.parse_args(arguments)
    if options.once:
        print(json.dumps(measured(options.models)))
        return
    states = {"now": None} | ({"before": options.before.resolve()} if options.before else {})
    rounds = [{state: in_process(options.models, of) for state, of in states.items()} for _ in range(options.repeat)]
    for model in options.models:
        for kind in KINDS:
            medians = {state: statistics.median(one[state][model][kind][0] for one in rounds) for state in states}
            sizes = {state: rounds[0][state][model][kind][1] for state in states}
            ratio = f"   {medians['now'] / medians['before']:.2f} of the time before" if "before" in medians else ""
            row = "   ".join(f"{state} {medians[state]:7.1f} ms {sizes[state]:6d}" for state in states)
            print(f"{model:14s} {kind:20s} {row}{ratio}")


if __name__ == "__main__":
    main()
