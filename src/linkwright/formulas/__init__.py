"""Motions as text: piecewise formulas in the time t, in the words and units of the tools that take them."""
