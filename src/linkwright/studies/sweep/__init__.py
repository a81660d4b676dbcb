"""The sweep: many samples of a mechanism's parameters."""
