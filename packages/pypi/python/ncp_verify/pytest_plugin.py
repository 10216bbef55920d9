"""pytest --ncp-peer PEER: each case of the suite is a test, and one run of ncp-verify says what became of it."""

import json
import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import pytest

from ncp_verify import program

# With more selected cases than that, the run is of all that level and filter select.
FILTERS = 200


def pytest_addoption(parser):
    group = parser.getgroup("ncp", "conformance with the Neuro-Cybernetic Protocol (ncp-verify)")
    group.addoption("--ncp-peer", metavar="PEER", help="check the peer of this command, or of this tcp:// or ws:// URL")
    group.addoption("--ncp-level", default="wire", choices=["wire", "safety", "strict"], help="up to this level")
    group.addoption("--ncp-filter", action="append", default=[], metavar="PATTERN", help="as --filter of ncp-verify")
    group.addoption("--ncp-expected", metavar="FILE", help="failures that are expected of the peer")
    group.addoption("--ncp-deep", action="store_true", help="run the deep set, too; the test `verdict` tells of it")


def pytest_configure(config):
    if config.getoption("ncp_peer"):
        config.pluginmanager.register(Suite(config), "ncp-suite")


class CaseFailure(Exception):
    """What the result says of a case that failed."""


class Suite:
    """The cases of a session, and the one run of the program that judges them."""

    def __init__(self, config):
        self.config = config
        worker = getattr(config, "workerinput", None)
        self.shared = worker is not None
        self.folder = Path(worker["ncp_folder"] if self.shared else tempfile.mkdtemp(prefix="ncp-verify-"))
        self.ids, self.listed, self.result = set(), set(), None

    @pytest.hookimpl(optionalhook=True)
    def pytest_configure_node(self, node):
        """The workers of pytest-xdist share one run, by a folder of the session that started them."""
        node.workerinput["ncp_folder"] = str(self.folder)

    def pytest_unconfigure(self):
        if not self.shared:
            shutil.rmtree(self.folder, ignore_errors=True)

    @pytest.hookimpl(tryfirst=True)
    def pytest_collection_modifyitems(self, session, items):
        """The cases come after the other tests, and before -k chooses."""
        cases = json.loads(self._ask(["list", "--json", *self._selection(self.config.getoption("ncp_filter"))]).stdout)
        self.listed = {case["id"] for case in cases}
        files = {}
        for case in [{"id": "describe", "file": "peer"}, *cases, {"id": "verdict", "file": "peer"}]:
            name = f"ncp/{case['file']}"
            if name not in files:
                files[name] = File.from_parent(session, name=name, nodeid=name)
            items.append(Case.from_parent(files[name], name=case["id"], suite=self, case=case))

    def pytest_collection_finish(self, session):
        self.ids = {item.name for item in session.items if isinstance(item, Case)}

    def judged(self):
        """The result; the first test that asks has the program run."""
        if self.result is None:
            self.result = self._once()
        if "error" not in self.result:
            return self.result
        message = f"ncp-verify: {self.result['error']}"
        if self.shared:
            # A worker of pytest-xdist cannot end the session.
            raise CaseFailure(message)
        pytest.exit(message, returncode=pytest.ExitCode.USAGE_ERROR)

    def _once(self):
        done = self.folder / "done.json"
        try:
            os.close(os.open(self.folder / "lock", os.O_CREAT | os.O_EXCL))
        except FileExistsError:
            # Another worker has the program run.
            while not done.is_file():
                time.sleep(0.05)
            return json.loads(done.read_text("utf-8"))
        result = {"error": "it was interrupted"}
        try:
            result = self._run()
        finally:
            (self.folder / "part").write_text(json.dumps(result), "utf-8")
            os.replace(self.folder / "part", done)
        return result

    def _run(self):
        option, file = self.config.getoption, self.folder / "result.json"
        peer = option("ncp_peer")
        how = "--connect" if peer.startswith(("tcp://", "ws://")) else "--peer-cmd"
        args = ["run", "--color", "never", how, peer, "--json", str(file)]
        if option("ncp_expected"):
            args += ["--expected", option("ncp_expected")]
        if option("ncp_deep"):
            args.append("--deep")
        chosen = self.ids & self.listed
        narrow = "verdict" not in self.ids and 0 < len(chosen) <= FILTERS
        args += self._selection(sorted(chosen) if narrow else option("ncp_filter"))
        run = subprocess.run([_program(), *args], stdin=subprocess.DEVNULL, capture_output=True, text=True)
        if run.returncode not in (0, 1) or not file.is_file():
            return {"error": run.stderr.strip() or f"exit code {run.returncode}"}
        return json.loads(file.read_text("utf-8"))

    def _selection(self, filters):
        return ["--level", self.config.getoption("ncp_level"), *(f"--filter={pattern}" for pattern in filters)]

    def _ask(self, args):
        asked = subprocess.run([_program(), *args], stdin=subprocess.DEVNULL, capture_output=True, text=True)
        if asked.returncode != 0:
            raise pytest.UsageError(f"ncp-verify: {asked.stderr.strip()}")
        return asked


