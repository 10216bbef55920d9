import assert from "node:assert/strict";
import { test } from "node:test";
import {
  ControlLoop,
  create,
  LinkMonitor,
  ReflexController,
  SafetyGovernor,
  type CommandFrame,
  type Controller,
  type ControlStatus,
  type SafetyLimits,
  type SensorFrame,
} from "@ncp-conformance/peer";
import { at, moving, Random, refuses } from "./support.js";

const random = new Random(10);

// --- the reflex controller -----------------------------------------------------------------------

function sensing(position: readonly number[], velocity?: readonly number[]): SensorFrame {
  const channels = { pose_position: { data: position }, ...(velocity && { pose_velocity: { data: velocity } }) };
  return create("sensor_frame", { seq: 4, frame_id: "map", channels });
}

test("the reflex controller is proportional with damping, and clamped on each axis", () => {
  for (let n = 0; n < 2_000; n++) {
    const target = random.vector(3);
    const [kp, kd, max_speed] = [random.between(0, 2), random.between(0, 2), random.between(0, 4)];
    const position = random.vector(3);
    const velocity = random.vector(3);
    const command = new ReflexController({ target, kp, kd, max_speed }).step(sensing(position, velocity));
    assert.equal(command.mode, "active");
    assert.equal(command.seq, 4);
    assert.equal(command.frame_id, "map");
    const { data, unit } = command.channels.get("velocity_setpoint")!;
    assert.equal(unit, "m/s");
    data.forEach((component, axis) => {
      const wanted = -kp * (position[axis]! - target[axis]!) - kd * velocity[axis]!;
      const clamped = Math.abs(wanted) <= max_speed ? wanted : Math.sign(wanted) * max_speed;
      assert.ok(Math.abs(component - clamped) < 1e-12);
    });
  }
});

test("a plant that the reflex controller flies arrives", () => {
  const controller = new ReflexController({ target: [1, -2, 3] });
  let position = [4, 4, -4];
  let velocity = [0, 0, 0];
  for (let tick = 0; tick < 1_000; tick++) {
    velocity = [...controller.step(sensing(position, velocity)).channels.get("velocity_setpoint")!.data];
    position = position.map((x, axis) => x + velocity[axis]! * 0.05);
  }
  assert.ok(Math.hypot(position[0]! - 1, position[1]! + 2, position[2]! - 3) < 1e-6);
});

test("without a usable position the reflex controller holds, and without a usable velocity it damps nothing", () => {
  const controller = new ReflexController();
  for (const sensor of [null, sensing([]), sensing([1, 2]), sensing([1, 2, NaN]), sensing([1, 2, 3, 4])]) {
    const { mode, channels } = controller.step(sensor);
    assert.equal(mode, "hold");
    assert.deepEqual(channels.get("velocity_setpoint"), { data: new Float64Array(3), unit: "m/s" });
  }
  const dataFor = (velocity?: number[]): number[] => [
    ...controller.step(sensing([1, 0, 0], velocity)).channels.get("velocity_setpoint")!.data,
  ];
  for (const velocity of [undefined, [], [1, 1], [1, NaN, 1]]) assert.deepEqual(dataFor(velocity), [-1, 0, 0]);
  assert.deepEqual(dataFor([1, 0, 0]), [-1.3, 0, 0]);
});

test("positions at the end of the doubles neither crash the reflex controller nor come through it", () => {
  const most = Number.MAX_VALUE;
  for (let n = 0; n < 2_000; n++) {
    const wild = (): number => random.pick([most, -most, 0, 1]);
    const config = { kp: random.pick([0, 1, most]), kd: random.pick([0, 1, most]), target: [wild(), wild(), wild()] };
    const command = new ReflexController(config).step(sensing([wild(), wild(), wild()], [wild(), wild(), wild()]));
    for (const component of command.channels.get("velocity_setpoint")!.data) assert.ok(Math.abs(component) <= 1.5);
  }
});

test("a reflex controller is not built with a gain, a speed or a target that is none", () => {
  for (const bad of [NaN, Infinity, -1]) {
    refuses("value", () => new ReflexController({ kp: bad }));
    refuses("value", () => new ReflexController({ kd: bad }));
    refuses("value", () => new ReflexController({ max_speed: bad }));
  }
  for (const target of [
    [NaN, 0, 0],
    [0, 0],
    [0, 0, 0, 0],
    [0, Infinity, 0],
  ]) {
    refuses("value", () => new ReflexController({ target }));
  }
});

