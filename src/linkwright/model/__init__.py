"""The file format: documents and mechanisms, their quantities, names and signals; files read and written."""
