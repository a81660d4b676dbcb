"""The workspace study: where a mechanism with two drives reaches, how well, and the way back."""
