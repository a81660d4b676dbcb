"""Problems of files and their text."""

PROBLEMS: dict[str, tuple[str, str]] = {
    "file.unreadable": (
        "The file {file} can't be read: {reason}.",
        "Check its name and your permission to read it.",
    ),
    "file.irregular": (
        "{file} is {kind}; only regular files can be read.",
        "Give the name of a regular file, or of a link to one.",
    ),
    "file.not-found": (
        "The file {file} doesn't exist.",
        "{hint}",
    ),
    "file.unwritable": (
        "Can't write to {file}: {reason}.",
        "Choose another folder with --out, or allow writing to this one.",
    ),
    "file.package-fails": (
        "The package {package} can't be loaded: {reason}",
        "If the message is about the home folder, set the variable HOME to an existing folder; otherwise reinstall "
        "the package.",
    ),
    "file.no-temporary": (
        "No folder for temporary files is available: {reason}.",
        "Set one that can be written to: TMPDIR=FOLDER linkwright ... (TEMP on Windows).",
    ),
    "file.needs-package": (
        "This needs the package {package}, which isn't installed.",
        'Install it: pip install "linkwright[{extra}]".',
    ),
    "file.unwritten": (
        "Not written, since the package {package} isn't installed: {files}.",
        'Install it: pip install "linkwright[{extra}]"; in a clone, with the Python of .venv: '
        'python -m pip install -e ".[{extra}]".',
    ),
    "file.too-large": (
        "The file is larger than {limit} bytes, the limit for a model file.",
        "Put long tables into CSV files beside the model and name them under tables.",
    ),
    "file.binary": (
        "The file isn't valid UTF-8 text (byte {at}); it may be a binary file or saved in another encoding, such as "
        "GBK.",
        "Save the model as plain text in UTF-8.",
    ),
    "file.encoding": (
        "The file isn't valid UTF-8 (byte {at}); it looks like {encoding}.",
        "Save it as UTF-8: in Notepad and most editors under 'Save as', 'Encoding'.",
    ),
    "file.read-as": (
        "The file isn't UTF-8; it is read as {encoding}.",
        "Save it as UTF-8: in Notepad and most editors under 'Save as', 'Encoding'. If names look wrong in the results, "
        "the file has another encoding.",
    ),
    "file.wide": (
        "The file has full-width characters where half-width ones are needed: {given}",
        "{hint}",
    ),
    "file.blank": (
        "The line has full-width or non-breaking spaces, shown as ␣: {given}",
        "{hint}",
    ),
    "file.brackets": (
        "A list is written in square brackets: {given}",
        "Write {meant}.",
    ),
    "file.colon": (
        "A space is missing after the colon: {given}",
        "{hint}",
    ),
    "file.equals": (
        "A value must follow a colon, not '=': {given}",
        "{hint}",
    ),
    "file.decimal-comma": (
        "YAML splits '{text}' at the comma; numbers need a decimal point.",
        "Write {meant}.",
    ),
    "file.character": (
        "The text contains a control character.",
        "Type the text again, without \\x, \\u or \\0 escapes.",
    ),
    "file.empty": (
        "The file is empty.",
        "Start it with 'linkwright: 1', then add links and drives; see docs/file-format.md.",
    ),
    "file.documents": (
        "A second YAML document starts here (after '---' or '...'); a model file can contain only one.",
        "Remove the marker, or split the file.",
    ),
    "file.mapping": (
        "The file has no 'key: value' entries at its top level.",
        "Start it with 'linkwright: 1', then add links and drives; see docs/file-format.md.",
    ),
    "file.version": (
        "The file doesn't state the format version {known} (given: {given}).",
        "Write 'linkwright: {known}' as its first line.",
    ),
    "file.yaml": (
        "The file can't be read as YAML here: {reason}.",
        "Check this line and the line above for an open bracket or quote, a missing colon, or wrong indentation.",
    ),
    "file.tab": (
        "The line contains a tab; YAML allows only spaces here.",
        "Replace the tab with spaces; most editors can insert spaces for the tab key.",
    ),
    "file.quote": (
        "YAML can't read a value that starts like '{value}' as text.",
        "Put the value in double quotes.",
    ),
    "file.comma": (
        "YAML splits '{text}' at the commas because it isn't quoted.",
        'Put the expression in quotes: "{text}".',
    ),
    "file.alias": (
        "'{mark}' is a YAML anchor or alias, which model files don't support.",
        "Use a parameter instead; if the value is meant to begin with '*' or '&', put it in double quotes.",
    ),
    "file.tag": (
        "'{tag}' is a YAML type tag, which model files don't support.",
        "Remove the tag; if the value is meant to begin with '!', put it in double quotes.",
    ),
    "file.key": (
        "There is a list or mapping before a colon, where a name is expected.",
        "Write a plain name there; put a value in braces or brackets after the colon.",
    ),
    "file.depth": (
        "Values are nested more than {limit} levels deep.",
        "Model files need at most five levels: check for an extra bracket.",
    ),
    "file.duplicate": (
        "'{name}' is given twice in the same place, first in line {first}.",
        "Rename or remove one of the two.",
    ),
    "file.too-many": (
        "There are {count} entries here; a model file can have at most {limit}.",
        "Split the model; put long tables into CSV files.",
    ),
    "file.long": (
        "This text is longer than {limit} characters.",
        "Shorten it; define parts of a long expression as parameters.",
    ),
    "file.more": (
        "At least {count} more problems were found.",
        "Fix those above first; many of the others may result from them.",
    ),
    "file.missing": (
        "'{name}' is missing here.",
        "Add it. Keys of this kind of entry: {known}.",
    ),
    "file.unknown-key": (
        "Unknown key '{name}'.",
        "{near} Otherwise remove it.",
    ),
    "file.kind": (
        "'{name}: {kind}' isn't allowed here: the kind of an entry is written as a key.",
        "{near}",
    ),
    "file.kinds": (
        "An entry has one kind; here are keys of several: {keys}.",
        "Keep the keys of one kind, and write an entry of its own for the other.",
    ),
    "file.expected": (
        "Expected {wanted}, got {given}.",
        "{hint}",
    ),
    "file.not-finite": (
        "{given} isn't a finite number.",
        "Give a finite number.",
    ),
    "file.bad-name": (
        "'{name}' isn't a valid name.",
        "{hint}",
    ),
    "file.reserved-name": (
        "'{name}' is a reserved name: t is the time, pi the number, start and end are the ends of a run.",
        "Choose another name.",
    ),
    "builder.twice": (
        "'{name}' was added to the builder twice.",
        "Rename or remove one of the two.",
    ),
    "file.exists": (
        "The file {file} already exists.",
        "Give another name with --out, or add --force to overwrite it.",
    ),
    "gallery.unknown": (
        "The gallery has no model called '{name}'.",
        "{near} 'linkwright new' lists all models.",
    ),
}
