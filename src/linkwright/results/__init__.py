"""Results: runs over time, named arrays with units, the certificate, typed failures."""

from linkwright.results.certificate import Certificate, certify
from linkwright.results.result import Result
from linkwright.results.run import Run

__all__ = ["Certificate", "Result", "Run", "certify"]
