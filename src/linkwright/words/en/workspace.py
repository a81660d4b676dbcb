"""The words of the workspace study's tables, pictures and progress."""

WORKSPACE: dict[str, str] = {
    "workspace.sentence": "Workspace of {point}: {count} regions (boundary error below {chord} {unit}).",
    "workspace.certified": (
        "Areas lie between the bounds in the table: enclosures of all poses that come to a place prove that, whatever "
        "curves are drawn."
    ),
    "workspace.counts.certified": "The numbers of parts and holes are certified, but for such narrower than {finest} {unit}.",
    "workspace.counts.open": (
        "The numbers of parts and holes are certified but where the table says otherwise: there some may be joined, or "
        "missing."
    ),
    "workspace.searched": (
        "{count} of the regions are searched for: not all poses that come to a place are known, so that a "
        "part may be missing and no bounds of the area are known."
    ),
    "workspace.count-open": "{count}, not certified",
    "workspace.grade.enclosed": "certified",
    "workspace.grade.searched": "searched",
    "workspace.grade.contradicted": "not certified",
    "workspace.sentence.curves": "With one drive {point} moves along a curve: {count} of them.",
    "workspace.sentence.none": "Nothing was computed.",
    "workspace.rough": "Near points where curves end or touch, pieces of at most {rough} {unit} couldn't be refined.",
    "workspace.one-mode": "the only one",
    "workspace.table.regions": "Regions by assembly mode",
    "workspace.table.union": "All modes together",
    "workspace.table.overlap": "What two modes both reach",
    "workspace.table.turning": "Where a drive goes through all of its range",
    "workspace.column.drive": "Drive",
    "workspace.column.intervals": "While the other is at",
    "workspace.column.other": "Other drive",
    "workspace.column.signs": "Branches",
    "workspace.everywhere": "any value",
    "workspace.nowhere": "no value",
    "workspace.every-mode": "any",
    "workspace.table.curves": "Curves by assembly mode",
    "workspace.column.mode": "Mode",
    "workspace.column.modes": "Modes",
    "workspace.column.area": "Area",
    "workspace.column.within": "Lies between",
    "workspace.column.grade": "Grade",
    "workspace.column.perimeter": "Perimeter",
    "workspace.column.holes": "Holes",
    "workspace.column.parts": "Parts",
    "workspace.column.x": "x",
    "workspace.column.y": "y",
    "workspace.column.unit": "Unit",
    "workspace.column.length": "Length",
    "workspace.column.both": "Area reached by several",
    "workspace.column.share": "Share of the smaller",
    "workspace.picture": "Where {point} gets to{values}",
    "workspace.for": " for {values}",
    "term.for-values": " for {values}",
    "workspace.kind.region": "reached in the mode {mode}",
    "workspace.kind.curve": "path in the mode {mode}",
    "workspace.kind.singular": "dead positions of the output: the determinant of d({point}.x, {point}.y)/d({drives}) is zero",
    "workspace.kind.modes": "uncertain positions, where two modes meet: the determinant of a closure is zero ({groups})",
    "workspace.kind.pins": "the outer pins of a group meet: the determinant of its closure is zero as well",
    "workspace.kind.limit": "an end of a drive's range",
    "workspace.note": "Plane coordinates in {unit} in the fixed frame of the mechanism, x to the right and y up; not longitude and latitude.",
}
