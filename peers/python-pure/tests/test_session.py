import json
import random
import subprocess
import sys
import unittest
from math import exp
from pathlib import Path

import ncp_pure as ncp

from . import samples

NETWORK = ncp.NetworkRef(ref="ncp.reference.lif", population_sizes={"p": 2}, params={"I_e": 300.0})
RECORD = ncp.RecordSpec(targets=[ncp.RecordTarget(port="v", target="p", ids=[2])])


def client(service, session="s", **settings):
    return ncp.Client(lambda key, frame: service.handle(frame), session, **settings)


class Sessions(unittest.TestCase):
    def test_the_membrane_follows_its_closed_form(self):
        session = client(ncp.SessionService())
        session.open(NETWORK, record=RECORD)
        observed = session.step(20.0).records["v"]
        self.assertEqual(observed.senders, [2] * 20)
        for t, v in zip(observed.times, observed.values):
            self.assertAlmostEqual(v, -70.0 + 300.0 * 10 / 250 * (1 - exp(-t / 10)), places=9)

    def test_a_spike_comes_when_the_closed_form_reaches_the_threshold(self):
        session = client(ncp.SessionService())
        target = ncp.RecordTarget(port="s", target="p", observable="spikes", ids=[1])
        record = ncp.RecordSpec(targets=[target])
        stimulus = ncp.StimulusSpec(targets=[ncp.StimulusTarget(port="i", target="p", ids=[1])])
        session.open(NETWORK, record=record, stimulus=stimulus)
        drive = ncp.StimulusFrame(session_id="s", values={"i": ncp.ChannelValue(data=[200.0])})
        times = session.run(100.0, drive).records["s"].times
        step = next(n for n in range(1000) if 20.0 * (1 - exp(-n / 100)) >= 15.0)
        period = step + 20  # the refractory time
        wanted = [(step + k * period) / 10 for k in range(len(times))]
        self.assertEqual([round(t, 6) for t in times], wanted)
        self.assertGreater(len(times), 5)

    def test_a_time_is_the_nearest_number_of_steps(self):
        # [NCP-SESS-053] [NCP-SESS-058] Steps of 0.1 ms; 0.15 / 0.1 is below one and a half as a double.
        table = {0.04: 0, 0.05: 1, 0.14: 1, 0.15: 1, 0.16: 2, 0.25: 3, 0.3: 3, 0.34: 3, 0.36: 4, 0.45: 5}
        for time, steps in table.items():
            record = ncp.RecordSpec(targets=[ncp.RecordTarget(port="v", target="p", ids=[1], cadence_ms=time)])
            session = client(ncp.SessionService())
            session.open(NETWORK, record=record)
            for nth in range(1, 21):
                self.assertAlmostEqual(session.run(time).sim_time_ms, nth * steps * 0.1)
            run, every = 20 * steps, max(1, steps)
            sampled = [round(t * 10) for t in session.run(20.0).records["v"].times]
            self.assertEqual(sampled, [n for n in range(run + 1, run + 201) if n % every == 0], time)
        session = client(ncp.SessionService())
        session.open(NETWORK, sim=ncp.SimConfig(dt_ms=1.0))
        self.assertEqual(session.run(0.49999999999999994).sim_time_ms, 0.0)

    def test_a_value_of_a_request_without_steps_acts_from_the_next_step(self):
        # [NCP-SESS-054] [NCP-SESS-058]
        stimulus = ncp.StimulusSpec(targets=[ncp.StimulusTarget(port="i", target="p")])
        service = ncp.SessionService()
        drive = lambda session: ncp.StimulusFrame(session_id=session, values={"i": ncp.ChannelValue(data=[200.0])})
        values = []
        for id, first in (("a", 0.01), ("b", None)):
            session = client(service, id)
            session.open(NETWORK, record=RECORD, stimulus=stimulus)
            if first:
                self.assertEqual(session.run(first, drive(id)).records["v"].times, [])
            values.append(session.run(5.0, None if first else drive(id)).records["v"].values)
        self.assertEqual(values[0], values[1])

    def test_samples_come_by_time_and_then_as_the_ids_are_named(self):
        # [NCP-SESS-059]
        targets = [ncp.RecordTarget(port=port, target="p", ids=ids) for port, ids in (("all", []), ("named", [2, 1]))]
        session = client(ncp.SessionService())
        session.open(NETWORK, record=ncp.RecordSpec(targets=targets))
        records = session.run(2.0).records
        self.assertEqual(records["all"].senders, [1, 2, 1, 2])
        self.assertEqual(records["named"].senders, [2, 1, 2, 1])
        self.assertEqual(records["named"].times, [1.0, 1.0, 2.0, 2.0])

    def test_any_bytes_get_exactly_one_reply(self):
        source = random.Random(1)
        service = ncp.SessionService()
        kinds = list(ncp.FRAMES.values())
        for _ in range(1500):
            frame = bytearray(ncp.encode(samples.message(source, source.choice(kinds))))
            if source.random() < 0.5:
                frame[source.randrange(len(frame))] = source.randrange(256)
            reply = json.loads(service.handle(bytes(frame)))
            self.assertIn(reply["kind"], ("error", "session_opened", "observation_frame", "session_closed"))

    def test_a_request_that_fails_changes_nothing(self):
        session = client(ncp.SessionService())
        session.open(NETWORK, record=RECORD)
        stimulus = ncp.StimulusFrame(session_id="s", values={"none": ncp.ChannelValue(data=[1.0])})
        for duration, values in ((5.0, stimulus), (-1.0, None), (1e300, None)):
            with self.assertRaises(ncp.ReplyError):
                session.run(duration, values)
        self.assertEqual(session.step(1.0).sim_time_ms, 1.0)

    def test_a_client_closes_only_what_it_opened(self):
        service = ncp.SessionService()
        owner, borrower = client(service), client(service)
        owner.open(NETWORK)
        self.assertFalse(borrower.close())
        borrower.step(1.0)
        self.assertTrue(owner.close())
        with self.assertRaises(ncp.ReplyError):
            borrower.step(1.0)


class Adapter(unittest.TestCase):
    def test_it_answers_each_request_and_ends_with_the_input(self):
        requests = [
            {"id": 1, "call": "describe"},
            {"id": 2, "call": "no.such.call", "args": {}},
            {"id": 3, "call": "key.build", "args": {"key": "rpc", "realm": "a//b"}},
        ]
        done = subprocess.run(
            [sys.executable, "adapter.py"],
            input="\n".join(map(json.dumps, requests)),
            capture_output=True,
            text=True,
            cwd=Path(__file__).parents[1],
            timeout=60,
        )
        answers = {answer["id"]: answer for answer in map(json.loads, done.stdout.splitlines())}
        self.assertEqual(done.returncode, 0)
        self.assertEqual(answers[1]["result"]["contract_hash"], ncp.CONTRACT_HASH)
        self.assertEqual(answers[2], {"id": 2, "unsupported": True})
        self.assertEqual(answers[3]["error"]["code"], "key")


if __name__ == "__main__":
    unittest.main()
