import assert from "node:assert/strict";
import { test } from "node:test";
import { ActionBuffer, decode, encode, SafetyGovernor, type CommandFrame } from "@ncp-conformance/peer";
import { at, moving, Random } from "./support.js";

const random = new Random(7);

/** Where a plant is over time that follows a command as its buffer says: the corners of its path. */
function pathOf(command: CommandFrame, from: readonly number[]): number[][] {
  const receivedS = 64;
  const buffer = new ActionBuffer();
  buffer.receive(encode(command), receivedS);
  const endMs = Math.min(command.ttl_ms, 60_000);
  const corners = [0, endMs];
  const tickMs = command.horizon_dt_ms ?? endMs;
  for (let tick = 1; tick <= command.horizon.length + 1; tick++) corners.push(tick * tickMs);
  const times = corners.filter((ms) => ms <= endMs).sort((a, b) => a - b);
  const path = [[...from]];
  for (let n = 1; n < times.length; n++) {
    const begin = times[n - 1]!;
    const end = times[n]!;
    // Between two corners the velocity is constant.
    const channels = buffer.active(receivedS + (begin + end) / 2000);
    const velocity = channels?.get("velocity_setpoint")?.data ?? [0, 0, 0];
    path.push(path.at(-1)!.map((x, axis) => x + velocity[axis]! * ((end - begin) / 1000)));
  }
  assert.equal(buffer.active(receivedS + endMs / 1000 + 0.01), null, "the watchdog holds the plant after its ttl");
  return path;
}

/** Which point of the way is the farthest out. */
function reachOf(path: readonly (readonly number[])[]): number {
  return Math.max(...path.map((point) => Math.hypot(...point)));
}

test("a plant that follows a governed command never leaves the ball", () => {
  const seen = { moved: 0, truncated: 0, held: 0, clamped: 0, nearlyOut: 0 };
  for (let n = 0; n < 8_000; n++) {
    const radius = 10 ** random.between(-3, 3);
    const position = random.vector(radius / (random.chance(2) ? 1.8 : 6));
    const maxSpeed = random.chance(2) ? null : radius * 10 ** random.between(-2, 2);
    const governor = new SafetyGovernor({ geofence_radius_m: radius, max_speed_mps: maxSpeed });
    const fast = (): number[] => random.vector(radius * 10 ** random.between(-1.5, 2));
    const horizon = Array.from({ length: random.chance(3) ? 0 : random.below(12) }, () => ({
      velocity_setpoint: { data: fast(), unit: random.pick(["m/s", null]) },
    }));
    const command = moving(fast(), {
      ttl_ms: random.chance(8) ? 10 ** random.between(4, 9) : random.between(1, 1500),
      horizon,
      horizon_dt_ms: random.between(1, 400),
    });
    const governed = governor.govern(command, 1, at(position), 1);
    if (Math.hypot(...position) > radius) {
      assert.equal(governed.mode, "estop");
      continue;
    }
    const reach = reachOf(pathOf(governed, position));
    assert.ok(reach <= radius * (1 + 1e-9), `${reach} of ${radius}: ${encode(command)}`);
    seen.moved += Number(governed.mode === "active");
    seen.held += Number(governed.mode === "hold");
    seen.truncated += Number(governed.mode === "active" && governed.horizon.length < horizon.length);
    seen.nearlyOut += Number(governed.mode === "active" && reach > 0.9 * radius);
    const before = command.channels.get("velocity_setpoint")!.data[0];
    seen.clamped += Number(
      governed.mode === "active" && governed.channels.get("velocity_setpoint")!.data[0] !== before,
    );
  }
  for (const [what, times] of Object.entries(seen)) assert.ok(times > 200, `${what}: only ${times}`);
});

test("a command is held or truncated only where its own path leaves the ball", () => {
  let passed = 0;
  let kept = 0;
  for (let n = 0; n < 4_000; n++) {
    const radius = 10;
    const position = random.vector(5);
    const governor = new SafetyGovernor({ geofence_radius_m: radius });
    const horizon = Array.from({ length: random.below(6) }, () => ({
      velocity_setpoint: { data: random.vector(40), unit: "m/s" },
    }));
    const command = moving(random.vector(30), { ttl_ms: random.between(50, 700), horizon, horizon_dt_ms: 100 });
    const governed = governor.govern(command, 1, at(position), 1);
    // What a shorter horizon would have allowed, tried out one length after the other.
    const longest = horizon.length;
    let expected: number | null = null;
    for (let length = longest; length >= 0 && expected === null; length--) {
      const shorter = { ...command, horizon: command.horizon.slice(0, length) };
      if (reachOf(pathOf(shorter, position)) <= radius) expected = length;
    }
    assert.equal(governed.mode, expected === null ? "hold" : "active");
    if (expected !== null) assert.equal(governed.horizon.length, expected);
    passed += Number(expected === longest);
    kept += Number(expected !== null && expected > 0 && expected < longest);
  }
  assert.ok(passed > 100 && kept > 100, `${passed} passed, ${kept} truncated`);
});

test("without a horizon tick 0 is projected for the whole ttl, up to one minute", () => {
  const governor = new SafetyGovernor({ geofence_radius_m: 60 });
  const modeOf = (ttl_ms: number, speed: number): string =>
    governor.govern(moving([speed, 0, 0], { ttl_ms }), 1, at([0, 0, 0]), 1).mode;
  assert.equal(modeOf(60_000, 1), "active");
  assert.equal(modeOf(1e12, 1), "active");
  assert.equal(modeOf(60_000, 1.0001), "hold");
  assert.equal(modeOf(1e12, 1.0001), "hold");
});

test("when the whole horizon is truncated, tick 0 must be safe for the whole ttl", () => {
  const governor = new SafetyGovernor({ geofence_radius_m: 1 });
  const away = { velocity_setpoint: { data: [100, 0, 0], unit: "m/s" } };
  const command = (speed: number): CommandFrame =>
    moving([speed, 0, 0], { ttl_ms: 1000, horizon: [away, away], horizon_dt_ms: 100 });
  const slow = governor.govern(command(1), 1, at([0, 0, 0]), 1);
  assert.equal(slow.mode, "active");
  assert.deepEqual(slow.horizon, []);
  // Safe for one tick, not for ten.
  assert.equal(governor.govern(command(1.01), 1, at([0, 0, 0]), 1).mode, "hold");
});

test("a truncated frame is still one that a plant can read", () => {
  const governor = new SafetyGovernor({ geofence_radius_m: 1 });
  const step = (speed: number): object => ({ velocity_setpoint: { data: [speed, 0, 0], unit: "m/s" } });
  const governed = governor.govern(
    moving([1, 0, 0], { ttl_ms: 1000, horizon: [step(-1), step(50), step(0)] as never, horizon_dt_ms: 100 }),
    1,
    at([0, 0, 0]),
    1,
  );
  assert.deepEqual(decode("command_frame", encode(governed)), governed);
  assert.equal(governed.horizon.length, 1);
});

test("a projection that overflows is outside of every fence", () => {
  const governor = new SafetyGovernor({ geofence_radius_m: Number.MAX_VALUE });
  for (const velocity of [
    [Number.MAX_VALUE, 0, 0],
    [-Number.MAX_VALUE, Number.MAX_VALUE, 0],
  ]) {
    assert.equal(governor.govern(moving(velocity, { ttl_ms: 2000 }), 1, at([0, 0, 0]), 1).mode, "hold");
  }
});
