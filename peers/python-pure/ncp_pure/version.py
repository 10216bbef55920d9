"""The version guard (section 2.1 of the text)."""

import re

from .errors import VersionError
from .identity import WIRE_VERSION

_VERSION = re.compile(r"([0-9]+)(?:\.([0-9]+))?")


def check_version(version, strict=False):
    """Whether a peer's version is compatible with `WIRE_VERSION`.

    A malformed version is a `VersionError` [NCP-VER-001], and so is an incompatible one when
    `strict` [NCP-VER-006].
    """
    theirs = _parse(version)
    own = _parse(WIRE_VERSION)
    # [NCP-VER-003] [NCP-VER-004] [NCP-VER-005]
    compatible = theirs == own if own[0] == "0" else theirs[0] == own[0]
    if strict and not compatible:
        raise VersionError(f"{version[:40]} is not compatible with {WIRE_VERSION}")
    return compatible


def _parse(version):
    """Major and minor without leading zeros; as strings they have no overflow [NCP-VER-009]."""
    match = _VERSION.fullmatch(version)
    if match is None:
        raise VersionError(f"{version[:40]!r} is not a version")
    return tuple((part or "0").lstrip("0") or "0" for part in match.groups())  # [NCP-VER-002]
