import random
import unittest
from fractions import Fraction
from math import hypot, inf, nan

import ncp_pure as ncp

SECONDS = [0.0, 0.1, 0.25, 0.5, 1.0, 59.0, 60.0, 61.0, -1.0, nan, inf]


class Governor(unittest.TestCase):
    def test_a_plant_that_follows_a_governed_command_does_not_leave_the_ball(self):
        source = random.Random(1)
        passed = truncated = 0
        for _ in range(6000):
            radius = source.choice([1.0, 5.0])
            limits = ncp.SafetyLimits(
                geofence_radius_m=radius, max_speed_mps=source.choice([None, 0.5, 3.0])
            )
            position = [source.uniform(-0.7, 0.7) * radius for _ in range(3)]
            command = random_command(source)
            sensor = ncp.SensorFrame(channels={"pose_position": ncp.ChannelValue(data=position)})
            frame = ncp.SafetyGovernor(limits).govern(command, 1.0, sensor, 1.0)
            if frame.mode == "active":
                passed += 1
                truncated += len(frame.horizon) < len(command.horizon)
            self.assertLessEqual(farthest(frame, position), max(radius, hypot(*position)) * (1 + 1e-12))
        self.assertGreater(min(passed, truncated), 50)

    def test_no_velocity_that_passes_is_above_the_limit_and_none_turns(self):
        source = random.Random(2)
        governor = ncp.SafetyGovernor(ncp.SafetyLimits(max_speed_mps=1.1))
        for _ in range(3000):
            size = 10.0 ** source.randrange(-3, 308)
            data = [source.uniform(-1, 1) * size for _ in range(3)]
            command = ncp.CommandFrame(
                channels={"velocity_setpoint": ncp.ChannelValue(data=data, unit="m/s")}
            )
            out = governor.govern(command, 1.0, None, 1.0).channels["velocity_setpoint"].data
            self.assertLessEqual(hypot(*out), 1.1)
            largest = max(data, key=abs)
            scale = out[data.index(largest)] / largest
            for before, after in zip(data, out):
                self.assertAlmostEqual(after, before * scale, delta=1e-12)

    def test_a_small_component_beside_a_huge_one_is_scaled_and_not_lost(self):
        for huge, small, limit in ((8e138, 3e-284, 7.7e138), (1e170, 1e-120, 1e-10), (1e-150, 1e-200, 5e-151)):
            governor = ncp.SafetyGovernor(ncp.SafetyLimits(max_speed_mps=limit))
            velocity = ncp.ChannelValue(data=[huge, small, 0.0], unit="m/s")
            command = ncp.CommandFrame(channels={"velocity_setpoint": velocity})
            scaled = governor.govern(command, 1.0, None, 1.0).channels["velocity_setpoint"].data
            self.assertLessEqual(hypot(*scaled), limit)
            self.assertAlmostEqual(scaled[0] / limit, 1.0, places=12)
            exact = Fraction(small) * Fraction(limit) / Fraction(huge)
            self.assertAlmostEqual(scaled[1], float(exact), delta=max(1e-300, 1e-9 * float(exact)))

    def test_a_norm_that_only_rounding_brings_onto_the_fence_is_outside_of_it(self):
        # [NCP-SAFE-043] [NCP-SAFE-045]
        least = 5e-324
        for radius, position, mode in (
            (least, [least, least, 0.0], "estop"),
            (least, [least, 0.0, 0.0], "active"),
            (5 * least, [3 * least, 4 * least, 0.0], "active"),
            (least, [1e300, 0.0, 0.0], "estop"),
        ):
            sensor = ncp.SensorFrame(channels={"pose_position": ncp.ChannelValue(data=position, unit="m")})
            still = ncp.ChannelValue(data=[0.0, 0.0, 0.0], unit="m/s")
            command = ncp.CommandFrame(mode="active", channels={"velocity_setpoint": still})
            governor = ncp.SafetyGovernor(ncp.SafetyLimits(geofence_radius_m=radius))
            self.assertEqual(governor.govern(command, 1.0, sensor, 1.0).mode, mode, (radius, position))

    def test_a_channel_that_is_declared_twice_has_the_unit_of_the_first_declaration(self):
        # [NCP-SAFE-042]
        drive = ncp.ChannelSpec(name="velocity_setpoint", kind="vec3", unit="m/s")
        speed = ncp.ChannelSpec(name="arm", kind="scalar", unit="m/s")
        force = ncp.ChannelSpec(name="arm", kind="scalar", unit="N")
        command = ncp.CommandFrame(
            channels={
                "velocity_setpoint": ncp.ChannelValue(data=[0.0, 0.0, 0.0]),
                "arm": ncp.ChannelValue(data=[8.0]),
            }
        )
        for twice, wanted in [((speed, force), [1.0]), ((force, speed), [8.0])]:
            limits = ncp.SafetyLimits(max_speed_mps=1.0)
            governor = ncp.SafetyGovernor(limits, command_channels=[drive, *twice])
            self.assertEqual(governor.govern(command, 1.0, None, 1.0).channels["arm"].data, wanted)

    def test_an_estop_stays_until_the_reset_and_a_bad_limit_for_ever(self):
        still = ncp.CommandFrame(
            channels={"velocity_setpoint": ncp.ChannelValue(data=[0.0] * 3, unit="m/s")}
        )
        governor = ncp.SafetyGovernor(ncp.SafetyLimits())
        governor.note_link(True)
        governor.note_link(False)
        self.assertEqual(governor.govern(still, 1.0, None, 1.0).mode, "estop")
        governor.reset()
        self.assertEqual(governor.govern(still, 1.0, None, 1.0).mode, "active")
        bad = ncp.SafetyGovernor(ncp.SafetyLimits(max_speed_mps=-1.0))
        bad.reset()
        self.assertEqual(bad.govern(still, 1.0, None, 1.0).mode, "hold")


