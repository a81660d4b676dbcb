"""Common to all tests: reproducible property tests, without a deadline; the scripts of benchmarks/ by plain names;
the garbage collector passes over what was imported and collected."""

from __future__ import annotations

import gc
import os
import sys
from pathlib import Path

from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers

ROOT = Path(__file__).parents[1]
sys.path.append(str(ROOT / "benchmarks"))
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy comes: every worker has but one core

settings.register_profile(
    "linkwright",
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much, HealthCheck.data_too_large],
)
settings.load_profile("linkwright")
# Hypothesis also tries the constants of all modules loaded so far: then a test's examples, and the time that they take,
# would depend on which other tests are collected.
if hasattr(providers, "_get_local_constants") and hasattr(providers, "_local_constants"):
    providers._get_local_constants = lambda: providers._local_constants


def pytest_collection_finish() -> None:
    """Modules and tests stay to the end: to look through them for garbage again and again takes 6 % of the time."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(20_000, 20, 20)
