#!/bin/sh
# Builds the kernel as a library, and proves what its machine code does. README.md says more.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
cargo build --release --quiet --package ncp-machine --lib --example ncp_machine_broken
# What a solver finds depends on the order of terms, and that on hashes and addresses: they are the same in every run,
# where the system allows it.
export PYTHONHASHSEED=0
steady="setarch $(uname -m) -R"
$steady true 2>/dev/null || steady=
built=${CARGO_TARGET_DIR:-target}/release
exec $steady "${NCP_MACHINE_PYTHON:-.tools/machine-venv/bin/python}" proofs/machine/explore.py \
    --library "$built/libncp_machine.so" --broken "$built/examples/libncp_machine_broken.so" "$@"
