/**
 * What this library is built for: the wire version and the contract hash of chapter 2.
 *
 * @module
 */

/** The wire version of this library. [NCP-VER-021] */
export const NCP_VERSION = "0.5";

/** The contract hash of the schema that this library speaks. [NCP-VER-020] */
export const NCP_CONTRACT_HASH = "24e8e6e31e1dec8a";
