"""The adapter: its conversation, and the verdict on modules that are not ours (`shims`)."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PEER = Path(__file__).resolve().parents[1]
ROOT = PEER.parents[1]
SHIMS = Path(__file__).resolve().parent / "shims"


def adapter(module):
    return [sys.executable, str(PEER / "adapter.py"), "--path", str(SHIMS), "--module", module]


def ask(module, *calls):
    """The answers to calls, each a name and its args; and what was logged."""
    requests = [json.dumps({"id": nth, "call": call, "args": args}) for nth, (call, args) in enumerate(calls)]
    done = subprocess.run(
        adapter(module), input="\n".join(requests) + "\n", capture_output=True, text=True, check=True, timeout=60
    )
    answers = [json.loads(line) for line in done.stdout.splitlines()]
    assert [answer.pop("id") for answer in answers] == list(range(len(calls)))
    return answers, done.stderr


def verdict(module, level):
    """What ncp-verify says of a module: its result on the one peer."""
    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder) / "result.json"
        command = ["cargo", "run", "--quiet", "--profile", "verify", "-p", "ncp-verifier", "--"]
        command += ["run", "--level", level, "--peer-cmd", subprocess.list2cmdline(adapter(module)), "--json", str(result)]
        subprocess.run(command, cwd=ROOT, capture_output=True, check=False)
        return json.loads(result.read_text())["peers"][0]


def cases(peer, **members):
    return [case for case in peer["cases"] if all(case[name] == value for name, value in members.items())]


class Conversation(unittest.TestCase):
    def test_what_a_module_prints_goes_to_the_log(self):
        answers, log = ask("noisy", ("version.check", {"version": "1.2", "strict": False}))
        self.assertEqual(answers, [{"result": {"compatible": True}}])
        for line in ("imported", "to the original", "to the descriptor", "from a child", "1.2"):
            self.assertIn(line, log.splitlines())

    def test_a_crash_is_internal_and_ends_nothing(self):
        crashes = ("panic", "exit", "type", "deep", "value", "1.2")
        answers, _ = ask("noisy", *[("version.check", {"version": how, "strict": True}) for how in crashes])
        codes = [answer.get("error", {}).get("code") for answer in answers]
        self.assertEqual(codes, ["internal", "internal", "internal", "internal", "invalid", None])

    def test_what_a_module_lacks_is_unsupported(self):
        answers, _ = ask(
            "noisy",
            ("describe", {}),
            ("contract.status", {"peer_hash": None}),
            ("teleport", {}),
            ("roles_by_functions", {}),
            ("watchdog.run", {"steps": []}),
        )
        self.assertEqual(answers[0]["result"]["roles"], ["body"])
        self.assertEqual(answers[1:], [{"unsupported": True}] * 4)

    def test_a_refusal_keeps_its_code_and_a_refused_step_its_place(self):
        frame = '{"kind":"command_frame","seq":"1"}'
        answers, _ = ask(
            "ncp",
            ("decode", {"kind": "command_frame", "text": frame}),
            ("buffer.run", {"steps": [{"op": "command", "text": frame, "now_s": 1.0}, {"op": "active", "now_s": 1.0}]}),
        )
        self.assertEqual(answers[0]["error"]["code"], "type")
        steps = answers[1]["result"]["steps"]
        self.assertEqual((steps[0]["error"]["code"], steps[1]), ("type", {"channels": None}))

    def test_a_step_for_which_the_object_has_no_method_is_unsupported_and_the_trace_goes_on(self):
        steps = [{"op": "should_hold", "now_s": 0}, {"op": "reset"}, {"op": "should_hold", "now_s": 1}]
        answers, _ = ask("no_reset", ("watchdog.run", {"steps": steps}))
        self.assertEqual(answers[0]["result"]["steps"], [{"hold": True}, {"unsupported": True}, {"hold": True}])

    def test_the_four_strings_stand_for_numbers_only_where_numbers_stand(self):
        fields = {"frame_id": "NaN", "t": "-0", "channels": {"t": {"data": ["-0", 1], "unit": "NaN"}}}
        answers, _ = ask("ncp", ("encode", {"kind": "sensor_frame", "fields": fields}))
        frame = json.loads(answers[0]["result"]["text"])
        self.assertEqual((frame["frame_id"], str(frame["t"])), ("NaN", "-0.0"))
        self.assertEqual(str(frame["channels"]), "{'t': {'data': [-0.0, 1.0], 'unit': 'NaN'}}")

    def test_bytes_that_are_no_text_are_refused_for_a_module_that_takes_text_only(self):
        frames = ("eyJraW5kIjr/", "eyJraW5kIjoiZXJyb3IiLCJlcnJvciI6IngifQ==")
        answers, _ = ask("published_only", *[("decode", {"kind": "error", "base64": frame}) for frame in frames])
        self.assertEqual(answers[0]["error"]["code"], "malformed")
        self.assertEqual(json.loads(answers[1]["result"]["text"])["error"], "x")

    def test_a_long_message_is_given_to_a_module_in_its_own_characters_and_half_a_character_is_refused(self):
        fields = ({"frame_id": "\u00e9" * 450_000}, {"frame_id": "\ud800"})
        answers, _ = ask("published_only", *[("encode", {"kind": "sensor_frame", "fields": given}) for given in fields])
        self.assertEqual(json.loads(answers[0]["result"]["text"])["frame_id"], "\u00e9" * 450_000)
        self.assertIn("error", answers[1])


@unittest.skipIf(os.environ.get("NCP_NO_VERIFIER"), "NCP_NO_VERIFIER is set")
class Verdicts(unittest.TestCase):
    def test_a_right_module_with_the_published_api_alone_fails_nothing(self):
        peer = verdict("published_only", "safety")
        self.assertEqual(peer["description"]["roles"], ["commander", "body"])
        self.assertEqual({case["outcome"] for case in peer["cases"]}, {"pass", "unsupported"})
        supported = {case["call"] for case in cases(peer, outcome="pass")}
        self.assertEqual(
            supported,
            {
                "describe",
                "decode",
                "encode",
                "version.check",
                "contract.status",
                "negotiate",
                "key.build",
                "governor.run",
                "codec.encode",
                "codec.decode",
            },
        )
        # Without a memory there is no trace of two decisions; one is asked for.
        self.assertGreater(len(cases(peer, outcome="pass", call="governor.run")), 300)
        for call in ("decode", "encode", "version.check", "contract.status", "negotiate"):
            self.assertEqual(cases(peer, outcome="unsupported", call=call), [], call)

    def test_an_estop_that_does_not_stay_is_named_by_its_rule(self):
        peer = verdict("never_latches", "safety")
        failed = cases(peer, status="failed")
        rules = {rule for case in failed for rule in case["rules"]}
        self.assertIn("NCP-SAFE-005", rules)
        self.assertEqual({case["call"] for case in failed}, {"governor.run"})
        self.assertTrue(all(rule.startswith("NCP-SAFE-") for rule in rules), rules)

    def test_a_fence_that_only_holds_is_named_by_its_rule(self):
        peer = verdict("holds_for_estop", "safety")
        failed = cases(peer, status="failed", outcome="fail")
        rules = {rule for case in failed for rule in case["rules"]}
        self.assertIn("NCP-SAFE-043", rules)
        self.assertEqual({case["call"] for case in failed}, {"governor.run"})


if __name__ == "__main__":
    unittest.main()
