"""The contract hash (sections 2.2 and 2.3 of the text)."""

import re

from .errors import ContractError
from .identity import CONTRACT_HASH
from .version import check_version


def contract_status(peer_hash):
    """`match`, `mismatch`, or `not_advertised` for `None`."""
    if peer_hash is None:
        return "not_advertised"  # [NCP-VER-022]
    return "match" if peer_hash == CONTRACT_HASH else "mismatch"  # [NCP-VER-023] [NCP-VER-024]


def verify_contract(peer_hash):
    """Raises `ContractError` unless the hash matches: the opt-in for who wants that."""
    status = contract_status(peer_hash)
    if status != "match":
        raise ContractError(f"the contract hash is {status}")  # [NCP-VER-026] [NCP-VER-028]


def negotiate(version, peer_hash):
    """The contract status of a peer whose version is compatible; else a `VersionError`."""
    check_version(version, strict=True)  # [NCP-VER-030]
    return contract_status(peer_hash)  # [NCP-VER-031]


def canonical_text(proto):
    """The canonical text of a schema."""
    without_comments = _COMMENT_OR_STRING.sub(lambda match: match.group(1) or "", proto)
    lines = (line.strip() for line in without_comments.split("\n"))
    dropped = ("syntax", "package ", "import ", "option ")
    return "\n".join(line for line in lines if line and not line.startswith(dropped))


def hash_of(proto):
    """The contract hash of a schema: FNV-1a, 64 bits, of its canonical text."""
    value = 0xCBF29CE484222325
    for byte in canonical_text(proto).encode("utf-8"):
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return f"{value:016x}"


_COMMENT_OR_STRING = re.compile(
    r"""("(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*')|//[^\n]*|/\*.*?\*/""", re.DOTALL
)
