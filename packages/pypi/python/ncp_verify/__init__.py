"""Finds the program ncp-verify that was installed with this package."""

import os
import sys
import sysconfig
from pathlib import Path

__all__ = ["program"]


def program() -> str:
    """The path of the program; FileNotFoundError if the installation has lost it."""
    name = "ncp-verify.exe" if os.name == "nt" else "ncp-verify"
    places = [folder / name for folder in _folders()]
    for place in places:
        if place.is_file():
            return str(place)
    raise FileNotFoundError(f"the program ncp-verify is not at {' nor '.join(map(str, places))}")


def _folders():
    """Where an installer puts the scripts of this package: of the environment, of the user, or beside a target."""
    yield Path(sysconfig.get_path("scripts"))
    user = "nt_user" if os.name == "nt" else "osx_framework_user" if sys.platform == "darwin" else "posix_user"
    if user in sysconfig.get_scheme_names():
        yield Path(sysconfig.get_path("scripts", user))
    # pip install --target FOLDER
    yield Path(__file__).resolve().parents[1] / "bin"
