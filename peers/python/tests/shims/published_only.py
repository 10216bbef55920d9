"""Someone's module with the published API and nothing beyond it."""

from ncp import (
    CONTRACT_HASH,
    DEFAULT_REALM,
    NCP_VERSION,
    channel_value,
    check_version,
    contract_status,
)
import json as _json

import ncp


class Keys:
    """As published: no globs but the session's."""

    def __init__(self, realm=None):
        self._keys = ncp.Keys(realm)

    def rpc(self):
        return self._keys.rpc()

    def sensor(self, session):
        return self._keys.sensor(session)

    def sensor_named(self, session, name):
        return self._keys.sensor_named(session, name)

    def command(self, session):
        return self._keys.command(session)

    def command_named(self, session, name):
        return self._keys.command_named(session, name)

    def observation(self, session):
        return self._keys.observation(session)

    def session_glob(self, session):
        return self._keys.session_glob(session)


def _codec(codec_json):
    """The codec in the published form alone: in another one it is a codec without mappings."""
    codec = _json.loads(codec_json)
    if not isinstance(codec, dict):
        raise ValueError("a codec is an object")
    names = ("codec_id", "encoder", "decoder")
    return _json.dumps({name: codec[name] for name in names if name in codec})


def encode_rates(codec_json, sensor_json):
    return ncp.encode_rates(_codec(codec_json), sensor_json)


def decode_command(codec_json, rates_json, t=0.0, seq=0, frame_id="world", mode="active"):
    return ncp.decode_command(_codec(codec_json), rates_json, t, seq, frame_id, mode)


def validate(kind, json):
    if not isinstance(json, str):
        raise TypeError("argument 'json': expected str")
    return ncp.validate(kind, json)


def govern(limits_json, command_json, now_s, sensor_json=None, last_sensor_s=None):
    for text in (limits_json, command_json):
        if not isinstance(text, str):
            raise TypeError("expected str")
    return ncp.govern(limits_json, command_json, now_s, sensor_json, last_sensor_s)
