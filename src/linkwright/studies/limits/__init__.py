"""The limits study: ranges of drives, dead centres, strokes, transmission angles."""
