"""Someone's module with the published API and nothing beyond it."""

from ncp import (
    CONTRACT_HASH,
    DEFAULT_REALM,
    NCP_VERSION,
    channel_value,
    check_version,
    contract_status,
    decode_command,
    encode_rates,
)
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


def validate(kind, json):
    if not isinstance(json, str):
        raise TypeError("argument 'json': expected str")
    return ncp.validate(kind, json)


def govern(limits_json, command_json, now_s, sensor_json=None, last_sensor_s=None):
    for text in (limits_json, command_json):
        if not isinstance(text, str):
            raise TypeError("expected str")
    return ncp.govern(limits_json, command_json, now_s, sensor_json, last_sensor_s)
