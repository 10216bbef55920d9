import assert from "node:assert/strict";
import { test } from "node:test";
import {
  type Backend,
  checkReply,
  create,
  decode,
  decodeAny,
  encode,
  type Input,
  NCP_CONTRACT_HASH,
  NCP_VERSION,
  type Observation,
  type ObservationFrame,
  ReferenceBackend,
  SessionClient,
  type SessionOpened,
  SessionService,
} from "@ncp-conformance/peer";
import { Random, refuses } from "./support.js";

const random = new Random(4);
const LIF = "ncp.reference.lif";
const RATE = "ncp.reference.rate";

type Open = Input<"open_session">;

/** A server and one client's view of it. */
class Bench {
  readonly service = new SessionService(new ReferenceBackend());

  ask(
    kind: "step_request" | "run_request" | "close_session" | "open_session",
    fields: object,
  ): ReturnType<typeof decodeAny> {
    const request = create(kind, { session_id: "s", ...fields } as never);
    return checkReply(request as never, this.service.handle(encode(request))) as never;
  }

  open(ref: string, fields: Partial<Open> = {}, params: Record<string, number> = {}, size = 1): SessionOpened {
    return this.ask("open_session", {
      network: { ref, population_sizes: { pop: size }, params },
      ...fields,
    }) as SessionOpened;
  }

  step(fields: Partial<Input<"step_request">> = {}): ObservationFrame {
    return this.ask("step_request", fields) as ObservationFrame;
  }

  run(duration_ms: number, stimulus?: Record<string, number>): ObservationFrame {
    return this.ask("run_request", {
      duration_ms,
      ...(stimulus && { stimulus: driving(stimulus) }),
    }) as ObservationFrame;
  }
}

function driving(ports: Record<string, number>): Input<"stimulus_frame"> {
  const values = Object.entries(ports).map(([port, value]) => [port, { data: [value] }]);
  return { session_id: "s", values: Object.fromEntries(values) as never };
}

function recording(observable: string, fields: object = {}): Partial<Open> {
  return { record: { targets: [{ port: observable, target: "pop", observable, ...fields }] } };
}

function assertClose(found: number, expected: number): void {
  assert.ok(Math.abs(found - expected) <= 1e-9 * Math.max(1, Math.abs(expected)), `${found} instead of ${expected}`);
}

function recorded(frame: ObservationFrame, port: string): Observation {
  const observation = frame.records.get(port);
  assert.ok(observation !== undefined);
  return observation;
}

// --- the networks --------------------------------------------------------------------------------

test("the LIF network follows its closed solution, between spikes and through them", () => {
  let spiked = 0;
  for (let n = 0; n < 150; n++) {
    const dt_ms = random.pick([0.1, 0.25, 0.5, 1]);
    const p = {
      C_m: random.between(100, 400),
      tau_m: random.between(5, 30),
      E_L: random.between(-75, -65),
      V_th: random.between(-58, -50),
      V_reset: random.between(-80, -66),
      t_ref: dt_ms * random.below(12),
      I_e: random.between(-200, 900),
    };
    const bench = new Bench();
    bench.open(
      LIF,
      {
        sim: { dt_ms },
        record: {
          targets: [
            { port: "V_m", target: "pop", observable: "V_m", cadence_ms: dt_ms },
            { port: "spikes", target: "pop", observable: "spikes" },
          ],
        },
      },
      p,
    );
    const steps = 400;
    const frame = bench.run(steps * dt_ms);

    // V(t) = V∞ + (V₀ − V∞)·exp(−t / tau) since the last reset; the crossing is solved for, not stepped to.
    const end = p.E_L + (p.I_e * p.tau_m) / p.C_m;
    const crossing = (from: number): number =>
      end > p.V_th
        ? Math.max(1, Math.ceil((p.tau_m / dt_ms) * Math.log((end - from) / (end - p.V_th)) - 1e-9))
        : Infinity;
    const spikes: number[] = [];
    const trace: number[] = [];
    let begin = 0;
    let from = p.E_L;
    let spike = crossing(from);
    for (let step = 1; step <= steps; step++) {
      if (step === spike) {
        spikes.push(step * dt_ms);
        begin = step + Math.round(p.t_ref / dt_ms);
        from = p.V_reset;
        spike = begin + crossing(from);
      }
      trace.push(step <= begin ? p.V_reset : end + (from - end) * Math.exp(-((step - begin) * dt_ms) / p.tau_m));
    }
    const { times, values, senders } = recorded(frame, "V_m");
    assert.equal(values.length, steps);
    trace.forEach((value, k) => {
      assertClose(values[k]!, value);
      assertClose(times[k]!, (k + 1) * dt_ms);
      assert.equal(senders[k], 1);
    });
    const found = recorded(frame, "spikes");
    assert.equal(found.values.length, 0);
    assert.equal(found.times.length, spikes.length);
    spikes.forEach((time, k) => assertClose(found.times[k]!, time));
    spiked += spikes.length;
  }
  assert.ok(spiked > 500, `${spiked} spikes`);
});

