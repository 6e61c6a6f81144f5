"""What the contract tests share: where things are, and which files are committed."""

import os
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# Folders of a working copy that git ignores; only needed where there is no git (a source archive).
PRODUCED = re.compile(r"(^|/)(\.git|\.cache|build[^/]*|__pycache__|cases)(/|$)|results\.db|\.lock$|manager\.log$")


def committed_files():
    """Paths relative to the root of all files that belong to the project, new ones not yet committed included."""
    listing = subprocess.run(
        ["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"], capture_output=True)
    if listing.returncode == 0:
        names = [name for name in listing.stdout.decode().split("\0") if name]
    else:
        names = [str(path.relative_to(ROOT)) for path in ROOT.rglob("*") if path.is_file()]
        names = [name for name in names if not PRODUCED.search(name)]
    return [Path(name) for name in sorted(set(names)) if (ROOT / name).is_file()]


def text_of(path):
    return (ROOT / path).read_text(encoding="utf-8")


def section(markdown, heading):
    """The lines below a heading, up to the next one of any level."""
    found = re.search(rf"^#+ {re.escape(heading)}$\n(.*?)(?=^#+ |\Z)", markdown, re.MULTILINE | re.DOTALL)
    if not found:
        raise AssertionError(f"no heading '{heading}'")
    return found.group(1)


def run_softwall(*arguments):
    """Standard output of the manager that was just built."""
    program = os.environ["SOFTWALL"]
    done = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60)
    if done.returncode != 0:
        raise AssertionError(f"softwall {' '.join(map(str, arguments))} ended with {done.returncode}: {done.stderr}")
    return done.stdout