def random_command(source):
    fastest = source.choice([0.1, 1.0, 4.0])

    def tick():
        data = [source.uniform(-fastest, fastest) for _ in range(3)]
        return {"velocity_setpoint": ncp.ChannelValue(data=data, unit="m/s")}

    return ncp.CommandFrame(
        ttl_ms=source.choice([10.0, 500.0, 5000.0, 1e9]),
        channels=tick(),
        horizon=[tick() for _ in range(source.randrange(6))],
        horizon_dt_ms=source.choice([5.0, 100.0, 1000.0]),
    )


def farthest(frame, position):
    """How far from the origin a plant comes that asks its action buffer what to do, at every tick's end."""
    reached, far = list(position), hypot(*position)
    if frame.mode != "active":
        return far
    ttl = min(frame.ttl_ms, 60_000.0) / 1000
    dt = frame.horizon_dt_ms / 1000
    ticks = [frame.channels, *frame.horizon]
    for k, tick in enumerate(ticks):
        end = min((k + 1) * dt, ttl) if frame.horizon else ttl
        velocity = tick["velocity_setpoint"].data
        reached = [x + v * max(0.0, end - k * dt) for x, v in zip(reached, velocity)]
        far = max(far, hypot(*reached))
    return far


class Liveness(unittest.TestCase):
    """The liveness rule of section 8.1, by what a plant may do at most."""

    def test_the_watchdog_lets_a_plant_move_only_within_the_ttl_of_an_advancing_command(self):
        watchdog = ncp.CommandWatchdog
        self.follow(watchdog, watchdog.on_command, lambda dog, now: not dog.should_hold(now))

    def test_the_buffer_lets_a_plant_move_only_within_the_ttl_of_an_advancing_command(self):
        def feed(buffer, now, ttl, seq):
            buffer.on_command(ncp.CommandFrame(seq=seq, ttl_ms=ttl), now)

        self.follow(ncp.ActionBuffer, feed, lambda buffer, now: buffer.active(now) is not None)

    def follow(self, build, feed, moves):
        source = random.Random(3)
        moved = 0
        for _ in range(3000):
            plant, accepted, last = build(), [], None
            for _ in range(8):
                now = source.choice(SECONDS)
                if source.random() < 0.5:
                    ttl, seq = source.choice([100.0, 1000.0, 1e9, 0.0, -1.0, nan, inf]), source.randrange(4)
                    feed(plant, now, ttl, seq)
                    if last is None or seq > last:
                        last = seq
                        accepted.append((now, ttl))
                elif moves(plant, now):
                    moved += 1
                    received, ttl = accepted[-1]
                    self.assertTrue(received <= now and (now - received) * 1000 <= min(ttl, 60_000) < inf)
        self.assertGreater(moved, 300)


