"""Joint functions for Process Simulate: each dependent joint's value as text in the driving joint's."""

from linkwright.exports.process_simulate.functions import JointFunction, JointFunctions
from linkwright.exports.process_simulate.target import ProcessSimulate

__all__ = ["JointFunction", "JointFunctions", "ProcessSimulate"]
