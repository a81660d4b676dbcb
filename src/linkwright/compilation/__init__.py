"""From a mechanism to one that is ready to run: the stages as a list (`pipeline`), and each by itself (`stages`)."""

from linkwright.compilation.pipeline import Prepared, compile_mechanism, compile_model, compile_named, examine, prepare
from linkwright.compilation.stages import Uses

__all__ = ["Prepared", "Uses", "compile_mechanism", "compile_model", "compile_named", "examine", "prepare"]
