"""The module's API: the published functions, and what is beyond them."""

import doctest
import inspect
import json
import math
import sys
import threading
import unittest
from pathlib import Path

import ncp

PROJECTION = Path(__file__).parents[3] / "proto" / "projection.json"
VELOCITY = {"velocity_setpoint": {"data": [1.0, 0.0, 0.0], "unit": "m/s"}}


def position(*axes):
    return {"channels": {"pose_position": {"data": list(axes), "unit": "m"}}}


class Published(unittest.TestCase):
    def test_the_constants_are_those_of_the_contract(self):
        contract = json.loads(PROJECTION.read_text("utf-8"))
        self.assertEqual(
            (ncp.NCP_VERSION, ncp.CONTRACT_HASH, ncp.DEFAULT_REALM), (contract["wire"], contract["contract_hash"], "ncp")
        )

    def test_the_functions_take_the_published_arguments(self):
        published = {
            "check_version": "(version, strict=False)",
            "contract_status": "(peer_hash=None)",
            "decode_command": "(codec_json, rates_json, t=0.0, seq=0, frame_id='world', mode='active')",
            "govern": "(limits_json, command_json, now_s, sensor_json=None, last_sensor_s=None)",
            "validate": "(kind, json)",
            "channel_value": "(data, unit=None)",
        }
        if sys.version_info >= (3, 10):  # before, the signature of a constructor cannot be seen
            published["Keys"] = "(realm=None)"
        for name, signature in published.items():
            with self.subTest(name):
                self.assertEqual(str(inspect.signature(getattr(ncp, name))), signature)

    def test_keys_are_built_for_the_default_realm_and_for_another(self):
        keys, other = ncp.Keys(), ncp.Keys(realm="a/b")
        self.assertEqual(keys.rpc(), "ncp/rpc")
        self.assertEqual(other.sensor("s"), "a/b/session/s/sensor")
        self.assertEqual(other.sensor_named("s", "n"), "a/b/session/s/sensor/n")
        self.assertEqual(other.command("s"), "a/b/session/s/command")
        self.assertEqual(other.command_named("s", "n"), "a/b/session/s/command/n")
        self.assertEqual(other.observation("s"), "a/b/session/s/observation")
        self.assertEqual(other.session_glob("s"), "a/b/session/s/**")

    def test_a_version_is_compatible_or_not_and_strict_raises(self):
        self.assertIs(ncp.check_version(ncp.NCP_VERSION), True)
        self.assertIs(ncp.check_version("0.4"), False)
        for version, strict in [("0.4", True), ("0.4.0", False), ("v1", False)]:
            with self.subTest(version), self.assertRaises(ncp.NcpError) as caught:
                ncp.check_version(version, strict)
            self.assertEqual(caught.exception.code, "version")

    def test_the_contract_status_is_one_of_three_words(self):
        self.assertEqual(ncp.contract_status(), "not_advertised")
        self.assertEqual(ncp.contract_status(ncp.CONTRACT_HASH), "match")
        self.assertEqual(ncp.contract_status("2cf0763ad61e4f1c"), "mismatch")

    def test_validate_gives_the_frame_with_every_field(self):
        frame = json.loads(ncp.validate("command_frame", '{"seq":7,"kind":"command_frame"}'))
        self.assertEqual((frame["mode"], frame["seq"], frame["horizon_dt_ms"]), ("hold", 7, None))

    def test_validate_accepts_what_this_peer_may_read_and_not_send(self):
        frame = '{"kind":"capabilities","controller_id":"c","sensor_channels":[{"name":"a","kind":"quaternion9"}]}'
        self.assertEqual(json.loads(ncp.validate("capabilities", frame))["kind"], "capabilities")

    def test_a_codec_is_read_in_the_form_of_every_published_build(self):
        mapping = {"channel": "e", "component": 0, "population": "p", "rate_range": [5, 50]}
        own = {"encoders": [mapping], "decoders": []}
        published = {
            "codec_id": "ncp.codec.rate.v0",
            "encoder": [{"channel": "e", "population": "p", "coding": "rate", "rate_range_hz": [5, 50], "n_neurons": 3}],
        }
        sensor = json.dumps({"kind": "sensor_frame", "channels": {"e": {"data": [0.5]}}})
        rates = [json.loads(ncp.encode_rates(json.dumps(codec), sensor)) for codec in (own, published, {})]
        self.assertEqual(rates, [{"p": 38.75}, {"p": 38.75}, {}])
        for other in ({"codec_id": "x"}, {"encoder": [{"population": "p"}]}, []):
            with self.assertRaises(ncp.NcpError):
                ncp.encode_rates(json.dumps(other), sensor)

    def test_the_uav_codec_goes_from_the_middle_to_the_middle(self):
        # [NCP-CODEC-005] [NCP-CODEC-006]
        self.assertEqual(json.loads(ncp.encode_rates('"uav"')), {"err_x": 100.0, "err_y": 100.0, "err_z": 100.0})
        command = json.loads(ncp.decode_command('"uav"', '{"vel_x": 200}', 1.5, 9))
        self.assertEqual(command["channels"]["velocity_setpoint"], {"data": [1.5, 0.0, 0.0], "unit": "m/s"})
        self.assertEqual((command["t"], command["seq"], command["mode"]), (1.5, 9, "active"))

    def test_govern_stops_beyond_the_fence(self):
        # [NCP-SAFE-043]
        command = ncp.encode("command_frame", {"channels": VELOCITY})
        sensor = ncp.encode("sensor_frame", position(0.0, 6.0, 0.0))
        frame = json.loads(ncp.govern('{"geofence_radius_m": 5}', command, 1.0, sensor, 1.0))
        self.assertEqual(frame["mode"], "estop")
        self.assertEqual(frame["channels"]["velocity_setpoint"]["data"], [0.0, 0.0, 0.0])

    def test_a_channel_value_is_json(self):
        self.assertEqual(json.loads(ncp.channel_value([1, 2.5], "m")), {"data": [1.0, 2.5], "unit": "m"})
        self.assertEqual(json.loads(ncp.channel_value(3)), {"data": [3.0], "unit": None})


