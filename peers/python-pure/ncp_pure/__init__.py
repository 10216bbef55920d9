"""NCP in Python, with the standard library only, written from the text of the specification."""

from . import bulk, observation
from .buffer import ActionBuffer, max_horizon_len
from .client import Client, check_reply
from .codec import Mapping, RateCodec, default_uav
from .contract import contract_status, hash_of, negotiate, verify_contract
from .errors import (
    BulkError,
    ConfigError,
    ContractError,
    DecodeError,
    EncodeError,
    KeyExpressionError,
    NcpError,
    ReplyError,
    SimulationError,
    VersionError,
)
from .estop import is_estop
from .governor import SafetyGovernor
from .identity import CONTRACT_HASH, WIRE_VERSION
from .keys import DEFAULT_REALM, Keys, matches, validate_realm, validate_segment
from .link import LinkMonitor, LinkState
from .loop import ControlLoop
from .messages import (
    FRAMES,
    BulkObservation,
    Capabilities,
    ChannelSpec,
    ChannelValue,
    CloseSession,
    CommandFrame,
    ControlStatus,
    EntityBinding,
    EntityRef,
    ErrorFrame,
    LinkStatus,
    NetworkRef,
    Observation,
    ObservationFrame,
    OpenSession,
    RecordSpec,
    RecordTarget,
    RunRequest,
    SafetyLimits,
    SensorFrame,
    SessionClosed,
    SessionOpened,
    SimConfig,
    SimProvenance,
    StepRequest,
    StimulusFrame,
    StimulusSpec,
    StimulusTarget,
)
from .plane import PLANES, Qos
from .reflex import ReflexController
from .session import SessionService
from .version import check_version
from .watchdog import CommandWatchdog
from .wire import decode, encode, to_text

__version__ = "0.1.0"
