"""What this package is built for: the wire version and the contract hash of chapter 2 of the text."""

WIRE_VERSION = "0.5"
"""The wire version of this package [NCP-VER-021]."""

CONTRACT_HASH = "24e8e6e31e1dec8a"
"""The contract hash of the schema [NCP-VER-020]."""
