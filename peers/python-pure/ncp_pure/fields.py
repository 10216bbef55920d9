"""The types of the tables in section 1.8 of the text, and the messages that are made of them.

A type reads a JSON value (`read`, which raises `DecodeError`) and writes one (`write`, which
raises `EncodeError`). Both judge by the same rules, so that no encoder writes what every decoder
rejects [NCP-WIRE-091].
"""

from math import isfinite

from .errors import DecodeError, EncodeError, KeyExpressionError
from .keys import validate_segment

MAX_INTEGER = 2**53 - 1
"""The largest magnitude of an integer field."""

MAX_ITEMS = 4096
"""The most entries of a map, and the most items of an array whose items are not numbers."""


class Type:
    """One type of the tables. Most read and write by the same `check`."""

    def check(self, value, error):
        """The value as it is kept, or `error(code, message)` raised."""
        raise NotImplementedError

    def read(self, value):
        return self.check(value, DecodeError)

    def write(self, value):
        return self.check(value, EncodeError)


class Plain(Type):
    """A string or a boolean."""

    def __init__(self, python_type, name):
        self.python_type = python_type
        self.name = name

    def check(self, value, error):
        if type(value) is not self.python_type:
            raise error("type", f"not a {self.name}")  # [NCP-WIRE-020] [NCP-WIRE-021]
        return value


class Integer(Type):
    """An integer within ±(2^53 − 1)."""

    def check(self, value, error):
        if type(value) is not int:
            raise error("type", "not an integer")  # [NCP-WIRE-010] the reader keeps 1.0 apart
        if abs(value) > MAX_INTEGER:
            raise error("value", "beyond ±(2^53 − 1)")  # [NCP-WIRE-011]
        return value


class Number(Type):
    """A double. A message in memory may hold one that is not finite; a frame cannot."""

    def check(self, value, error):
        if type(value) not in (float, int):
            raise error("type", "not a number")
        try:
            return float(value)
        except OverflowError:
            raise error("value", "beyond the largest double") from None

    def write(self, value):
        value = super().write(value)
        if not isfinite(value):
            raise EncodeError("non_finite", f"{value} has no JSON form")  # [NCP-WIRE-086]
        return value


class Numbers(Type):
    """[number]: as many as the frame has room for [NCP-WIRE-069]."""

    def check(self, value, error):
        if not isinstance(value, list):
            raise error("type", "not an array")
        types = set(map(type, value))
        if not types <= {float, int}:
            raise error("type", "an item is not a number")
        try:
            return list(map(float, value)) if int in types else value
        except OverflowError:
            raise error("value", "an item is beyond the largest double") from None

    def write(self, value):
        value = super().write(value)
        if not all(map(isfinite, value)):
            raise EncodeError("non_finite", "an item has no JSON form")  # [NCP-WIRE-086]
        return value


class Integers(Type):
    """[integer]: as many as the frame has room for [NCP-WIRE-069]."""

    def check(self, value, error):
        if not isinstance(value, list):
            raise error("type", "not an array")
        if not set(map(type, value)) <= {int}:
            raise error("type", "an item is not an integer")
        if value and (max(value) > MAX_INTEGER or min(value) < -MAX_INTEGER):
            raise error("value", "an item is beyond ±(2^53 − 1)")
        return value


class Optional(Type):
    """A type or absent, which is `None` here and `null` in a frame [NCP-WIRE-022] [NCP-WIRE-082]."""

    def __init__(self, item):
        self.item = item

    def read(self, value):
        return None if value is None else self.item.read(value)

    def write(self, value):
        return None if value is None else self.item.write(value)


class Each(Type):
    """An array whose items are no numbers, at most 4,096 [NCP-WIRE-067]."""

    def __init__(self, item):
        self.item = item

    def read(self, value):
        return self._each(value, self.item.read, DecodeError)

    def write(self, value):
        return self._each(value, self.item.write, EncodeError)

    @staticmethod
    def _each(value, convert, error):
        if not isinstance(value, list):
            raise error("type", "not an array")
        if len(value) > MAX_ITEMS:
            raise error("limit", f"more than {MAX_ITEMS} items")
        items = []
        for item in value:
            try:
                items.append(convert(item))
            except error as inner:
                raise inner.within(len(items))
        return items


