"""Problems of tables."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "table.source": (
        "A table needs either a file or points.",
        "Give file with x and y, or points: [[x, y], ...].",
    ),
    "table.columns": (
        "The columns of the file aren't given.",
        "Add x and y as 'COLUMN UNIT', for example x: angle deg.",
    ),
    "table.inline-columns": (
        "{given} names a column of a file, but the points are given here.",
        "Remove it; write units with the points, or use the declared units.",
    ),
    "table.place": (
        "The file '{file}' isn't in the model's folder.",
        "Put it in the model's folder, or below, and write its name without '..' and without a drive or root.",
    ),
    "table.unreadable": (
        "The file {file} can't be read: {reason}.",
        "Put the file beside the model, with exactly this name, and allow reading it.",
    ),
    "table.too-large": (
        "The file {file} is larger than {limit} bytes, the limit.",
        "Remove rows and columns; in a drawing, remove everything except the path.",
    ),
    "table.not-text": (
        "The file {file} isn't valid UTF-8 text: byte {at} (line {line}) isn't allowed.",
        "Save it as a CSV file in UTF-8, not in UTF-16, GBK or a spreadsheet format.",
    ),
    "table.encoding": (
        "The file {file} isn't valid UTF-8 (byte {at}, line {line}); it looks like {encoding}.",
        "Save it as UTF-8: in a spreadsheet under 'Save as', 'CSV UTF-8'.",
    ),
    "table.bad-line": (
        "The file {file} can't be read as CSV at line {line}: {reason}.",
        "Check this line and those above for an unmatched quotation mark.",
    ),
    "table.empty": (
        "The file {file} is empty.",
        "Write the names of the columns in the first line and numbers in the following lines, separated by commas.",
    ),
    "table.separator": (
        "The file {file} separates its columns with {sign}; commas are expected.",
        "Save it with commas between the columns and decimal points in the numbers.",
    ),
    "table.column-twice": (
        "The file {file} has several columns called '{name}'.",
        "Give each a name of its own, or remove those that aren't needed.",
    ),
    "table.no-column": (
        "The file has no column '{name}'. Its columns: {known}.",
        "Correct x and y, or the first line of the file.",
    ),
    "table.not-number": (
        "Line {row} of the file has '{given}' in the column '{name}', where a finite number below 1e40 is expected.",
        "Correct the cell; use decimal points, and no units.",
    ),
    "table.long": (
        "The file has more than {limit} rows.",
        "Remove rows: the spline between them needs few.",
    ),
    "table.short": (
        "The table has {given} points; the curve between them needs at least {wanted}.",
        "Add points, or write between: linear.",
    ),
    "table.order": (
        "The x values must increase (row {row}).",
        "Sort the points, and give each x value once.",
    ),
    "table.uneven": (
        "Some points are so close together, compared with the others, that no smooth curve passes through them.",
        "Remove the closest points, or write between: linear.",
    ),
    "table.period": (
        "The points span more than one period.",
        "Give a longer period, or fewer points.",
    ),
    "table.not-closed": (
        "The points span one whole period, but the last value differs from the first.",
        "Make the two equal, or remove the last point.",
    ),
}
