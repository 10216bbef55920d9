#!/usr/bin/env node
// Runs the program, with its streams and its end.
import { spawn } from "node:child_process";
import { constants } from "node:os";
import { program } from "./index.mjs";

let child;
try {
  child = spawn(program(), process.argv.slice(2), { stdio: "inherit" });
} catch (error) {
  fail(error);
}
child.on("error", fail);
child.on("exit", (code, signal) => process.exit(code ?? 128 + (constants.signals[signal] ?? 0)));
// The terminal sends Ctrl-C to the program, too; what is sent to this process alone is handed on.
process.on("SIGINT", () => {});
process.on("SIGTERM", () => child.kill("SIGTERM"));

function fail(error) {
  console.error(`error: ${error.message}`);
  process.exit(4);
}
