/**
 * NCP wire 0.5: messages, strict decoding, encoding, keys, planes, versions and bulk blocks.
 *
 * @packageDocumentation
 */

export { decodeBlock, encodeBlock, type Column, type Dtype } from "./bulk.js";
export {
  canonicalText,
  contractHashOf,
  contractStatus,
  NCP_CONTRACT_HASH,
  negotiate,
  verifyContract,
  type ContractStatus,
} from "./contract.js";
export { decode, decodeAny, kindOf } from "./decode.js";
export { create, encode, normalise } from "./encode.js";
export {
  BulkError,
  ContractError,
  DecodeError,
  EncodeError,
  KeyError,
  NcpError,
  ReplyError,
  VersionError,
  type ErrorCode,
} from "./errors.js";
export { DEFAULT_REALM, isSegment, Keys, matches, validateRealm, validateSegment } from "./keys.js";
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
export { checkReply, isRequestKind, REPLIES, type ReplyTo, type Request } from "./reply.js";
export { checkVersion, NCP_VERSION } from "./version.js";
