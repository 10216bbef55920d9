#!/bin/sh
# Builds the kernel as a library, and proves what its machine code does. README.md says more.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
cargo build --release --quiet --package ncp-machine --lib --example ncp_machine_broken
built=${CARGO_TARGET_DIR:-target}/release
exec "${NCP_MACHINE_PYTHON:-.tools/machine-venv/bin/python}" proofs/machine/explore.py \
    --library "$built/libncp_machine.so" --broken "$built/examples/libncp_machine_broken.so" "$@"
