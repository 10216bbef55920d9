import assert from "node:assert/strict";
import { test } from "node:test";
import {
  create,
  encode,
  SafetyGovernor,
  type CommandFrame,
  type Input,
  type Mode,
  type NegotiatedChannels,
  type SafetyLimits,
} from "@ncp-conformance/peer";
import { limited, norm } from "#dist/vector.js";
import { at, moving, Random } from "./support.js";

const random = new Random(70);
const MODES: readonly Mode[] = ["init", "active", "hold", "estop"];

const POSITION = { name: "pose_position", kind: "vec3", unit: "m" };
const VELOCITY = { name: "velocity_setpoint", kind: "vec3", unit: "m/s" };

function channels(
  sensor_channels: Input<"capabilities">["sensor_channels"],
  command_channels: Input<"capabilities">["command_channels"],
): NegotiatedChannels {
  return create("capabilities", { controller_id: "c", sensor_channels, command_channels });
}

/** What a governor of these limits makes of one command, with a fresh sensor frame at the origin. */
function governed(limits: Partial<SafetyLimits>, command: CommandFrame, among?: NegotiatedChannels): CommandFrame {
  return new SafetyGovernor(limits, among).govern(command, 10, at([0, 0, 0]), 10);
}

test("a command that no gate closes on passes unchanged", () => {
  const command = moving([0.5, -0, 0.25], {
    ttl_ms: 100,
    t: 3,
    frame_id: "map",
    horizon: [{ velocity_setpoint: { data: [0.1, 0, 0] }, light: { data: [9] } }],
    horizon_dt_ms: 50,
    channels: { velocity_setpoint: { data: [0.5, -0, 0.25] }, light: { data: [1, 2], unit: "lx" } },
  });
  const before = encode(command);
  for (const limits of [{}, { max_speed_mps: 1 }, { geofence_radius_m: 1 }, { max_speed_mps: 0, max_tilt_rad: NaN }]) {
    assert.equal(encode(governed(limits, command)), before);
  }
  assert.equal(encode(command), before);
});

test("only an active command comes out of the governor with anything but zeros", () => {
  for (let n = 0; n < 5_000; n++) {
    const governor = new SafetyGovernor({
      max_speed_mps: random.pick([null, 0, 1, NaN, -1]),
      geofence_radius_m: random.pick([null, 0, 2, Infinity]),
      command_timeout_ms: random.pick([500, 0, NaN]),
    });
    for (let step = 0; step < 8; step++) {
      if (random.chance(6)) governor.noteLink(random.chance(2));
      if (random.chance(6)) governor.reset();
      const wasStopped = governor.stopped;
      const command = moving(random.vector(3), { mode: random.pick(MODES) });
      const sensor = random.chance(5) ? null : at(random.vector(1.5));
      const out = governor.govern(command, 10, sensor, random.pick([10, 9.8, 9, 11, NaN, null]));
      const still = [...out.channels.values()].every(({ data }) => data.every((component) => component === 0));
      if (out.mode === "active") {
        assert.equal(command.mode, "active");
        assert.ok(!wasStopped && governor.configFault === null);
      } else {
        assert.ok(still && out.horizon.length === 0);
      }
      assert.equal(out.mode === "estop", governor.stopped);
      assert.ok(governor.stopped || !wasStopped);
    }
  }
});

test("a channel is scaled by all of its components, also by many that are each lost beside a great one", () => {
  const [great, small, many] = [1, 1.04e-8, 90_000];
  const scaled = limited(Float64Array.from({ length: many + 1 }, (_, n) => (n === 0 ? great : small)), 0.5);
  // The norm before is 1 + many * small^2 / 2, but for what its square is of that.
  const expected = 0.5 / (1 + (many * small * small) / 2);
  assert.ok(Math.abs(scaled[0]! / expected - 1) < 1e-12, `${scaled[0]} is not ${expected}`);
});

test("an ESTOP is latched until a reset, and a reset brings no fail-closed governor back", () => {
  const governor = new SafetyGovernor({ max_speed_mps: -1 });
  const modeOf = (mode: Mode): string => governor.govern(moving([0, 0, 0], { mode }), 10, null, 10).mode;
  assert.equal(modeOf("active"), "hold");
  assert.equal(modeOf("estop"), "estop");
  assert.equal(modeOf("active"), "estop");
  governor.reset();
  assert.equal(modeOf("active"), "hold");
  governor.noteLink(false);
  assert.equal(modeOf("active"), "hold");
  governor.noteLink(true);
  governor.noteLink(false);
  assert.equal(modeOf("active"), "estop");
  governor.reset();
  assert.equal(modeOf("active"), "hold");
});