// --- the control loop ----------------------------------------------------------------------------

/** A loop whose clock the test sets and whose output the test keeps. */
class Bench {
  nowS = 0;
  readonly commands: CommandFrame[] = [];
  readonly statuses: ControlStatus[] = [];
  readonly governor: SafetyGovernor;
  readonly loop: ControlLoop;
  /** How long a step of the controller takes, s. */
  stepS = 0;

  constructor(limits: Partial<SafetyLimits> = {}, periodMs = 50, controller: Controller = new ReflexController()) {
    this.governor = new SafetyGovernor(limits);
    this.loop = new ControlLoop({
      periodMs,
      controller: {
        step: (sensor) => {
          this.nowS += this.stepS;
          return controller.step(sensor);
        },
      },
      governor: this.governor,
      monitor: new LinkMonitor(),
      clock: () => this.nowS,
      send: (command) => this.commands.push(command),
      publish: (status) => this.statuses.push(status),
    });
  }

  sensor(nowS: number, frame: SensorFrame): void {
    this.nowS = nowS;
    this.loop.onSensor(frame);
  }

  tick(nowS: number): [CommandFrame, ControlStatus] {
    this.nowS = nowS;
    this.loop.tick();
    assert.equal(this.commands.length, this.statuses.length);
    return [this.commands.at(-1)!, this.statuses.at(-1)!];
  }
}

test("a loop does not start without a finite, positive period", () => {
  for (const period of [0, -1, NaN, Infinity]) refuses("value", () => new Bench({}, period));
});

test("a tick answers the newest sensor frame by seq, and sends one command and one status", () => {
  const bench = new Bench();
  bench.sensor(1, at([1, 0, 0], { seq: 7, t: 50 }));
  bench.sensor(1.1, at([9, 9, 9], { seq: 6, t: 60 }));
  const [command, status] = bench.tick(1.2);
  assert.equal(command.seq, 7);
  assert.equal(command.t, 1.2);
  assert.equal(command.mode, "active");
  assert.deepEqual([...command.channels.get("velocity_setpoint")!.data], [-1, 0, 0]);
  assert.deepEqual(status, create("control_status", { seq: 1, t: 1.2, mode: "active" }));
  assert.equal(bench.tick(1.25)[1].seq, 2);
});

test("the command has the seq of the sensor frame, whatever its controller says", () => {
  const bench = new Bench({}, 50, { step: () => moving([1, 0, 0], { seq: 99, t: 99 }) });
  assert.deepEqual([bench.tick(1)[0].seq, bench.tick(1)[0].t], [0, 1]);
  bench.sensor(1, at([1, 0, 0], { seq: 7 }));
  assert.equal(bench.tick(1)[0].seq, 7);
});

test("a sensor frame that is not newer does not renew the sensor's time", () => {
  const bench = new Bench({ command_timeout_ms: 500 });
  bench.sensor(1, at([1, 0, 0], { seq: 7 }));
  for (let k = 1; k <= 6; k++) bench.sensor(1 + k / 10, at([1, 0, 0], { seq: random.pick([7, 6, 0]), t: k }));
  assert.equal(bench.tick(1.5)[0].mode, "active");
  const [command, status] = bench.tick(1.625);
  assert.equal(command.mode, "hold");
  assert.equal(command.seq, 7);
  assert.equal(status.safety_ok, false);
  bench.sensor(1.6, at([1, 0, 0], { seq: 8 }));
  assert.equal(bench.tick(1.625)[0].mode, "active");
});

test("while frames are not stamped, the newest by t is kept", () => {
  const bench = new Bench();
  bench.sensor(1, at([1, 0, 0], { seq: 0, t: NaN }));
  assert.equal(bench.tick(1)[0].mode, "hold");
  bench.sensor(1, at([1, 0, 0], { seq: 0, t: 5 }));
  bench.sensor(1, at([2, 0, 0], { seq: 0, t: 4 }));
  assert.equal(bench.tick(1)[0].channels.get("velocity_setpoint")!.data[0], -1);
  bench.sensor(1, at([0.5, 0, 0], { seq: 0, t: 6 }));
  assert.equal(bench.tick(1)[0].channels.get("velocity_setpoint")!.data[0], -0.5);
});