test("the rate network follows its closed solution under a changing input", () => {
  const bench = new Bench();
  bench.open(RATE, {
    ...recording("rate", { cadence_ms: 5 }),
    stimulus: { targets: [{ port: "in", target: "pop", kind: "rate_inject" }] },
    sim: { dt_ms: 0.5 },
  });
  let r = 0;
  for (let n = 0; n < 50; n++) {
    const x = random.between(-50, 50);
    const { values, unit } = recorded(bench.run(5, { in: x }), "rate");
    r = x + (r - x) * Math.exp(-5 / 10);
    assert.equal(values.length, 1);
    assertClose(values[0]!, r);
    assert.equal(unit, "Hz");
  }
});

test("a stimulus acts from the first step of its request, stays, and drives the neurons it names", () => {
  const bench = new Bench();
  bench.open(
    LIF,
    {
      ...recording("V_m", { cadence_ms: 1 }),
      stimulus: {
        targets: [
          { port: "one", target: "pop", ids: [2] },
          { port: "all", target: "pop" },
        ],
      },
      sim: { dt_ms: 1 },
    },
    {},
    3,
  );
  const drift = (10 / 250) * (1 - Math.exp(-0.1));
  const decay = Math.exp(-0.1);
  const v = [0, 0, 0];
  const expectAfter = (currents: number[], frame: ObservationFrame): void => {
    currents.forEach((current, k) => (v[k] = v[k]! * decay + current * drift));
    const { values, senders } = recorded(frame, "V_m");
    assert.deepEqual([...senders], [1, 2, 3]);
    v.forEach((value, k) => assertClose(values[k]!, -70 + value));
  };
  expectAfter([0, 0, 0], bench.run(1));
  expectAfter([0, 100, 0], bench.run(1, { one: 100 }));
  expectAfter([0, 100, 0], bench.run(1));
  expectAfter([7, 107, 7], bench.run(1, { all: 7 }));
  expectAfter([7, -13, 7], bench.run(1, { one: -20 }));
  expectAfter([0, 0, 0], bench.run(1, { one: 0, all: 0 }));
});

test("a port is sampled at every multiple of its cadence, across requests, and that is a number of steps", () => {
  const timesOf = (cadence_ms: number, dt_ms: number, requests: number[]): number[] => {
    const bench = new Bench();
    bench.open(RATE, { ...recording("rate", { cadence_ms }), sim: { dt_ms } });
    return requests.flatMap((ms) => [...recorded(bench.run(ms), "rate").times]);
  };
  const close = (found: number[], expected: number[]): void => {
    assert.equal(found.length, expected.length, `${found} instead of ${expected}`);
    expected.forEach((time, k) => assertClose(found[k]!, time));
  };
  close(timesOf(1, 0.1, [3]), [1, 2, 3]);
  close(timesOf(1, 0.1, [0.5, 0.5, 0.9, 0.1, 1]), [1, 2, 3]);
  close(timesOf(0.3, 0.1, [1]), [0.3, 0.6, 0.9]);
  // [NCP-SESS-053] A cadence between the steps is the nearest of them, the later of two, and one step at least.
  close(timesOf(0.24, 0.1, [1]), [0.2, 0.4, 0.6, 0.8, 1]);
  close(timesOf(0.25, 0.1, [1]), [0.3, 0.6, 0.9]);
  close(timesOf(0.34, 0.1, [0.7, 0.7]), [0.3, 0.6, 0.9, 1.2]);
  close(timesOf(0.1, 0.5, [1]), [0.5, 1]);
  assert.equal(
    timesOf(
      0.1,
      0.1,
      Array.from({ length: 300 }, () => 0.1),
    ).length,
    300,
  );
});