class Map(Type):
    """{string: item}, at most 4,096 entries [NCP-WIRE-066], written sorted [NCP-WIRE-083]."""

    def __init__(self, item):
        self.item = item

    def read(self, value):
        return self._each(value, self.item.read, DecodeError, list)

    def write(self, value):
        # Python compares strings by their code points.
        return self._each(value, self.item.write, EncodeError, sorted)

    @staticmethod
    def _each(value, convert, error, order):
        if not isinstance(value, dict):
            raise error("type", "not an object")
        if len(value) > MAX_ITEMS:
            raise error("limit", f"more than {MAX_ITEMS} entries")
        if not set(map(type, value)) <= {str}:
            raise error("type", "an entry's name is not a string")
        entries = {}
        for name in order(value):
            try:
                entries[name] = convert(value[name])
            except error as inner:
                raise inner.within(name)
        return entries


class SessionId(Type):
    """A session id: a valid key segment [NCP-WIRE-031]."""

    def check(self, value, error):
        if type(value) is not str:
            raise error("type", "not a string")
        try:
            return validate_segment(value)
        except KeyExpressionError as refused:
            raise error("value", str(refused)) from None


class Pin(Type):
    """A boolean with one allowed value [NCP-PROV-001] to [NCP-PROV-004], [NCP-PROV-008]."""

    def __init__(self, pinned):
        self.pinned = pinned

    def check(self, value, error):
        if value is not self.pinned:
            raise error("provenance", f"not exactly {str(self.pinned).lower()}")
        return value


class Choice(Type):
    """An enum whose unknown strings are rejected [NCP-WIRE-044], or read as `unknown` [NCP-WIRE-041]."""

    def __init__(self, values, unknown=None):
        self.values = values
        self.unknown = unknown

    def check(self, value, error):
        if type(value) is not str:
            raise error("type", "not a string")
        if value not in self.values:
            raise error("value", f"{value[:40]!r} is none of {', '.join(self.values)}")  # [NCP-WIRE-087]
        return value

    def read(self, value):
        if self.unknown is not None and type(value) is str and value not in self.values:
            return self.unknown
        return super().read(value)


class Nested(Type):
    """A message inside another [NCP-WIRE-050]."""

    def __init__(self, message):
        self.message = message

    def read(self, value):
        return self.message.read(value)

    def write(self, value):
        if not isinstance(value, self.message):
            raise EncodeError("type", f"not a {self.message.__name__}")
        return value.write()


class Field:
    """A row of a table: its type, the value that an absent one reads as, and the one of a builder.

    Without `default` the field is required. A default that is callable is called for each use.
    """

    REQUIRED = object()

    def __init__(self, type, default=REQUIRED, built=REQUIRED):
        self.type = type
        self.default = default
        self.built = default if built is Field.REQUIRED else built

    @property
    def required(self):
        return self.default is Field.REQUIRED

    def absent(self):
        """What an absent field reads as [NCP-WIRE-023]."""
        return self.default() if callable(self.default) else self.default

    def unnamed(self):
        """What a program gets that does not name the field [NCP-WIRE-090]."""
        return self.built() if callable(self.built) else self.built


class Message:
    """A message of the tables. `FIELDS` maps the names of its fields, in the contract's order.

    A program builds one by keywords; what it leaves out takes the builder's default.
    """

    FIELDS = {}

    def __init__(self, **values):
        for name, field in self.FIELDS.items():
            if name in values:
                setattr(self, name, values.pop(name))
            elif field.required:
                raise EncodeError("missing", "required").within(name)
            else:
                setattr(self, name, field.unnamed())
        if values:
            raise TypeError(f"{type(self).__name__} has no field {', '.join(values)}")

    def __eq__(self, other):
        return type(self) is type(other) and vars(self) == vars(other)

    def __repr__(self):
        fields = ", ".join(f"{name}={value!r}" for name, value in vars(self).items())
        return f"{type(self).__name__}({fields})"

    def replace(self, **values):
        """A copy with other values in the fields that are named."""
        return type(self)(**{**vars(self), **values})

    @classmethod
    def read(cls, value):
        """The message of a JSON object, or a `DecodeError`. Unlisted members do not count [NCP-WIRE-026]."""
        if not isinstance(value, dict):
            raise DecodeError("type", "not an object")
        message = cls.__new__(cls)
        for name, field in cls.FIELDS.items():
            if name in value:
                try:
                    setattr(message, name, field.type.read(value[name]))
                except DecodeError as error:
                    raise error.within(name)
            elif field.required:
                raise DecodeError("missing", "required").within(name)  # [NCP-WIRE-027]
            else:
                setattr(message, name, field.absent())
        return message

    def write(self):
        """The JSON object of the message: every field [NCP-WIRE-081], in order [NCP-WIRE-080]."""
        value = {}
        for name, field in self.FIELDS.items():
            try:
                value[name] = field.type.write(getattr(self, name))
            except EncodeError as error:
                raise error.within(name)
        return value
