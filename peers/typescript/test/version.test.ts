import assert from "node:assert/strict";
import { test } from "node:test";
import {
  canonicalText,
  checkVersion,
  contractHashOf,
  contractStatus,
  NCP_CONTRACT_HASH,
  NCP_VERSION,
  negotiate,
  verifyContract,
} from "@ncp-conformance/peer";
import { projection, refuses, repositoryFile } from "./support.js";

const OWN = NCP_VERSION;
const MINOR = Number(OWN.slice(2));

const MALFORMED = [
  ...[`${OWN}.0`, `v${OWN}`, `${OWN}a`, ` ${OWN}`, `${OWN} `, `${OWN}\n`, `\n${OWN}`, `+${OWN}`, `-${OWN}`],
  ...[`0.-${MINOR}`, `0.+${MINOR}`, `0..${MINOR}`, `0,${MINOR}`, `0_${OWN}`, `0x${OWN}`, `${OWN}\0`, `.${MINOR}`],
  ...["", ".", "0.", "٠.٥", "０.５", "1e0", "NaN", "zero", "½"],
];

test("the library states version and contract hash of the text", () => {
  const { wire, contract_hash } = projection();
  assert.equal(NCP_VERSION, wire);
  assert.equal(NCP_CONTRACT_HASH, contract_hash);
});

test("a compatible version is true, strict or not", () => {
  for (const version of [OWN, `0${OWN}`, `0.0${MINOR}`, `000.000${MINOR}`, `0.${"0".repeat(1_000)}${MINOR}`]) {
    assert.equal(checkVersion(version, false), true);
    assert.equal(checkVersion(version, true), true);
  }
});

test("an incompatible version is false, or an error when strict", () => {
  const huge = "9".repeat(1_000);
  for (const version of [
    `0.${MINOR - 1}`,
    `0.${MINOR + 1}`,
    "1.0",
    "1",
    "0",
    "0.50",
    "5.0",
    "1.5",
    "5",
    "00",
    "0.18446744073709551621",
    "4294967296.5",
    huge,
    `0.${huge}`,
  ]) {
    assert.equal(checkVersion(version), false);
    refuses("version", () => checkVersion(version, true));
  }
});

test("anything but one or two unsigned integers is an error, strict or not", () => {
  for (const version of MALFORMED) {
    refuses("version", () => checkVersion(version, false));
    refuses("version", () => checkVersion(version, true));
  }
  refuses("version", () => checkVersion(1.5 as unknown as string));
});

const OTHERS = ["", NCP_CONTRACT_HASH.toUpperCase(), "2cf0763ad61e4f1c"];

test("the contract status compares letter for letter", () => {
  assert.equal(contractStatus(null), "not_advertised");
  assert.equal(contractStatus(undefined), "not_advertised");
  assert.equal(contractStatus(NCP_CONTRACT_HASH), "match");
  for (const hash of [...OTHERS, `${NCP_CONTRACT_HASH} `, NCP_CONTRACT_HASH.slice(1)])
    assert.equal(contractStatus(hash), "mismatch");
});

test("the strict opt-in takes only this library's hash", () => {
  verifyContract(NCP_CONTRACT_HASH);
  for (const hash of [...OTHERS, null, undefined])
    refuses("contract", () => verifyContract(hash));
});

test("negotiation rejects by the version and answers the contract status", () => {
  assert.equal(negotiate(OWN, NCP_CONTRACT_HASH), "match");
  assert.equal(negotiate(OWN, "x"), "mismatch");
  assert.equal(negotiate(OWN, null), "not_advertised");
  for (const version of ["0.4", "1.0", ...MALFORMED])
    refuses("version", () => negotiate(version, NCP_CONTRACT_HASH));
});

test("the schema of this repository has the contract hash", () => {
  assert.equal(contractHashOf(repositoryFile("proto/ncp.proto")), NCP_CONTRACT_HASH);
});

test("the canonical text is the schema without comments, layout and file options", () => {
  const schema = [
    "// about",
    'syntax = "proto3";',
    "package ncp.v0; // the package",
    'import "other.proto";',
    'option java_package = "x";',
    "",
    "/* one",
    " two */",
    "message A {   // open",
    '  string s = 1 [json_name = "a//b /* \\" */"]; /* gone */',
    "\toptional int32 n = 2;\r",
    "}",
    "// end",
  ].join("\n");
  const expected = ["message A {", 'string s = 1 [json_name = "a//b /* \\" */"];', "optional int32 n = 2;", "}"].join(
    "\n",
  );
  assert.equal(canonicalText(schema), expected);
});

test("the hash of an empty schema is the offset basis of FNV-1a", () => {
  assert.equal(contractHashOf(""), "cbf29ce484222325");
  assert.equal(contractHashOf("a"), "af63dc4c8601ec8c");
  assert.equal(contractHashOf("foobar"), "85944171f73967e8");
});
