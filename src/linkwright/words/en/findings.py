"""What findings say: `CODE.what` and `CODE.mend`, with the data of the finding filled in."""

FINDINGS: dict[str, str] = {}
