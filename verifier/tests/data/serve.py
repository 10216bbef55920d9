"""Puts a peer behind a TCP socket. `serve.py PORT starter FILE`: the starter, one connection at a time. `serve.py PORT
fragile PEER`: a program, a process a connection, as a server that dies as a whole when it is asked for version 9.9."""

import importlib.util
import os
import socket
import subprocess
import sys
import threading


def starter(connection, path):
    """The starter, with the connection in the place of its standard streams."""
    spec = importlib.util.spec_from_file_location("starter", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    with connection, connection.makefile("r") as lines, connection.makefile("w") as out:
        sys.stdin, sys.stdout = lines, out
        try:
            module.main()
        except OSError:
            pass  # the other side is gone


def fragile(connection, program):
    """Hands each request on to the program, but one."""

    def serve():
        with connection, connection.makefile("rb") as lines:
            peer = subprocess.Popen([program, "honest"], stdin=subprocess.PIPE, stdout=connection.fileno())
            for line in lines:
                if b'"9.9"' in line:
                    print("asked for 9.9", file=sys.stderr, flush=True)
                    os._exit(3)
                peer.stdin.write(line)
                peer.stdin.flush()
            peer.stdin.close()
            peer.wait()

    threading.Thread(target=serve, daemon=True).start()


def main():
    port, kind, what = sys.argv[1:]
    with socket.create_server(("127.0.0.1", int(port)), backlog=8) as server:
        while True:
            {"starter": starter, "fragile": fragile}[kind](server.accept()[0], what)


main()
