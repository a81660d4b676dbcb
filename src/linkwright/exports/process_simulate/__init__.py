"""Joint functions for Process Simulate, and the sheet that goes with them."""
