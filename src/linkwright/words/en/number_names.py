"""Numbers of a file as a page names them: in English by their places in the file."""

TEXTS: dict[str, str] = {
    "number.point.frame": "{link}.points.{point}.{part}",
    "number.point.link": "{link}.points.{point}.{part}",
    "number.sketch": "{point}.{part}",
    "number.com": "{link}.com.{part}",
    "number.line.0": "{joint}.line.0",
    "number.line.1": "{joint}.line.1",
    "number.window.0": "{window}.0",
    "number.window.1": "{window}.1",
    "number.of.mass": "{name}.mass",
    "number.of.inertia": "{name}.inertia",
    "number.of.speed": "{name}.speed",
    "number.of.start": "{name}.start",
    "number.of.stiffness": "{name}.stiffness",
    "number.of.free": "{name}.free",
    "number.of.damping": "{name}.damping",
    "number.of.radius": "{name}.radius",
    "number.of.base": "{name}.base",
    "number.of.roller": "{name}.roller",
}
