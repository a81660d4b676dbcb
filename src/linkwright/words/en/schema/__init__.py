"""Descriptions in the JSON Schema of model files, by class and key."""
