/**
 * Every refusal is an error of one class hierarchy with a `code` from a closed list.
 *
 * @module
 */

/**
 * Why something was refused or failed. The list is that of the peer protocol, without its codes for adapters,
 * and with two for connections.
 */
export type ErrorCode =
  /** The bytes are not one JSON object in UTF-8. */
  | "malformed"
  /** A field has the wrong JSON type. */
  | "type"
  /** The kind is missing, unknown, or not the expected one. */
  | "kind"
  /** A required field is missing. */
  | "missing"
  /** A value is not allowed. */
  | "value"
  /** An epistemic pin does not hold. */
  | "provenance"
  /** A limit is exceeded. */
  | "limit"
  /** The version is malformed or incompatible. */
  | "version"
  /** The contract hash is rejected. */
  | "contract"
  /** A segment, a realm or a key expression is invalid. */
  | "key"
  /** The BulkBlock or its columns are invalid. */
  | "block"
  /** The encoder was given a number that JSON lacks. */
  | "non_finite"
  /** The reply does not fit, or reports a failure. */
  | "reply"
  /** There is no connection, or it was lost. */
  | "connection"
  /** There was no reply in time. */
  | "timeout";

/** The base of all errors that this library throws on purpose. */
export abstract class NcpError extends Error {
  /** Why, from the closed list. */
  readonly code: ErrorCode;

  protected constructor(code: ErrorCode, message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = new.target.name;
    this.code = code;
  }
}

/** A frame was rejected. */
export class DecodeError extends NcpError {
  /** Where in the frame, as a JSON pointer; empty for the frame as a whole. */
  readonly path: string;

  constructor(code: ErrorCode, message: string, path: readonly (string | number)[] = []) {
    super(code, at(path, message));
    this.path = pointer(path);
  }
}

/** A message was refused by the encoder, or could not be built. */
export class EncodeError extends NcpError {
  /** Where in the message, as a JSON pointer; empty for the message as a whole. */
  readonly path: string;

  constructor(code: ErrorCode, message: string, path: readonly (string | number)[] = []) {
    super(code, at(path, message));
    this.path = pointer(path);
  }
}

/** A version is malformed, or incompatible under a strict check. */
export class VersionError extends NcpError {
  constructor(message: string, options?: ErrorOptions) {
    super("version", message, options);
  }
}

/** A contract hash was rejected by the strict opt-in. */
export class ContractError extends NcpError {
  constructor(message: string) {
    super("contract", message);
  }
}

/** A segment, a realm or a key expression is invalid. */
export class KeyError extends NcpError {
  constructor(message: string) {
    super("key", message);
  }
}

/** A BulkBlock was rejected, or its columns were refused. */
export class BulkError extends NcpError {
  constructor(message: string, code: "block" | "limit" = "block") {
    super(code, message);
  }
}

/** A reply does not answer its request, or reports a failure. */
export class ReplyError extends NcpError {
  constructor(message: string, options?: ErrorOptions) {
    super("reply", message, options);
  }
}

/** The server reports that it could not serve the request: by an error frame, or by `ok` false. */
export class NcpServerError extends ReplyError {}

/** A frame claims to be more than the raw output of a model. */
export class NcpScientificBoundaryError extends NcpError {
  constructor(message: string, options?: ErrorOptions) {
    super("provenance", message, options);
  }
}

/** There is no connection, or it was lost. */
export class NcpConnectionError extends NcpError {
  /** Whether the request had been sent, so that the server may have carried it out. */
  readonly sent: boolean;

  constructor(message: string, sent: boolean, options?: ErrorOptions) {
    super("connection", message, options);
    this.sent = sent;
  }
}

/** There was no reply in time. */
export class NcpTimeoutError extends NcpError {
  /** Whether the request had been sent, so that the server may have carried it out. */
  readonly sent: boolean;

  constructor(message: string, sent: boolean, options?: ErrorOptions) {
    super("timeout", message, options);
    this.sent = sent;
  }
}

/** A controller, a control loop, a codec, a monitor or a connection was to be built from values that it refuses. */
export class ConfigError extends NcpError {
  constructor(message: string) {
    super("value", message);
  }
}

/** A simulation was not opened, or a request to one was refused. */
export class SessionError extends NcpError {
  constructor(message: string) {
    super("value", message);
  }
}

function at(path: readonly (string | number)[], message: string): string {
  return path.length === 0 ? message : `${pointer(path)}: ${message}`;
}

function pointer(path: readonly (string | number)[]): string {
  return path.map((part) => `/${String(part).replaceAll("~", "~0").replaceAll("/", "~1")}`).join("");
}
