"""The limits study: ranges of drives, limit positions, strokes, transmission angles."""
