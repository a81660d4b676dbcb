"""The reactions study: structures that stand."""