class Estop(unittest.TestCase):
    def test_an_estop_latches_whatever_else_is_wrong_with_its_frame(self):
        for frame in (
            b'{"kind":"command_frame","mode":"estop"}',
            b'{"mode":"hold","kind":"command_frame","mode":"e\\u0073top","mode":"active"}',
            b'{"kind":"command_frame","seq":"x","\\u006dode":"estop"}',
            b'{"kind":"command_frame","a":' + b"[" * 5000 + b"]" * 5000 + b',"mode":"estop"}',
            b'{"kind":"command_frame","a":"' + b"x" * (2 << 20) + b'","mode":"estop"}',
            b' {"a":{"mode":1},"kind":"command_frame","mode":"estop","t":1e999}',
        ):
            buffer = ncp.ActionBuffer()
            try:
                buffer.on_frame(frame, 0.0)
            except ncp.DecodeError:
                pass
            self.assertTrue(buffer.estopped, frame[:60])

    def test_the_word_alone_latches_nothing(self):
        for frame in (
            b'{"kind":"sensor_frame","mode":"estop"}',
            b'{"kind":"command_frame","a":{"mode":"estop"}}',
            b'{"kind":"command_frame","mode":"ESTOP"}',
            b'{"kind":"command_frame","a":"\\"mode\\":\\"estop\\""}',
            b'{"kind":"command_frame","mode":["estop"]}',
            b'{"kind":"command_frame","estop":"mode"}',
            b'["command_frame","mode","estop"]',
            b'{"kind":"command_frame","a":"' + b'\\"' * (1 << 19),
        ):
            self.assertFalse(ncp.is_estop(frame), frame[:60])


class Link(unittest.TestCase):
    def test_the_counts_are_those_of_a_monitor_that_forgets_nothing(self):
        source = random.Random(5)
        for _ in range(300):
            monitor, seen = ncp.LinkMonitor(), set()
            start = source.randrange(-5, 5)
            for _ in range(30):
                seq = start + source.randrange(40)
                monitor.on_frame(seq)
                if not seen or seq >= first:
                    first = min(seen, default=seq)
                    seen.add(seq)
                state = monitor.state()
                slots = max(seen) + 1 - first
                self.assertEqual(state[:3], (max(seen), len(seen), slots - len(seen)))
                self.assertEqual(state.loss_rate, (slots - len(seen)) / slots)

    def test_a_gap_between_any_two_seqs_trips_the_burst_and_a_healthy_link_clears_it(self):
        monitor = ncp.LinkMonitor()
        monitor.on_frame(-(2**53) + 1)
        monitor.on_frame(2**53 - 1001)
        self.assertTrue(monitor.state().burst)
        self.assertLessEqual(monitor.state().loss_rate, 1.0)
        self.assertLessEqual(monitor.state().lost, 2**53 - 1)
        for seq in range(2**53 - 1000, 2**53 - 800):
            monitor.on_frame(seq)
        self.assertFalse(monitor.state().burst)


if __name__ == "__main__":
    unittest.main()