// [NCP-SESS-058]
test("a request runs the nearest number of steps, and leaves nothing to the next", () => {
  // 0.15 / 0.1 is below one and a half as a double, 0.25 / 0.1 two and a half.
  const table: [number, number][] = [
    [0.04, 0],
    [0.05, 1],
    [0.14, 1],
    [0.15, 1],
    [0.16, 2],
    [0.25, 3],
    [0.3, 3],
    [0.34, 3],
    [0.45, 5],
  ];
  for (const [chunk_ms, steps] of table) {
    const bench = new Bench();
    bench.open(RATE, { ...recording("rate", { cadence_ms: 0.1 }), sim: { dt_ms: 0.1, chunk_ms } });
    for (let n = 1; n <= 400; n++) {
      const frame = bench.step(n % 2 === 0 ? {} : { advance_ms: chunk_ms });
      assert.equal(frame.seq, n);
      assertClose(frame.sim_time_ms, n * steps * 0.1);
      assert.equal(recorded(frame, "rate").times.length, steps);
    }
    assertClose(bench.step({ advance_ms: 7 }).sim_time_ms, 40 * steps + 7);
    assertClose(bench.step({ advance_ms: 0 }).sim_time_ms, 40 * steps + 7);
  }
});

// [NCP-SESS-059]
test("samples come by time, and those of one time as the ids are named", () => {
  const bench = new Bench();
  const target = { target: "pop", observable: "rate", cadence_ms: 1 };
  const targets = [
    { ...target, port: "all" },
    { ...target, port: "named", ids: Float64Array.of(3, 1) },
  ];
  bench.open(RATE, { record: { targets } }, {}, 3);
  const frame = bench.run(2);
  assert.deepEqual([...recorded(frame, "all").senders], [1, 2, 3, 1, 2, 3]);
  assert.deepEqual([...recorded(frame, "named").senders], [3, 1, 3, 1]);
  assert.deepEqual([...recorded(frame, "named").times], [1, 1, 2, 2]);
});

test("many short requests lose no time to rounding", () => {
  const simulation = new ReferenceBackend().open(create("open_session", { session_id: "s", network: { ref: RATE } }));
  for (let n = 0; n < 300_000; n++) simulation.advance(0.1, new Map());
  assert.ok(Math.abs(simulation.timeMs - 30_000) < 1e-10, String(simulation.timeMs));
});

test("what a network cannot do is refused when the session is opened, and opens nothing", () => {
  const target = { port: "a", target: "pop" };
  const refused: Partial<Open>[] = [
    { network: { ref: "ncp.reference.other" } },
    { network: { ref: LIF, kind: "model_id" } },
    { network: { ref: LIF, population_sizes: { pop: -1 } } },
    { network: { ref: LIF, population_sizes: { pop: 2 ** 50 } } },
    ...[{ C_m: 0 }, { tau_m: -1 }, { t_ref: -1 }, { tau: 1 }].map((params) => ({
      network: { ref: LIF, population_sizes: { pop: 1 }, params },
    })),
    { sim: { dt_ms: 0 } },
    { sim: { chunk_ms: -1 } },
    { record: { targets: [{ ...target, target: "nobody" }] } },
    { record: { targets: [target, target] } },
    { record: { targets: [{ ...target, observable: "weight" }] } },
    { record: { targets: [{ ...target, recordables: ["g_ex"] }] } },
    { record: { targets: [{ ...target, cadence_ms: 0 }] } },
    { record: { targets: [{ ...target, ids: [2] }] } },
    { record: { targets: [{ ...target, ids: [0] }] } },
    { stimulus: { targets: [{ ...target, kind: "rate_hz" }] } },
    { stimulus: { targets: [target, target] } },
  ];
  const bench = new Bench();
  for (const fields of refused) {
    refuses("reply", () => bench.open(LIF, fields));
    refuses("reply", () => bench.step());
  }
  bench.open(LIF);
});

test("a request that fails costs that request only", () => {
  const bench = new Bench();
  bench.open(LIF, { ...recording("V_m"), stimulus: { targets: [{ port: "in", target: "pop" }] } });
  bench.run(5, { in: 100 });
  const before = new Bench();
  before.open(LIF, { ...recording("V_m"), stimulus: { targets: [{ port: "in", target: "pop" }] } });
  before.run(5, { in: 100 });
  for (const fields of [
    { advance_ms: -1 },
    { advance_ms: 1e300 },
    { advance_ms: 1e7 },
    { stimulus: driving({ other: 1 }) },
    { stimulus: { session_id: "s", values: { in: { data: [] } } } },
    { stimulus: { session_id: "s", values: { in: { data: [5, 5] } } } },
    { stimulus: { session_id: "s", values: { in: { data: [5], unit: "nA" } } } },
    { advance_ms: -1, stimulus: driving({ in: 9 }) },
  ]) {
    refuses("reply", () => bench.step(fields));
  }
  assert.deepEqual({ ...bench.step(), t: 0 }, { ...before.step(), t: 0 });
});