class Messages(unittest.TestCase):
    def test_a_dict_takes_the_defaults_of_a_program_and_a_frame_those_of_a_receiver(self):
        built = json.loads(ncp.encode("command_frame", {}))["mode"]
        read = ncp.decode("command_frame", REQUIRED)["mode"]
        self.assertEqual((built, read), ("active", "hold"))

    def test_every_field_comes_back_as_it_went(self):
        fields = {
            "seq": -3,
            "t": 0.1,
            "frame_id": "NaN",
            "mode": "init",
            "ttl_ms": 1e-300,
            "channels": {"ä\u0000": {"data": [-0.0, 1e308], "unit": None}},
            "horizon": [VELOCITY, {}],
            "horizon_dt_ms": 20.0,
        }
        read = ncp.decode("command_frame", ncp.encode("command_frame", fields))
        self.assertEqual({name: read[name] for name in fields}, fields)
        self.assertEqual(math.copysign(1, read["channels"]["ä\u0000"]["data"][0]), -1.0)

    def test_a_refusal_names_its_code_and_the_field(self):
        for fields, code, path in [
            ({"seq": 1.5}, "type", "seq"),
            ({"seq": True}, "type", "seq"),
            ({"seq": 2**70}, "value", "seq"),
            ({"t": "NaN"}, "type", "t"),
            ({"t": math.inf}, "non_finite", "t"),
            ({"t": 10**400}, "value", "t"),
            ({"speed": 1}, "invalid", "speed"),
            ({"channels": {"a": {"data": [0.0, "x"]}}}, "type", "channels.a.data[1]"),
            ({"channels": {"a": {"unit": 5}}}, "type", "channels.a.unit"),
            ({"horizon": [{}, {"a": 1}]}, "type", "horizon[1].a"),
        ]:
            with self.subTest(fields), self.assertRaises(ncp.NcpError) as caught:
                ncp.encode("command_frame", fields)
            self.assertEqual((caught.exception.code, caught.exception.path), (code, path))
            self.assertIsInstance(caught.exception, ValueError)

    def test_a_reply_that_reports_a_failure_is_refused(self):
        request = ncp.encode("close_session", {"session_id": "s"})
        ncp.check_reply(request, ncp.encode("session_closed", {"session_id": "s"}))
        with self.assertRaises(ncp.NcpError) as caught:
            ncp.check_reply(request, ncp.encode("error", {"error": "no"}))
        self.assertEqual(caught.exception.code, "reply")


