#!/usr/bin/env python3
"""Makes the virtual environment in which the service runs.

    build.py [--tests]

A first run makes .tools/nest-venv in the root of the repository and installs NEST (from PyPI) into it; the
packages of this folder and of peers/python-pure are on its path. `--tests` adds what the tests and the sweep
need. A further run changes nothing. Needs Python 3.11 or later with pip and venv.
"""

import subprocess
import sys
import sysconfig
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
VENV = FOLDER.parents[1] / ".tools" / "nest-venv"
PYTHON = VENV / "bin" / "python"

#: What the service needs.
PACKAGES = ["nest-simulator==3.10.0"]
#: What its tests and its sweep need besides.
TEST_PACKAGES = ["pytest>=8,<10", "matplotlib>=3.9,<4", "eclipse-zenoh==1.10.2", "websockets>=15,<17"]


def main(args: list[str]) -> None:
    """Installs what is missing."""
    if sys.version_info < (3, 11):
        sys.exit("build.py needs Python 3.11 or later")
    if args not in ([], ["--tests"]):
        sys.exit(__doc__)
    set_up("packages", PACKAGES)
    if args:
        set_up("test-packages", TEST_PACKAGES)
    paths = {"base": str(VENV), "platbase": str(VENV)}
    site = Path(sysconfig.get_path("purelib", "venv", paths))
    (site / "ncp_nest.pth").write_text(f"{FOLDER}\n{FOLDER.parent / 'python-pure'}\n")


def set_up(name: str, packages: list[str]) -> None:
    """Installs packages into the environment, unless it has them already."""
    stamp = VENV / f"{name}.txt"
    wanted = "\n".join(packages)
    if stamp.is_file() and stamp.read_text() == wanted and PYTHON.exists():
        return
    if not PYTHON.exists():
        run([sys.executable, "-m", "venv", "--clear", VENV])
    run([PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *packages])
    stamp.write_text(wanted)


def run(command: list[object]) -> None:
    """Runs a command, and ends as it ends if it fails."""
    code = subprocess.run(list(map(str, command)), cwd=FOLDER, check=False).returncode
    if code:
        sys.exit(code)


if __name__ == "__main__":
    main(sys.argv[1:])
