/**
 * NCP: messages, strict decoding, encoding, keys, planes, versions, bulk blocks, sessions and their
 * client over a WebSocket, and what keeps a plant safe on either side of the action plane.
 *
 * @packageDocumentation
 */

export { ActionBuffer, maxHorizonLen } from "./action-buffer.js";
export { NeuroSimClient, type NeuroSimClientOptions } from "./client/neuro-sim-client.js";
export { plain } from "./client/plain.js";
export { assertScientificBoundary } from "./client/scientific-boundary.js";
export {
  WebSocketNeuroSim,
  WebSocketTransport,
  type WebSocketClass,
  type WebSocketLike,
  type WebSocketOptions,
  type WebSocketState,
} from "./client/web-socket.js";
export { decodeBlock, encodeBlock, type Column, type Dtype } from "./bulk.js";
export {
  canonicalText,
  contractHashOf,
  contractStatus,
  negotiate,
  verifyContract,
  type ContractStatus,
} from "./contract.js";
export { ControlLoop, type Controller, type ControlLoopParts } from "./control-loop.js";
export { decode, decodeAny, kindOf } from "./decode.js";
export { create, encode, normalise } from "./encode.js";
export {
  BulkError,
  ConfigError,
  ContractError,
  DecodeError,
  EncodeError,
  KeyError,
  NcpConnectionError,
  NcpError,
  NcpScientificBoundaryError,
  NcpServerError,
  NcpTimeoutError,
  ReplyError,
  SessionError,
  VersionError,
  VersionError as NcpVersionError,
  type ErrorCode,
} from "./errors.js";
/** The messages as plain JSON values: what {@link NeuroSimClient} takes and gives. */
export type * as wire from "./wire.js";
export { SafetyGovernor, type NegotiatedChannels } from "./governor.js";
export { NCP_CONTRACT_HASH, NCP_VERSION } from "./identity.js";
export { DEFAULT_REALM, isSegment, Keys, matches, validateRealm, validateSegment } from "./keys.js";
export { LinkMonitor, type LinkReport } from "./link-monitor.js";
export { isKind, KINDS } from "./messages.js";
export type * from "./messages.js";
export {
  fromBulkObservation,
  pack,
  toBulkObservation,
  unpack,
  type Samples,
  type UnpackedSamples,
} from "./observation.js";
export { PLANES, type Plane, type Qos } from "./planes.js";
export {
  RATE_CODEC_ID,
  RateCodec,
  UAV_CODEC,
  type CommandHead,
  type DecoderMapping,
  type Mapping,
  type RateCodecSpec,
} from "./rate-codec.js";
export { ReferenceBackend } from "./reference-backend.js";
export { ReflexController, type ReflexConfig } from "./reflex.js";
export { checkReply } from "./reply.js";
export { isRequestKind, REPLIES, type ReplyTo, type Request, type RequestKind } from "./requests.js";
export { SessionClient, type RequestOptions, type Send } from "./session-client.js";
export { SessionService, type Backend, type SessionServiceOptions, type Simulation } from "./session-service.js";
export { checkVersion } from "./version.js";
export { CommandWatchdog, enforcedTtlMs } from "./watchdog.js";
