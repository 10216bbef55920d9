"""The simulation service over NEST: NCP requests in, replies out, one NEST kernel a session."""

import os

# NEST greets on standard output, which belongs to who started the service.
os.environ.setdefault("PYNEST_QUIET", "1")
