"""Motion and forces of a mechanism on symbols: every signal as an expression, and the programs that kernels run."""
