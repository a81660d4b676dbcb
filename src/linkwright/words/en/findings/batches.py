"""Problems of batches of parameter sets."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "batch.head": (
        "The column heading '{head}' can't be read.",
        "Write the name of a parameter with its unit in brackets, for example x1 [mm].",
    ),
    "batch.no-name": (
        "The file has no column 'name'. Its columns: {known}.",
        "Add the column name with a name for each row; 'linkwright new hinge --table' writes a file to start from.",
    ),
    "batch.parameter": (
        "The model '{model}' of this row has no parameter '{name}'.",
        "Leave the cell blank, or name another model in the column model.",
    ),
    "batch.empty": (
        "The file {file} has no rows below its headings.",
        "Add one for each mechanism; 'linkwright new hinge --table' writes a file to start from.",
    ),
    "batch.cells": (
        "The row has {count} cells, but there are {heads} columns.",
        "Remove the extra cells; a comma inside a cell needs quotes around the cell.",
    ),
    "batch.name": (
        "The name '{name}' can't be used at the start of file names.",
        "Use letters, digits, spaces, dots, hyphens and underscores, at most 60, starting with a letter or digit.",
    ),
    "batch.name-twice": (
        "The name '{name}' is already used in line {first}.",
        "Give each row a name of its own; upper-case and lower-case letters count as the same.",
    ),
    "batch.model": (
        "There is no model '{name}' in the gallery, and no such file beside this one.",
        "{near} Or write the path of a model file.",
    ),
}
