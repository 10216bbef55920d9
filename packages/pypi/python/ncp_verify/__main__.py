"""python -m ncp_verify: the program itself, with its exit code."""

import os
import subprocess
import sys

from ncp_verify import program

if __name__ == "__main__":
    command = [program(), *sys.argv[1:]]
    if os.name == "nt":
        sys.exit(subprocess.run(command).returncode)
    os.execv(command[0], command)
