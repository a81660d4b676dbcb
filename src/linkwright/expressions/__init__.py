"""The expressions of files: their language, units and dimensions, and the fields of entries that hold them."""
