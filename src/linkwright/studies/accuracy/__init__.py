"""The accuracy study: what dimensional errors and clearances do to any output, and which tolerance to tighten."""