test("a limit that is negative or not finite, or whose channel does not fit, holds every command", () => {
  const speed = { max_speed_mps: 1 };
  const fence = { geofence_radius_m: 1 };
  const faults: [Partial<SafetyLimits>, NegotiatedChannels | undefined][] = [
    ...[-1, NaN, Infinity, -Infinity, -Number.MIN_VALUE].flatMap((value): [Partial<SafetyLimits>, undefined][] => [
      [{ max_speed_mps: value }, undefined],
      [{ geofence_radius_m: value }, undefined],
    ]),
    [speed, channels([POSITION], [])],
    [fence, channels([], [VELOCITY])],
    [speed, channels([POSITION], [{ ...VELOCITY, unit: "km/h" }])],
    [speed, channels([POSITION], [{ ...VELOCITY, unit: null }])],
    [speed, channels([POSITION], [{ ...VELOCITY, kind: "scalar" }])],
    [speed, channels([POSITION], [{ ...VELOCITY, kind: "array", size: 2 }])],
    [speed, channels([POSITION], [VELOCITY, { ...VELOCITY, unit: "km/h" }])],
    [fence, channels([{ ...POSITION, unit: "cm" }], [VELOCITY])],
    [fence, channels([{ ...POSITION, kind: "quat" }], [VELOCITY])],
  ];
  for (const [limits, among] of faults) {
    const governor = new SafetyGovernor(limits, among);
    assert.notEqual(governor.configFault, null);
    assert.equal(governor.govern(moving([0, 0, 0]), 10, at([0, 0, 0]), 10).mode, "hold");
  }
  for (const [limits, among] of [
    [speed, channels([], [{ name: "a" }, { ...VELOCITY, kind: "array", size: 3 }])],
    [fence, channels([{ name: "a" }, POSITION], [VELOCITY])],
    [{ ...speed, ...fence }, undefined],
    [{ max_speed_mps: 0, geofence_radius_m: -0, max_tilt_rad: NaN }, channels([], [])],
  ] as const) {
    assert.equal(governed(limits, moving([0, 0, 0]), among).mode, "active");
  }
});

test("a sensor is stale when its age is above the time-out, negative, or cannot be told", () => {
  const modeOf = (command_timeout_ms: number, nowS: number, lastS: number | null): string =>
    new SafetyGovernor({ command_timeout_ms }).govern(moving([1, 0, 0]), nowS, at([0, 0, 0]), lastS).mode;
  for (const [timeout, nowS, lastS] of [
    [500, 10, null],
    [500, 10.5000001, 10],
    [500, 9.999, 10],
    [500, NaN, 10],
    [500, Infinity, Infinity],
    [500, 10, -Infinity],
    [500, 1e308, -1e308],
    [0, 10, 10],
    [-500, 10, 10],
    [NaN, 10, 10],
    [Infinity, 10, 10],
  ] as const) {
    assert.equal(modeOf(timeout, nowS, lastS), "hold", `${timeout} ${nowS} ${lastS}`);
  }
  assert.equal(modeOf(500, 10.5, 10), "active");
  assert.equal(modeOf(500, 10, 10), "active");
});

test("a position outside the fence stops, one on it does not, and one that is missing holds", () => {
  const modeOf = (data: number[] | null, unit: string | null = null, radius = 5): string => {
    const sensor =
      data === null ? null : create("sensor_frame", { channels: { first: {}, pose_position: { data, unit } } });
    return new SafetyGovernor({ geofence_radius_m: radius }).govern(moving([0, 0, 0]), 10, sensor, 10).mode;
  };
  assert.equal(modeOf([3, 4, 0]), "active");
  assert.equal(modeOf([2, 3, 6], "m", 7), "active");
  assert.equal(modeOf([3e200, 4e200, 0], "m", 5e200), "active");
  assert.equal(modeOf([0, 3e-200, 4e-200], "m", 5e-200), "active");
  for (const data of [
    [3, 4, 0.001],
    [NaN, 0, 0],
    [0, -Infinity, 0],
    [Number.MAX_VALUE, Number.MAX_VALUE, 0],
  ]) {
    assert.equal(modeOf(data), "estop");
    assert.equal(modeOf(data, "m", Number.MAX_VALUE), data[0] === 3 ? "active" : "estop");
  }
  assert.equal(modeOf([1e-200, 0, 0], "m", Number.MIN_VALUE), "estop");
  // A norm that only rounding brings onto the fence.
  assert.equal(modeOf([Number.MIN_VALUE, Number.MIN_VALUE, 0], "m", Number.MIN_VALUE), "estop");
  for (const data of [null, [], [9], [9, 9], [9, 9, 9, 9]]) assert.equal(modeOf(data), "hold");
  assert.equal(modeOf([9, 9, 9], "km"), "hold");
});

