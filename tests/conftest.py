"""Common to all tests: reproducible property tests, without a deadline; the scripts of benchmarks/ by plain names;
a folder of compiled kernels that processes share and the user's own isn't touched by."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from hypothesis import HealthCheck, settings

ROOT = Path(__file__).parents[1]
sys.path.append(str(ROOT / "benchmarks"))
os.environ.setdefault("LINKWRIGHT_CACHE", str(ROOT / ".pytest_cache" / "linkwright"))

settings.register_profile(
    "linkwright",
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much, HealthCheck.data_too_large],
)
settings.load_profile("linkwright")
