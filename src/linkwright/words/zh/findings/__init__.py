"""Texts of problems."""