test("the geofence and the stale sensor come before the mode, and an ESTOP before all", () => {
  const outside = at([9, 0, 0]);
  const limits = { geofence_radius_m: 1 };
  const modeOf = (mode: Mode, lastS: number): string =>
    new SafetyGovernor(limits).govern(moving([0, 0, 0], { mode }), 10, outside, lastS).mode;
  for (const mode of MODES) assert.equal(modeOf(mode, 10), "estop");
  for (const mode of MODES) assert.equal(modeOf(mode, 1), mode === "estop" ? "estop" : "hold");
});

test("a velocity above the limit is scaled to it in its direction, however large it is", () => {
  let scaled = 0;
  for (let n = 0; n < 20_000; n++) {
    const vector = Float64Array.from([0, 1, 2].slice(0, 1 + random.below(3)), () =>
      random.chance(2) ? random.double() : random.between(-10, 10),
    );
    const limit = Math.abs(random.chance(2) ? random.double() : random.between(0.1, 10)) || 1;
    const out = limited(vector, limit);
    assert.ok(norm(out) <= limit);
    const length = Math.hypot(...out);
    assert.ok(length <= limit * (1 + 1e-15) || limit < 1e-300, `${length} of ${limit}`);
    if (out === vector) continue;
    scaled++;
    if (limit < 1e-290) continue; // Subnormal components have too few digits for a direction.
    assert.ok(length >= limit * (1 - 1e-12), `${length} of ${limit}`);
    const most = Math.max(...vector.map(Math.abs));
    const now = Math.max(...out.map(Math.abs));
    vector.forEach((component, axis) => {
      assert.ok(Math.abs(component / most - out[axis]! / now) <= 1e-12, `${[...vector]} to ${[...out]}`);
    });
  }
  assert.ok(scaled > 5_000);
  assert.equal(norm(limited(Float64Array.of(1, 1, 1), Number.MIN_VALUE)), 0);
});

test("a small component beside a huge one is scaled with it and not lost", () => {
  for (const [huge, small, limit] of [
    [9e307, 1e-149, 4e286],
    [Number.MAX_VALUE, 4e-87, 9e307],
    [1e170, 1e-120, 1e-10],
    [1e-150, 1e-200, 5e-151],
  ] as const) {
    const [first, second] = limited(Float64Array.of(huge, small, 0), limit);
    assert.ok(Math.abs(first! / limit - 1) < 1e-12, `${first} of ${limit}`);
    const exact = Math.exp(Math.log(small) + Math.log(limit) - Math.log(huge));
    assert.ok(Math.abs(second! - exact) <= Math.max(1e-300, 1e-9 * exact), `${second}, not ${exact}`);
  }
});

test("the norm is exact where it can be, and overflows only when it must", () => {
  assert.equal(norm([]), 0);
  assert.equal(norm([2, 3, 6]), 7);
  for (const scale of [2 ** 1000, 2 ** -1000]) assert.equal(norm([2 * scale, 3 * scale, 6 * scale]), 7 * scale);
  assert.equal(norm([-Number.MIN_VALUE, 0]), Number.MIN_VALUE);
  assert.equal(norm([Number.MAX_VALUE, Number.MAX_VALUE]), Infinity);
  assert.equal(norm([NaN, 1]), NaN);
  for (let n = 0; n < 5_000; n++) {
    const vector = [random.double(), random.double()];
    const [ours, theirs] = [norm(vector), Math.hypot(...vector)];
    assert.ok(ours === theirs || Math.abs(ours / theirs - 1) < 1e-14, `${vector}`);
  }
});

test("the speed limit acts on every channel in metres per second, by its own unit or the negotiated one", () => {
  const among = channels([], [VELOCITY, { name: "arm", kind: "scalar", unit: "m/s" }, { name: "head", unit: "deg" }]);
  const command = moving([3, 4, 0], {
    channels: {
      a: { data: [0, 0, 0, 8], unit: "m/s" },
      arm: { data: [-8] },
      head: { data: [90] },
      other: { data: [8] },
      turned: { data: [8], unit: "rad/s" },
      velocity_setpoint: { data: [3, 4, 0] },
    },
  });
  const out = governed({ max_speed_mps: 1 }, command, among);
  const dataOf = (name: string): number[] => [...out.channels.get(name)!.data];
  assert.equal(out.mode, "active");
  assert.deepEqual(dataOf("a"), [0, 0, 0, 1]);
  assert.deepEqual(dataOf("arm"), [-1]);
  assert.deepEqual(dataOf("head"), [90]);
  assert.deepEqual(dataOf("other"), [8]);
  assert.deepEqual(dataOf("turned"), [8]);
  assert.ok(Math.abs(dataOf("velocity_setpoint")[0]! - 0.6) < 1e-12);
});

