#!/usr/bin/env python3
"""Builds the module ncp, and installs it into a virtual environment of the repository's.

    build.py [--tests]

A first run makes .tools/python-venv and installs maturin and numpy (from PyPI) into it. Every run builds
the wheel (.tools/python-wheels) and installs it. Needs Python 3.9 or later with pip and venv, and cargo.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
TOOLS = ROOT / ".tools"
VENV = TOOLS / "python-venv"
WHEELS = TOOLS / "python-wheels"
BIN = VENV / ("Scripts" if os.name == "nt" else "bin")
PYTHON = BIN / "python"

#: What builds the wheel, as pyproject.toml has it; what the adapter hands columns over with.
PACKAGES = ["maturin==1.16.0", "numpy>=1.22,<3"]
#: What its tests need besides.
TEST_PACKAGES = ["mypy>=1.11,<3"]


def main(args):
    if sys.version_info < (3, 9):
        sys.exit("build.py needs Python 3.9 or later")
    if args not in ([], ["--tests"]):
        sys.exit(__doc__)
    set_up("packages", PACKAGES)
    if args:
        set_up("test-packages", TEST_PACKAGES)
    shutil.rmtree(WHEELS, ignore_errors=True)
    # maturin takes the licences from beside pyproject.toml.
    for licence in ROOT.glob("LICENSE-*"):
        shutil.copy(licence, FOLDER)
    # maturin looks for a Python on the path.
    environment = {**os.environ, "PATH": f"{BIN}{os.pathsep}{os.environ.get('PATH', '')}"}
    maturin = [BIN / "maturin", "build", "--release", "--quiet", "--interpreter", PYTHON, "--out", WHEELS]
    run(maturin, env=environment)
    pip("--no-index", "--no-deps", "--force-reinstall", *WHEELS.glob("*.whl"))


def set_up(name, packages):
    """Installs packages into the environment, unless it has them already."""
    stamp = VENV / f"{name}.txt"
    wanted = "\n".join(packages)
    if stamp.is_file() and stamp.read_text() == wanted and PYTHON.exists():
        return
    if not PYTHON.exists():
        run([sys.executable, "-m", "venv", "--clear", VENV])
    pip(*packages)
    stamp.write_text(wanted)


def pip(*args):
    run([PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *args])


def run(command, **options):
    code = subprocess.run(list(map(str, command)), cwd=FOLDER, check=False, **options).returncode
    if code:
        sys.exit(code)


if __name__ == "__main__":
    main(sys.argv[1:])