test("the ttl is raised to two periods before the command is governed", () => {
  const fly = { step: (): CommandFrame => moving([1, 0, 0], { ttl_ms: 10 }) };
  const bench = new Bench({ geofence_radius_m: 1 }, 400, fly);
  bench.sensor(1, at([0, 0, 0]));
  assert.equal(bench.tick(1)[0].ttl_ms, 800);
  assert.equal(bench.commands[0]!.mode, "active");
  // 10 ms would stay within the fence, 800 ms do not.
  bench.sensor(1, at([0.5, 0, 0], { seq: 2 }));
  assert.equal(bench.tick(1)[0].mode, "hold");
  const long = new Bench({}, 50, { step: () => moving([1, 0, 0], { ttl_ms: 300 }) });
  assert.equal(long.tick(1)[0].ttl_ms, 300);
  const none = new Bench({}, 50, { step: () => moving([1, 0, 0], { ttl_ms: NaN }) });
  assert.equal(none.tick(1)[0].ttl_ms, 100);
});

test("a burst that no tick sampled stops the plant until a reset", () => {
  const bench = new Bench();
  bench.sensor(1, at([1, 0, 0], { seq: 1 }));
  assert.equal(bench.tick(1)[0].mode, "active");
  bench.sensor(1, at([1, 0, 0], { seq: 20 }));
  const [command, status] = bench.tick(1);
  assert.equal(command.mode, "estop");
  assert.deepEqual([status.mode, status.safety_ok], ["estop", false]);
  // Once the link is healthy again, a reset leads back.
  for (let seq = 21; seq < 140; seq++) bench.sensor(1, at([1, 0, 0], { seq }));
  assert.equal(bench.tick(1)[0].mode, "estop");
  bench.loop.reset();
  assert.equal(bench.tick(1)[0].mode, "active");
});

test("a fast sensor is no loss to a slow loop", () => {
  const bench = new Bench();
  let seq = 0;
  for (let tick = 0; tick < 50; tick++) {
    for (let k = 0; k < 40; k++) bench.sensor(tick, at([0, 0, 0], { seq: ++seq }));
    assert.equal(bench.tick(tick)[0].mode, "active");
  }
});

test("the status tells the measured latency, and notes a tick that overran", () => {
  const bench = new Bench();
  bench.stepS = 0.025;
  const [, short] = bench.tick(2);
  assert.ok(Math.abs(short.loop_latency_ms - 25) < 1e-9);
  assert.equal(short.note, null);
  assert.equal(short.safety_ok, true, "a controller's own HOLD is no matter of the governor");
  bench.stepS = 0.075;
  const [, long] = bench.tick(3);
  assert.ok(Math.abs(long.loop_latency_ms - 75) < 1e-9);
  assert.match(long.note!, /75\.0 ms/);
});

test("whatever a controller wants, the loop sends nothing that a governor would not pass", () => {
  for (let n = 0; n < 500; n++) {
    const wish = (): number => (random.chance(20) ? NaN : random.chance(5) ? random.double() : random.between(-5, 5));
    const wild: Controller = {
      step: () =>
        moving([wish(), wish(), wish()], {
          mode: random.pick(["active", "active", "active", "hold", "init"]),
          ttl_ms: wish() * 100,
        }),
    };
    const limits = { geofence_radius_m: 2, max_speed_mps: 1.5 };
    const bench = new Bench(limits, 50, wild);
    let position = [0, 0, 0];
    for (let tick = 0; tick < 20; tick++) {
      const nowS = tick * 0.05;
      bench.sensor(nowS, at(position, { seq: tick + 1 }));
      const [command] = bench.tick(nowS);
      assert.notEqual(command.mode, "estop");
      const velocity = [...command.channels.get("velocity_setpoint")!.data];
      assert.ok(Math.hypot(...velocity) <= 1.5 * (1 + 1e-12));
      position = position.map((x, axis) => x + velocity[axis]! * 0.05);
      assert.ok(Math.hypot(...position) <= 2 * (1 + 1e-12));
    }
  }
});
