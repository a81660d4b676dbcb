"""NC code of plate cams: the cutter's path, posts, and the proof that reads the code back."""