// --- the service ---------------------------------------------------------------------------------

test("as many samples as a server bears are counted by the cadence since the session opened", () => {
  const bench = new Bench();
  const targets = Array.from({ length: 12 }, (_, nth) => ({ port: `p${nth}`, target: "pop", observable: "V_m" }));
  const slow = targets.map((target) => ({ ...target, cadence_ms: 10 }));
  bench.open(LIF, { record: { targets: slow }, sim: { dt_ms: 1 } } as Partial<Open>, {}, 100_000);
  assert.equal(bench.run(9).sim_time_ms, 9);
  // Each of the twelve has a sample of each neuron in the next step.
  assert.throws(() => bench.run(1), /samples/);
  const spiking = targets.map((target) => ({ ...target, observable: "spikes" }));
  const other = new Bench();
  other.open(LIF, { record: { targets: spiking }, sim: { dt_ms: 1 } } as Partial<Open>, {}, 100_000);
  assert.equal(other.run(0).sim_time_ms, 0);
});

test("every request has one reply, whatever its bytes", () => {
  const bench = new Bench();
  const ids = ["a", "b", "c"];
  const open = new Set<string>();
  const kinds = new Map<string, number>();
  for (let n = 0; n < 4_000; n++) {
    const session_id = random.pick(ids);
    const request = random.pick([
      create("open_session", {
        session_id,
        network: { ref: random.pick([LIF, RATE, "x"]), population_sizes: { pop: random.below(4) } },
        ncp_version: random.pick([NCP_VERSION, NCP_VERSION, "0.4", "x"]),
        ...recording(random.pick(["V_m", "rate", "spikes"])),
      }),
      create("step_request", { session_id, advance_ms: random.pick([null, 1, 0.1, -1, 1e300]) }),
      create("run_request", { session_id, duration_ms: random.between(-1, 10) }),
      create("close_session", { session_id }),
      create("sensor_frame", {}),
    ]);
    const frame = Buffer.from(encode(request));
    const broken = random.chance(4);
    if (broken) frame[random.below(frame.length)] = random.below(256);
    const reply = decodeAny(bench.service.handle(frame));
    kinds.set(reply.kind, (kinds.get(reply.kind) ?? 0) + 1);
    assert.ok(["session_opened", "observation_frame", "session_closed", "error"].includes(reply.kind));
    if (broken) {
      // It may have become another request, so that what is open is asked for.
      for (const id of ids) {
        const probe = bench.service.handle(encode(create("step_request", { session_id: id, advance_ms: 0 })));
        if (decodeAny(probe).kind === "observation_frame") open.add(id);
        else open.delete(id);
      }
    } else if (request.kind === "open_session") {
      assert.ok(reply.kind === "session_opened" && reply.session_id === session_id);
      const fits = request.ncp_version === NCP_VERSION && !open.has(session_id);
      assert.ok(fits || !reply.ok);
      assert.equal(reply.ok, reply.error === null);
      assert.equal(reply.ok, reply.provenance !== null);
      if (reply.ok) open.add(session_id);
    } else if (request.kind === "close_session") {
      assert.ok(reply.kind === "session_closed");
      assert.equal(reply.ok, open.delete(session_id));
    } else if (!open.has(session_id) || request.kind === "sensor_frame") {
      assert.equal(reply.kind, "error");
    }
  }
  for (const times of kinds.values()) assert.ok(times > 50, JSON.stringify([...kinds]));
  assert.equal(kinds.size, 4);
});

