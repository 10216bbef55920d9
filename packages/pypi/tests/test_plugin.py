"""The plugin of pytest, by sessions of pytest that check right and wrong peers. NCP_VERIFY names the program."""

import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[3]
PURE = PROJECT / "peers/python-pure"
# Puts a program behind a port, a connection after the other.
SERVER = """
import socket, subprocess, sys
server = socket.create_server(("127.0.0.1", int(sys.argv[1])))
while True:
    with server.accept()[0] as connection:
        subprocess.run(sys.argv[2:], stdin=connection, stdout=connection)
"""


class Plugin(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def pytest(self, peer, *options, filter="version/", **env):
        command = [sys.executable, "-m", "pytest", "-p", "ncp_verify.pytest_plugin", "-p", "no:cacheprovider"]
        command += ["-rA", "--ncp-peer", peer, "--ncp-filter", filter, *options]
        env = {**os.environ, "PYTHONPATH": str(PROJECT / "packages/pypi/python"), **env}
        return subprocess.run(command, cwd=self.folder, env=env, capture_output=True, text=True)

    def right(self):
        return f"{sys.executable} {PURE / 'adapter.py'}"

    def wrong(self):
        """The right peer, but every version is compatible."""
        copy = self.folder / "wrong"
        shutil.copytree(PURE, copy, ignore=shutil.ignore_patterns("tests", "__pycache__"))
        (copy / "planted.py").write_text(
            "import json, subprocess, sys\n"
            f"peer = subprocess.Popen([sys.executable, {str(copy / 'adapter.py')!r}], stdin=subprocess.PIPE,\n"
            "                        stdout=subprocess.PIPE, text=True, bufsize=1)\n"
            "for line in sys.stdin:\n"
            "    request = json.loads(line)\n"
            "    peer.stdin.write(line)\n"
            "    answer = json.loads(peer.stdout.readline())\n"
            "    if request['call'] == 'version.check' and 'result' in answer:\n"
            "        answer['result']['compatible'] = True\n"
            "    print(json.dumps(answer), flush=True)\n"
        )
        return f"{sys.executable} {copy / 'planted.py'}"

    def test_a_right_peer_passes_each_case_and_the_verdict(self):
        session = self.pytest(self.right())
        self.assertEqual(session.returncode, 0, session.stdout)
        self.assertIn("PASSED ncp/peer::verdict", session.stdout)
        self.assertGreater(session.stdout.count("PASSED ncp/version/"), 50)

    def test_a_peer_that_listens_is_tested_where_it_listens(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        with subprocess.Popen([sys.executable, "-c", SERVER, str(port), *self.right().split()]) as server:
            try:
                session = self.pytest(f"tcp://127.0.0.1:{port}")
            finally:
                server.kill()
        self.assertEqual(session.returncode, 0, session.stdout)
        self.assertGreater(session.stdout.count("PASSED ncp/version/"), 50)

    def test_a_wrong_peer_fails_with_the_rule_and_what_differs(self):
        session = self.pytest(self.wrong())
        self.assertEqual(session.returncode, 1, session.stdout)
        self.assertIn("FAILED ncp/version/guard.json::version/guard/lenient/older-minor", session.stdout)
        told = session.stdout.split(" version/guard/lenient/older-minor __")[1].split("\n____")[0]
        self.assertRegex(told, r"\nfail: .*\nNCP-VER-\d{3}: .*\S")
        self.assertIn("/compatible: expected false, got true", told)
        self.assertIn('"call":"version.check"', told)
        self.assertIn("FAILED ncp/peer::verdict", session.stdout)

    def test_an_expected_failure_is_an_xfail_and_an_unexpected_pass_fails(self):
        wrong, known = self.wrong(), self.folder / "known.toml"
        written = [os.environ["NCP_VERIFY"], "run", "--level", "wire", "--filter", "version/", "--peer-cmd", wrong]
        written += ["--json", str(self.folder / "result.json"), "--write-expected", str(known)]
        subprocess.run(written, capture_output=True, check=False)
        session = self.pytest(wrong, "--ncp-expected", str(known))
        self.assertEqual(session.returncode, 0, session.stdout)
        self.assertIn("XFAIL ncp/version/", session.stdout)
        session = self.pytest(self.right(), "--ncp-expected", str(known))
        self.assertEqual(session.returncode, 1, session.stdout)
        self.assertRegex(session.stdout, "FAILED ncp/version/")
        self.assertIn("unexpected pass", session.stdout)

    def test_what_the_peer_does_not_support_is_skipped(self):
        starter = f"{sys.executable} {PROJECT / 'peers/PROTOCOL-starter.py'}"
        session = self.pytest(starter, "-k", "not verdict and not describe", filter="bulk/header/version/0")
        self.assertRegex(session.stdout, r"SKIPPED .*unsupported: the peer has no bulk\.decode")

    def test_k_narrows_the_run_and_co_needs_no_peer(self):
        session = self.pytest("false", "--co", "-q")
        self.assertEqual(session.returncode, 0, session.stdout)
        name = re.search(r"::(version/\S+)", session.stdout).group(1)
        session = self.pytest(self.right(), "-k", name, "--junitxml=junit.xml")
        self.assertEqual(session.returncode, 0, session.stdout)
        self.assertIn(name, (self.folder / "junit.xml").read_text())

    def test_a_peer_that_dies_at_start_is_one_error_of_usage(self):
        session = self.pytest("false")
        self.assertEqual(session.returncode, 4, session.stdout)
        self.assertIn("exited with status 1 before it answered", session.stdout + session.stderr)
        self.assertNotIn("FAILED", session.stdout)

    def test_a_program_that_is_missing_is_an_error_of_usage(self):
        session = self.pytest(self.right(), NCP_VERIFY="/nowhere/ncp-verify")
        self.assertEqual(session.returncode, 4, session.stdout)
        self.assertIn("NCP_VERIFY names no file", session.stdout + session.stderr)

    def test_the_workers_of_xdist_share_one_run(self):
        starts = self.folder / "starts"
        peer = self.folder / "counted.py"
        peer.write_text(
            f"import os, sys\nopen({str(starts)!r}, 'a').write('x')\n"
            f"os.execv(sys.executable, [sys.executable, {str(PURE / 'adapter.py')!r}])\n"
        )
        alone = self.pytest(f"{sys.executable} {peer}")
        once, _ = starts.read_text(), starts.unlink()
        session = self.pytest(f"{sys.executable} {peer}", "-n", "2")
        self.assertEqual((alone.returncode, session.returncode), (0, 0), session.stdout)
        self.assertEqual(starts.read_text(), once)


if __name__ == "__main__":
    unittest.main()
