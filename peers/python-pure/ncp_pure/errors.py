"""The errors of this package: every refusal is an `NcpError`, and nothing else leaves it.

Each carries a `code` from section 5 of the peer protocol, which says why, and a message for people.
"""


class NcpError(ValueError):
    """Something was refused. `code` says why in one word."""

    code = "invalid"

    def __init__(self, message, code=None):
        super().__init__(message)
        if code is not None:
            self.code = code


class _AtField(NcpError):
    """An error that knows the path of the field at which it arose."""

    def __init__(self, code, message):
        super().__init__(message, code)
        self.path = []

    def within(self, name):
        """The same error, seen from the message or list that holds `name`."""
        self.path.insert(0, str(name))
        return self

    def __str__(self):
        message = super().__str__()
        return f"{'.'.join(self.path)}: {message}" if self.path else message


class DecodeError(_AtField):
    """A frame was rejected: `malformed`, `type`, `kind`, `missing`, `value`, `provenance`, `limit`, `version`."""


class EncodeError(_AtField):
    """A message cannot be written: the codes of `DecodeError`, or `non_finite`."""


class VersionError(NcpError):
    """A version is malformed, or incompatible where that is not allowed."""

    code = "version"


class ContractError(NcpError):
    """`verify_contract` rejected a contract hash."""

    code = "contract"


class KeyExpressionError(NcpError):
    """A segment, a realm or a key expression is invalid."""

    code = "key"


class BulkError(NcpError):
    """A BulkBlock, its columns or the arrays of an observation are invalid."""

    code = "block"


class ReplyError(NcpError):
    """A reply does not fit its request, or reports a failure."""

    code = "reply"


class ConfigError(NcpError):
    """An object cannot be built from its settings."""


class SimulationError(NcpError):
    """A network cannot be built, or a step of it cannot be done."""