test("a channel that is declared twice has the unit of the first declaration", () => {
  const arm = { name: "arm", kind: "scalar" };
  const speed = { ...arm, unit: "m/s" };
  for (const [twice, limited] of [
    [[speed, arm], 1],
    [[speed, { ...arm, unit: "N" }], 1],
    [[arm, speed], 8],
    [[{ ...arm, unit: "N" }, speed], 8],
  ] as const) {
    const command = moving([0, 0, 0], { channels: { arm: { data: [8] }, velocity_setpoint: { data: [0, 0, 0] } } });
    const out = governed({ max_speed_mps: 1 }, command, channels([], [VELOCITY, ...twice]));
    assert.deepEqual([...out.channels.get("arm")!.data], [limited]);
  }
});

test("a command that cannot be clamped is held, and a horizon is cut before a step that cannot", () => {
  const speed = { max_speed_mps: 1 };
  const step = (data: number[], unit: string | null = "m/s"): object => ({ velocity_setpoint: { data, unit } });
  const fields = (horizon: object[], horizon_dt_ms: number | null = 10): Input<"command_frame"> => ({
    horizon: horizon as never,
    horizon_dt_ms,
  });
  const held: [Partial<SafetyLimits>, CommandFrame][] = [
    [{}, moving([0, NaN, 0])],
    [{}, moving([0], { channels: { a: { data: [1, Infinity] } } })],
    [speed, moving([], { channels: {} })],
    [speed, moving([1, 0])],
    [speed, moving([], { channels: { velocity_setpoint: { data: [1, 0, 0], unit: "km/h" } } })],
    [{ geofence_radius_m: 9 }, moving([], { channels: {} })],
    [{ geofence_radius_m: 9 }, moving([1, 0, 0, 0])],
    ...[null, NaN, 0, -1, Infinity].map((dt): [Partial<SafetyLimits>, CommandFrame] => [
      {},
      moving([0, 0, 0], fields([{}], dt)),
    ]),
  ];
  for (const [limits, command] of held) assert.equal(governed(limits, command).mode, "hold");
  assert.equal(governed({}, moving([], { channels: {} })).mode, "active");
  assert.equal(governed({}, moving([0, 0, 0], { horizon_dt_ms: NaN })).mode, "active");

  const lengthOf = (limits: Partial<SafetyLimits>, bad: object): number => {
    const good = step([0, 0, 0]);
    return governed(limits, moving([0, 0, 0], fields([good, good, bad, good]))).horizon.length;
  };
  for (const bad of [{}, step([0, 0]), step([0, 0, 0], "km/h"), step([0, 0, NaN]), { a: { data: [NaN] } }]) {
    assert.equal(lengthOf(speed, bad), 2);
    assert.equal(lengthOf({ geofence_radius_m: 9 }, bad), 2);
  }
  assert.equal(lengthOf({}, {}), 4);
  assert.equal(lengthOf({}, step([0, -Infinity, 0])), 2);
});

test("a HOLD frame keeps the head of the command and zeroes its channels and the negotiated ones", () => {
  const among = channels([], [VELOCITY, { name: "arm", unit: "rad" }, { name: "light" }]);
  const command = create("command_frame", {
    seq: 7,
    t: 1.5,
    frame_id: "map",
    ttl_ms: NaN,
    mode: "init",
    channels: { light: { data: [1, 2], unit: "lx" }, own: { data: [3] } },
    horizon: [{}],
    horizon_dt_ms: 5,
  });
  assert.deepEqual(
    governed({}, command, among),
    create("command_frame", {
      seq: 7,
      t: 1.5,
      frame_id: "map",
      ttl_ms: NaN,
      mode: "hold",
      channels: {
        light: { data: [0, 0], unit: "lx" },
        own: { data: [0] },
        velocity_setpoint: { data: [0, 0, 0], unit: "m/s" },
        arm: { data: [0] },
      },
    }),
  );
  assert.deepEqual([...governed({}, create("command_frame", { mode: "hold" })).channels.keys()], ["velocity_setpoint"]);
});