test("bytes of any sort are answered with an error frame", () => {
  const { service } = new Bench();
  const frames: (string | Uint8Array)[] = [
    "",
    "null",
    "[]",
    "{",
    '{"kind":"nothing"}',
    '{"kind":"error","error":"x"}',
    '{"kind":"open_session"}',
    '{"kind":"close_session","session_id":"a b"}',
    `{"kind":"step_request","session_id":"s","x":${"[".repeat(99)}${"]".repeat(99)}}`,
    `{"kind":"\ud800"}`,
    `{"kind":"${"x".repeat(2_000_000)}"}`,
    Uint8Array.of(0x7b, 0xff),
  ];
  for (let n = 0; n < 2_000; n++) frames.push(Uint8Array.from({ length: random.below(20) }, () => random.below(256)));
  for (const frame of frames) {
    const reply = decode("error", service.handle(frame));
    assert.notEqual(reply.error, "");
    assert.equal(reply.session_id, null);
  }
});

test("sessions are kept apart, and an open one is left as it is by another open", () => {
  const { service } = new Bench();
  const ask = (request: ReturnType<typeof create>): ReturnType<typeof decodeAny> =>
    decodeAny(service.handle(encode(request)));
  const open = (session_id: string, chunk_ms: number): ReturnType<typeof decodeAny> =>
    ask(create("open_session", { session_id, network: { ref: RATE }, sim: { chunk_ms } }));
  const timeOf = (session_id: string): number =>
    (ask(create("step_request", { session_id })) as ObservationFrame).sim_time_ms;
  assert.ok((open("a", 1) as SessionOpened).ok);
  assert.ok((open("b", 10) as SessionOpened).ok);
  assert.deepEqual([timeOf("a"), timeOf("b"), timeOf("a")], [1, 10, 2]);
  assert.equal((open("a", 100) as SessionOpened).ok, false);
  assert.equal(timeOf("a"), 3);
  assert.equal(ask(create("close_session", { session_id: "a" })).kind, "session_closed");
  assert.equal(ask(create("step_request", { session_id: "a" })).kind, "error");
  assert.equal(timeOf("b"), 20);
  assert.ok((open("a", 100) as SessionOpened).ok);
  assert.equal(timeOf("a"), 100);
});

test("a contract hash of another schema does not keep a session from being opened", () => {
  const bench = new Bench();
  for (const [session_id, contract_hash] of [
    ["a", "0000000000000000"],
    ["b", null],
  ] as const) {
    const opened = bench.ask("open_session", { session_id, network: { ref: RATE }, contract_hash }) as SessionOpened;
    assert.equal(opened.contract_hash, NCP_CONTRACT_HASH);
  }
});

test("a backend that crashes costs the request only, and its reason can always be sent", () => {
  let crashes = true;
  const crash = (): never => {
    throw new Error(`\ud800${"x".repeat(3_000_000)}`);
  };
  const backend: Backend = {
    name: "crashing",
    open: () => (crashes ? crash() : { resolved: new Map(), provenance: {}, timeMs: 0, advance: crash }),
  };
  const service = new SessionService(backend);
  const open = encode(create("open_session", { session_id: "s", network: {} }));
  assert.equal(decode("session_opened", service.handle(open)).ok, false);
  crashes = false;
  assert.equal(decode("session_opened", service.handle(open)).ok, true);
  const step = encode(create("step_request", { session_id: "s" }));
  for (let n = 0; n < 2; n++) assert.equal(decode("error", service.handle(step)).session_id, "s");
});

test("a reply that would be no frame is answered with an error frame", () => {
  const service = new SessionService({
    name: "loud",
    open: () => ({ resolved: new Map(), provenance: {}, timeMs: NaN, advance: () => new Map() }),
  });
  service.handle(encode(create("open_session", { session_id: "s", network: {} })));
  decode("error", service.handle(encode(create("step_request", { session_id: "s" }))));
});

// --- the client ----------------------------------------------------------------------------------

test("a client closes the sessions that it opened, and leaves the others to their owner", async () => {
  const { service } = new Bench();
  const send = (request: string): Promise<string> => Promise.resolve(service.handle(request));
  const owner = new SessionClient(send);
  const guest = new SessionClient(send);
  await owner.open({ session_id: "s", network: { ref: RATE } });
  await assert.rejects(guest.open({ session_id: "s", network: { ref: RATE } }));
  assert.equal((await guest.run({ session_id: "s", duration_ms: 5 })).sim_time_ms, 5);
  assert.equal(await guest.close("s"), false);
  assert.equal((await owner.step({ session_id: "s" })).sim_time_ms, 15);
  assert.equal(await owner.close("s"), true);
  await assert.rejects(owner.step({ session_id: "s" }));
  assert.equal(await owner.close("s"), false);
});
