"""The cycle: a file's motion, with its measures and its verification."""
