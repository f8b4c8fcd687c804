"""`python -m extrados ...` is the command `extrados ...`, where it is installed: the package holds the analyses, and not the command's screen, folders and
page."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence

NAMED_BY = "EXTRADOS_COMMAND"
"""Variable of the environment that names the command where it is not on PATH, or not the one that is meant."""


def command() -> str | None:
    """Path of the command; None where there is none."""
    return shutil.which(os.environ.get(NAMED_BY) or "extrados")


def missing() -> str:
    """What to do where there is no command."""
    named = os.environ.get(NAMED_BY)
    what = f"{NAMED_BY} names {named!r}, which is no program" if named else "the command extrados is not on PATH"
    return f"""error: {what}
  help: from a clone, with a Rust toolchain: cargo install --path crates/cli
        or set {NAMED_BY} to its path
        from Python without it: extrados.Bridge.read("bridge.toml").collapse()"""


def main(arguments: Sequence[str]) -> int:
    """Becomes the command; gives its exit status where the system has no way to become another program, and 2 where there is no command."""
    program = command()
    if program is None:
        sys.stderr.write(missing() + "\n")
        return 2
    if os.name == "posix":
        os.execv(program, [program, *arguments])
    return subprocess.call([program, *arguments])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
