"""What the commands do, for Python too: examine a model file, perform its studies, write the results."""

from linkwright.app.job import Examined, Job, examine_file, perform, write

__all__ = ["Examined", "Job", "examine_file", "perform", "write"]
