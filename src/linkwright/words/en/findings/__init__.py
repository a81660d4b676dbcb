"""Texts of problems. Quantities in their data have units; the few that don't are in SI, and the text says so."""
