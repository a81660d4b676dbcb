"""What an outcome shows, before anybody renders it: texts, tables, charts, and the files that it makes."""