class Objects(unittest.TestCase):
    def test_estop_stays_until_it_is_reset(self):
        # [NCP-SAFE-005] [NCP-SAFE-008]
        governor = ncp.SafetyGovernor({"geofence_radius_m": 5.0})
        command = {"channels": VELOCITY}
        modes = []
        for x, now_s in [(0.0, 1.0), (6.0, 2.0), (0.0, 3.0)]:
            modes.append(governor.govern(command, now_s, position(x, 0.0, 0.0), now_s)["mode"])
        self.assertEqual(modes, ["active", "estop", "estop"])
        self.assertTrue(governor.is_stopped)
        governor.reset()
        self.assertEqual(governor.govern(command, 4.0, position(0.0, 0.0, 0.0), 4.0)["mode"], "active")

    def test_a_governor_holds_what_is_no_number(self):
        governor = ncp.SafetyGovernor("{}")
        held = governor.govern({"channels": {"velocity_setpoint": {"data": [math.nan] * 3}}}, 1.0, {}, 1.0)
        self.assertEqual((held["mode"], governor.decision, governor.reason), ("hold", "held", "not_finite"))

    def test_a_limit_of_an_unknown_name_is_refused(self):
        for limits in [{"max_speed": 1.0}, '{"max_speed": 1.0}', "[]", '{"max_speed_mps":1,"max_speed_mps":2}', "{} {}"]:
            with self.subTest(limits), self.assertRaises(ValueError):
                ncp.SafetyGovernor(limits)

    def test_a_limit_without_its_channel_is_a_config_fault(self):
        # [NCP-SAFE-014] [NCP-SAFE-009]
        governor = ncp.SafetyGovernor({"max_speed_mps": 1.0}, [], [])
        self.assertTrue(governor.has_config_fault)
        governor.reset()
        self.assertTrue(governor.has_config_fault)

    def test_a_duplicate_does_not_refresh_the_watchdog(self):
        # [NCP-RES-004]
        watchdog = ncp.CommandWatchdog()
        self.assertTrue(watchdog.should_hold(0.0))
        self.assertTrue(watchdog.on_command(0.0, 100.0, 1))
        self.assertFalse(watchdog.on_command(0.09, 100.0, 1))
        self.assertEqual([watchdog.should_hold(at) for at in (0.05, 0.11)], [False, True])

    def test_a_broken_frame_that_says_estop_stops_the_plant(self):
        # [NCP-RES-022]
        buffer = ncp.ActionBuffer()
        self.assertEqual(buffer.on_frame(b'{"kind":"command_frame","mode":"estop","seq":\xff', 1.0), "stopped")
        self.assertTrue(buffer.is_stopped)
        with self.assertRaises(ncp.NcpError):
            buffer.on_frame(b"\xff", 1.0)

    def test_a_horizon_is_replayed_and_ends(self):
        # [NCP-RES-028] [NCP-RES-029]
        buffer = ncp.ActionBuffer()
        steps = [{"velocity_setpoint": {"data": [x, 0.0, 0.0]}} for x in (2.0, 3.0)]
        command = {"seq": 1, "ttl_ms": 1000.0, "channels": VELOCITY, "horizon": steps, "horizon_dt_ms": 100.0}
        self.assertEqual(buffer.on_command(command, 0.0), "accepted")
        active = [buffer.active(at) for at in (0.05, 0.15, 0.25, 0.35)]
        speeds = [channels and channels["velocity_setpoint"]["data"][0] for channels in active]
        self.assertEqual(speeds, [1.0, 2.0, 3.0, None])

    def test_the_link_monitor_counts_a_gap_and_takes_a_late_frame_back(self):
        link = ncp.LinkMonitor()
        for seq in (1, 2, 5):
            link.on_frame(seq)
        self.assertEqual(link.report().lost, 2)
        link.on_frame(4)
        report = link.report()
        self.assertEqual((report.last_seq, report.received, report.lost, report.burst), (5, 4, 1, False))

    def test_max_horizon_len_counts_whole_ticks(self):
        self.assertEqual([ncp.max_horizon_len(200, dt) for dt in (50, 60, 0, math.nan)], [4, 3, 0, 0])

    def test_the_loop_answers_a_sensor_with_a_command(self):
        loop = ncp.ControlLoop(20.0, {"max_speed_mps": 5.0}, ncp.ReflexController([1.0, 0.0, 0.0]))
        self.assertTrue(loop.on_sensor({"seq": 3, **position(0.0, 0.0, 0.0)}, 1.0))
        tick = loop.tick(1.01)
        self.assertEqual((tick.command["seq"], tick.status["mode"], tick.decision), (3, "active", "passed"))
        self.assertEqual(tick.command["channels"]["velocity_setpoint"]["data"], [1.0, 0.0, 0.0])

    def test_the_service_answers_each_request_and_whatever_else_it_gets(self):
        service = ncp.SessionService()
        for request in (b"\xff", "", "[]", '{"kind":"teleport"}'):
            self.assertEqual(json.loads(service.serve(request))["kind"], "error")
        self.assertEqual(service.open_sessions, [])

    def test_planes_and_globs_are_told(self):
        qos = ncp.plane_qos("action")
        self.assertEqual((qos.congestion, qos.priority, qos.express), ("drop", "RealTime", True))
        self.assertTrue(ncp.key_matches(ncp.Keys().sensor_glob("s"), ncp.Keys().sensor_named("s", "n")))

    def test_a_governor_can_be_shared_by_threads(self):
        governor = ncp.SafetyGovernor({})
        failures = []

        def work():
            try:
                for _ in range(300):
                    governor.govern({}, 1.0, {}, 1.0)
                    governor.note_link(False)
            except BaseException as error:  # whatever it is, it must not happen
                failures.append(error)

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failures, [])


class Documentation(unittest.TestCase):
    def test_everything_public_says_what_it_is(self):
        for name in ncp.__all__:
            if name.isupper() or name == "__version__":
                continue
            thing = getattr(ncp, name)
            self.assertTrue((thing.__doc__ or "").strip(), name)
            for member, value in vars(thing).items() if inspect.isclass(thing) else ():
                if not member.startswith("_") and member not in ("count", "index"):
                    self.assertTrue((value.__doc__ or "").strip(), f"{name}.{member}")

    def test_the_examples_of_the_readme_hold(self):
        readme = Path(__file__).resolve().parents[1] / "README.md"
        failed, tried = doctest.testfile(str(readme), module_relative=False)
        self.assertEqual(failed, 0)
        self.assertGreater(tried, 20)


#: A command frame with what is required and nothing else.
REQUIRED = '{"kind":"command_frame","seq":1}'

if __name__ == "__main__":
    unittest.main()
