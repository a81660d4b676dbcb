"""The version, at the bottom of the tree: whatever writes it asks here."""

__version__ = "0.1.0"
