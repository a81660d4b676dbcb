"""The same in Simplified Chinese."""