def _program():
    try:
        return program()
    except FileNotFoundError as error:
        raise pytest.UsageError(str(error)) from None


class File(pytest.Collector):
    """A file of the corpus."""

    def collect(self):
        return []


class Case(pytest.Item):
    """A case of the suite, or the verdict on the peer."""

    def __init__(self, *, suite, case, **rest):
        super().__init__(**rest)
        self.suite, self.case = suite, case

    def runtest(self):
        result = self.suite.judged()
        peer = result["peers"][0]
        if self.name == "verdict":
            return _verdict(peer, result)
        case = next((case for case in peer["cases"] if case["id"] == self.name), None)
        if case is None:
            needs = [unasked["needs"] for unasked in peer["not_asked"]]
            more = f", or not what it needs ({', '.join(needs)})" if needs else ""
            pytest.skip(f"not asked: the peer claims no role of {', '.join(self.case.get('roles', []))}{more}")
        status = case["status"]
        if status == "expected failure":
            pytest.xfail(case.get("reason", status))
        if status == "passed":
            return None
        if case["outcome"] == "unsupported":
            pytest.skip(f"unsupported: the peer has no {case['call']} for this")
        if status == "advice":
            self.add_report_section("call", "advice", describe(case, result))
            return None
        raise CaseFailure(describe(case, result))

    def repr_failure(self, excinfo):
        return str(excinfo.value) if isinstance(excinfo.value, CaseFailure) else super().repr_failure(excinfo)

    def reportinfo(self):
        return self.parent.name, None, self.name


def describe(case, result):
    """What the result says of a case, in lines."""
    rule = case.get("charged", case["rules"][0])
    sentence = next((known["sentence"] for known in result["rules"] if known["id"] == rule), "")
    lines = [f"{case['outcome'] if case['status'] == 'failed' else case['status']}: {case['title']}"]
    lines.append(f"{rule}: {sentence}")
    if "what" in case:
        lines.append(case["what"] if case["outcome"] == "not run" else f"it {case['what']}")
    lines += [difference["text"] for difference in case.get("differences", [])]
    for member in ("expected", "request", "answer", "log", "note", "reason"):
        if member in case:
            lines.append(f"{member}: {case[member]}")
    return "\n".join(lines)


def _verdict(peer, result):
    if result["exit_code"] == 0:
        return
    failed = [case["id"] for case in peer["cases"] if case["status"] in ("failed", "unexpected pass", "not run")]
    lines = [f"{peer['conclusion'] or peer['state']}: {len(failed)} cases", *failed[:20]]
    if len(failed) > 20:
        lines.append(f"and {len(failed) - 20} more")
    run = peer["run"] or {}
    lines += [f"given up: {run['given_up']}"] if run.get("given_up") else []
    lines += [f"{entry['entry']}: stale or expired" for entry in peer["expected_failures"]
              if entry["stale"] or entry["expired"] or entry["stale_cases"]]
    raise CaseFailure("\n".join(lines))
