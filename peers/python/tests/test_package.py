"""The package as it is installed: its wheel, its stubs."""

import json
import subprocess
import sys
import tempfile
import unittest
import venv
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]


class Package(unittest.TestCase):
    def test_the_stubs_say_what_the_module_is(self):
        command = [sys.executable, "-m", "mypy.stubtest", "ncp._ncp", "--concise"]
        done = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)

    def test_mypy_sees_the_types(self):
        program = """
import ncp
governor = ncp.SafetyGovernor({"max_speed_mps": 1.0})
reveal_type(ncp.bulk_decode(b""))
reveal_type(governor.decision)
ncp.check_version(5)
"""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "program.py"
            path.write_text(program)
            done = subprocess.run([sys.executable, "-m", "mypy", "--strict", path], capture_output=True, text=True, cwd=folder)
        self.assertIn("dict[", done.stdout)
        self.assertIn("numpy.ndarray", done.stdout)
        self.assertIn('"int"; expected "str"', done.stdout)
        self.assertIn("Found 1 error", done.stdout)

    def test_the_wheel_installs_into_an_empty_environment_without_a_network(self):
        wheels = list((ROOT / ".tools/python-wheels").glob("*.whl"))
        self.assertEqual(len(wheels), 1)
        self.assertIn("-cp39-abi3-", wheels[0].name)
        with tempfile.TemporaryDirectory() as folder:
            venv.create(folder, with_pip=True)
            python = Path(folder) / ("Scripts" if sys.platform == "win32" else "bin") / "python"
            pip = [python, "-m", "pip", "install", "--quiet", "--no-index", "--disable-pip-version-check", wheels[0]]
            subprocess.run(pip, check=True, cwd=folder)
            program = "import ncp; print(ncp.NCP_VERSION, ncp.Keys().rpc())"
            done = subprocess.run([python, "-c", program], capture_output=True, text=True, check=True, cwd=folder)
        version = json.loads((ROOT / "proto/projection.json").read_text("utf-8"))["wire"]
        self.assertEqual(done.stdout.strip(), f"{version} ncp/rpc")

    def test_the_wheel_carries_both_licences(self):
        (wheel,) = (ROOT / ".tools/python-wheels").glob("*.whl")
        with zipfile.ZipFile(wheel) as files:
            for licence in ("LICENSE-APACHE", "LICENSE-MIT"):
                (name,) = (name for name in files.namelist() if name.endswith("/" + licence))
                self.assertEqual(files.read(name), (ROOT / licence).read_bytes())


if __name__ == "__main__":
    unittest.main()
