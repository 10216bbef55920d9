import assert from "node:assert/strict";
import { test } from "node:test";
import {
  ActionBuffer,
  CommandWatchdog,
  encode,
  enforcedTtlMs,
  LinkMonitor,
  maxHorizonLen,
  type Mode,
} from "@ncp-conformance/peer";
import { moving, Random } from "./support.js";

const random = new Random(8);
const MODES: readonly Mode[] = ["init", "active", "hold", "estop"];

// --- the watchdog --------------------------------------------------------------------------------

test("a plant actuates only by the liveness rule, and a hold persists until a command advances", () => {
  const seen = { live: 0, expired: 0, persisted: 0 };
  for (let n = 0; n < 3_000; n++) {
    const watchdog = new CommandWatchdog();
    // The rule, told from the history: the last command that advanced, and the clock readings since.
    let last: { seq: number; receivedS: number; ttlMs: number } | undefined;
    let readings: number[] = [];
    let nowS = random.between(0, 4);
    for (let step = 0; step < 30; step++) {
      nowS = random.chance(30) ? random.pick([NaN, Infinity, -Infinity]) : (nowS || 1) + random.between(-0.05, 0.2);
      if (random.chance(100)) {
        watchdog.reset();
        last = undefined;
      } else if (random.chance(3)) {
        const seq = random.chance(4) ? random.below(20) : (last?.seq ?? -1) + 1 + random.below(2);
        const ttlMs = random.pick([200, 200, 200, 100, 1e9, 0, -1, NaN, Infinity]);
        const advances = last === undefined || seq > last.seq;
        assert.equal(watchdog.onCommand(nowS, ttlMs, seq), advances);
        if (advances) {
          last = { seq, receivedS: nowS, ttlMs };
          readings = [];
        }
      } else {
        readings.push(nowS);
        const mayAct = (now: number): boolean =>
          last !== undefined &&
          Number.isFinite(now) &&
          Number.isFinite(last.receivedS) &&
          Number.isFinite(last.ttlMs) &&
          last.receivedS <= now &&
          now - last.receivedS <= Math.min(last.ttlMs, 60_000) / 1000;
        const hold = watchdog.shouldHold(nowS);
        assert.equal(hold, !readings.every(mayAct), `${nowS} after ${JSON.stringify(last)}`);
        seen.live += Number(!hold);
        seen.expired += Number(!mayAct(nowS));
        seen.persisted += Number(hold && mayAct(nowS));
      }
    }
  }
  for (const [what, times] of Object.entries(seen)) assert.ok(times > 500, `${what}: only ${times}`);
});

test("the deadline is exact, and at most one minute", () => {
  for (const [ttlMs, liveS, heldS] of [
    [250, 64.25, 64.250001],
    [60_000, 124, 124.001],
    [60_000.1, 124, 124.001],
    [1e300, 124, 124.001],
  ] as const) {
    const watchdog = new CommandWatchdog();
    watchdog.onCommand(64, ttlMs, 1);
    assert.equal(watchdog.shouldHold(64), false);
    assert.equal(watchdog.shouldHold(liveS), false);
    assert.equal(watchdog.shouldHold(heldS), true);
    assert.equal(watchdog.shouldHold(64), true);
  }
  // Whole milliseconds on a clock that began at 0.
  for (let ms = 1; ms <= 60_000; ms++) {
    const watchdog = new CommandWatchdog();
    watchdog.onCommand(0, ms, 1);
    assert.equal(watchdog.shouldHold(ms / 1000), false, String(ms));
  }
  assert.deepEqual([NaN, -1, 0, Infinity, 5, 1e9].map(enforcedTtlMs), [0, 0, 0, 0, 5, 60_000]);
});

// --- the action buffer ---------------------------------------------------------------------------

test("a plant moves only on an active command, and nothing moves after a reset", () => {
  let moved = 0;
  for (let n = 0; n < 2_000; n++) {
    const buffer = new ActionBuffer();
    // Since the last reset: the modes that were received by seq, and whether an ESTOP was among them.
    let modes = new Map<number, Mode>();
    let stopped = false;
    for (let step = 0; step < 25; step++) {
      if (random.chance(12)) {
        buffer.reset();
        modes = new Map();
        stopped = false;
      } else if (random.chance(2)) {
        const mode = random.chance(12) ? "estop" : random.pick(MODES.slice(0, 3).concat("active", "active"));
        const seq = random.below(40);
        buffer.receive(encode(moving([seq, 0, 0], { seq, mode })), 1);
        if (!modes.has(seq)) modes.set(seq, mode);
        stopped ||= mode === "estop";
      }
      const velocity = buffer.active(1)?.get("velocity_setpoint")?.data[0];
      if (velocity === undefined) continue;
      moved++;
      assert.equal(stopped, false);
      // Every velocity says by which command it is.
      assert.equal(modes.get(velocity), "active");
      assert.equal(Math.max(...modes.keys()), velocity, "the newest command is the one that counts");
    }
  }
  assert.ok(moved > 2_000, `${moved}`);
});

test("a sender whose seq begins again is held until a reset", () => {
  const buffer = new ActionBuffer();
  buffer.accept(moving([1, 0, 0], { seq: 1_000 }), 0);
  for (let seq = 1; seq < 20; seq++) buffer.accept(moving([1, 0, 0], { seq }), seq);
  assert.equal(buffer.active(19), null);
  buffer.reset();
  assert.equal(buffer.active(0), null);
  buffer.accept(moving([1, 0, 0], { seq: 20 }), 20);
  assert.notEqual(buffer.active(20), null);
});

test("a HOLD takes effect at once when it is not older or is not stamped, and refreshes nothing", () => {
  for (const mode of ["hold", "init"] as const) {
    const stillMoves = (seq: number): boolean => {
      const buffer = new ActionBuffer();
      buffer.accept(moving([1, 0, 0], { seq: 5 }), 0);
      buffer.accept(moving([0, 0, 0], { seq, mode }), 0.1);
      return buffer.active(0.1) !== null;
    };
    assert.deepEqual([4, 5, 6, 0, -1].map(stillMoves), [true, false, false, false, true]);
  }

  const buffer = new ActionBuffer();
  buffer.accept(moving([1, 0, 0], { seq: 5 }), 0);
  buffer.accept(moving([0, 0, 0], { seq: 5, mode: "hold" }), 0.15);
  buffer.accept(moving([1, 0, 0], { seq: 5 }), 0.16);
  assert.equal(buffer.active(0.16), null, "the same command again does not end the hold");
  buffer.accept(moving([1, 0, 0], { seq: 6, mode: "hold" }), 0.17);
  buffer.accept(moving([1, 0, 0], { seq: 6 }), 0.18);
  assert.equal(buffer.active(0.18), null, "a HOLD that advances has used its seq");
  buffer.accept(moving([1, 0, 0], { seq: 7 }), 0.19);
  assert.notEqual(buffer.active(0.19), null);
});

test("a horizon is replayed tick by tick, and the plant holds past its end", () => {
  const step = (speed: number): object => ({ velocity_setpoint: { data: [speed, 0, 0] } });
  const speedAt = (ms: number, dt: number | null = 50): number | undefined => {
    const buffer = new ActionBuffer();
    const horizon = [step(1), step(2)] as never;
    buffer.accept(moving([0, 0, 0], { seq: 1, ttl_ms: 500, horizon, horizon_dt_ms: dt }), 64);
    return buffer.active(64 + ms / 1000)?.get("velocity_setpoint")?.data[0];
  };
  assert.deepEqual(
    [0, 49, 51, 99, 101, 149, 151, 499].map((ms) => speedAt(ms)),
    [0, 0, 1, 1, 2, 2, undefined, undefined],
  );
  for (const dt of [null, 0, -1, NaN, Infinity]) assert.equal(speedAt(499, dt), 0);
  assert.equal(speedAt(501, null), undefined);
  assert.equal(speedAt(1, Number.MIN_VALUE), undefined);

  const buffer = new ActionBuffer();
  buffer.accept(moving([0, 0, 0], { seq: 1, horizon: [step(1)] as never, horizon_dt_ms: 50 }), 64);
  assert.equal(buffer.active(64.15), null);
  assert.equal(buffer.active(64.05), null, "a hold stays one when the clock steps back");
});

test("an ESTOP is latched from every JSON object of kind command_frame with the mode estop", () => {
  const deep = `${"[".repeat(70_000)}${"]".repeat(70_000)}`;
  const stops = (frame: string | Uint8Array): boolean => {
    const buffer = new ActionBuffer();
    buffer.accept(moving([1, 0, 0], { seq: 9 }), 0);
    try {
      buffer.receive(frame, 0);
    } catch {
      // A rejected frame may stop a plant, and never moves one.
    }
    assert.equal(buffer.active(0) === null, buffer.stopped);
    return buffer.stopped;
  };
  const rest = '"kind":"command_frame"';
  for (const frame of [
    `{${rest},"mode":"estop"}`,
    ` {\t"mode" : "estop" ,\n${rest}\r} `,
    `{${rest},"mode":"estop","seq":1}`,
    `{${rest},"mode":"estop","mode":"active"}`,
    `{${rest},"mode":"active","mode":"estop"}`,
    `{${rest},"mode":null,"mode":"estop","mode":{"mode":[]}}`,
    `{"kind":"sensor_frame",${rest},"mode":"estop"}`,
    `{${rest},"mode":"estop","seq":"x","t":null,"channels":[]}`,
    `{${rest},"mode":"estop","t":1e999,"seq":-1.5E+3}`,
    `{${rest},"mode":"estop","frame_id":"\\ud800"}`,
    `{${rest},"mode":"estop","a":{"b":1,"b":1},"a":[{},[],""]}`,
    `{${rest},"m\\u006fde":"\\u0065stop"}`,
    `{${rest},"a":${deep},"mode":"estop"}`,
    `{${rest},"a":"${"x".repeat(2_000_000)}","mode":"estop"}`,
    `\ufeff{${rest},"mode":"estop"}`,
    `{${rest},"mode":"estop"} and more`,
    Buffer.from(`{${rest},"mode":"estop","a":"\xff"}`, "latin1"),
  ]) {
    assert.ok(stops(frame), frame.toString().slice(0, 80));
  }
  for (const frame of [
    "",
    `[{${rest},"mode":"estop"}]`,
    `{${rest},"mode":"ESTOP","seq":"x"}`,
    `{${rest},"mode":"estop ","seq":"x"}`,
    `{${rest},"mode":["estop"]}`,
    `{${rest},"Mode":"estop","seq":"x"}`,
    `{"kind":"sensor_frame","mode":"estop"}`,
    `{"mode":"estop"}`,
    `{${rest},"channels":{"mode":"estop"}}`,
    `{${rest},"mode":"estop"`,
    `{${rest},"mode":"estop",}`,
    `{${rest},"mode":"estop","a":01}`,
    `{${rest},"mode":"estop","a":"\t"}`,
    `{${rest},"mode":"estop","a":"\\x"}`,
    `{${rest},"mode":"estop" "a":1}`,
    `{${rest},"mode":"estop","a":[1,]}`,
    `{${rest},"mode":"estop","a":{1:2}}`,
    `{${rest},"mode":"estop","a":[}]`,
    `{${rest},"mode":"estop","a":tru}`,
    `{${rest},"mode":"estop","a":1.}`,
    `{${rest},"mode":"estop","a":-}`,
  ]) {
    assert.ok(!stops(frame), frame);
  }
});

test("the search for an ESTOP takes for an object what JSON.parse takes for one", () => {
  const frame = '{"kind":"command_frame","mode":"estop","seq":"","a":[{"b":-1.5e-3,"c":"\\u00e9\\n"},true,null,[],{}]}';
  const letters = '{}[]:,"\\0-.eu t1\n';
  const isStop = (text: string): boolean => {
    const object = JSON.parse(text) as Record<string, unknown>;
    return object["kind"] === "command_frame" && object["mode"] === "estop";
  };
  const counts = { both: 0, neither: 0 };
  for (let n = 0; n < 10_000; n++) {
    const letter = (): string => letters[random.below(letters.length)]!;
    let text = frame;
    for (let edits = 1 + random.below(2); edits > 0; edits--) {
      const place = 38 + random.below(text.length - 38);
      text = text.slice(0, place) + (random.chance(3) ? "" : letter()) + text.slice(place + random.below(2));
    }
    const buffer = new ActionBuffer();
    try {
      buffer.receive(text, 0);
    } catch {
      // Most texts are no frames any more.
    }
    // What follows an object is not its part, so any beginning of the text may be the object.
    const ends = [...text].flatMap((character, end) => (character === "}" ? [end + 1] : []));
    const expected = ends.some((end) => {
      try {
        return isStop(text.slice(0, end));
      } catch {
        return false;
      }
    });
    assert.equal(buffer.stopped, expected, text);
    counts[expected ? "both" : "neither"]++;
  }
  assert.ok(counts.both > 500 && counts.neither > 500, JSON.stringify(counts));
});

test("a horizon is as long as its ttl, and no longer than a frame may have", () => {
  assert.equal(maxHorizonLen(200, 50), 4);
  assert.equal(maxHorizonLen(199.9, 50), 3);
  assert.equal(maxHorizonLen(1e308, 1e-308), 4_096);
  for (const bad of [NaN, Infinity, -Infinity, 0, -1]) {
    assert.equal(maxHorizonLen(bad, 50), 0);
    assert.equal(maxHorizonLen(50, bad), 0);
  }
});

// --- the link monitor ----------------------------------------------------------------------------

test("the loss rate is exact whatever is lost, late or repeated", () => {
  for (let n = 0; n < 300; n++) {
    const monitor = new LinkMonitor();
    const begin = random.below(2_000) - 1_000;
    const sent = Array.from({ length: 200 }, (_, k) => begin + k).filter(() => !random.chance(5));
    // Each frame comes some places late, and some come twice.
    const arriving = sent
      .flatMap((seq, k) =>
        (random.chance(10) ? [k, k + random.below(30)] : [k + random.below(12)]).map((at) => ({ seq, at })),
      )
      .sort((a, b) => a.at - b.at);
    const first = arriving[0]!.seq;
    const seen = new Set<number>();
    let highest = -Infinity;
    for (const { seq } of arriving) {
      // What is older than the first frame was never expected.
      if (seq >= first) seen.add(seq);
      highest = Math.max(highest, seq);
      const report = monitor.onFrame(seq);
      const expected = highest - first + 1;
      assert.equal(report.last_seq, highest);
      assert.equal(report.received, seen.size);
      assert.equal(report.lost, expected - seen.size);
      assert.equal(report.loss_rate, (expected - seen.size) / expected);
    }
  }
});

test("a burst is raised when losses bunch up, and a healthy link clears it in bounded time", () => {
  const monitor = new LinkMonitor(0.25, 2);
  assert.deepEqual(monitor.report(), { last_seq: -1, received: 0, lost: 0, loss_rate: 0, burst: false });
  assert.equal(monitor.onFrame(1).burst, false);
  // 3 · 0.75 − 0.25 is at the threshold, not above it; the fourth loss is.
  assert.equal(monitor.onFrame(5).burst, false);
  assert.equal(monitor.onFrame(7).burst, true);
  // The detector stays within twice the threshold: (4 − 2) / 0.25 deliveries clear whatever was lost.
  const bursts = Array.from({ length: 10 }, (_, k) => monitor.onFrame(2 ** 40 + k).burst);
  assert.deepEqual(bursts.indexOf(false), 7);
  assert.deepEqual(bursts.slice(7), [false, false, false]);
});

test("a gap makes at most 256 updates of the detector", () => {
  const burstOf = (gap: number, threshold: number): boolean => {
    const monitor = new LinkMonitor(0, threshold);
    monitor.onFrame(0);
    return monitor.onFrame(gap + 1).burst;
  };
  assert.deepEqual(
    [255, 256, 300].map((gap) => burstOf(gap, 255)),
    [false, true, true],
  );
  assert.deepEqual(
    [256, 300, 1e9].map((gap) => burstOf(gap, 256)),
    [false, false, false],
  );
});

test("the monitor survives every seq, and keeps its counts among the integers of the wire", () => {
  const most = Number.MAX_SAFE_INTEGER;
  for (const [first, second] of [
    [-most, most],
    [-(2 ** 63), 2 ** 63],
    [0, most],
    [-most, 1],
  ] as const) {
    const monitor = new LinkMonitor();
    monitor.onFrame(first);
    const report = monitor.onFrame(second);
    assert.equal(report.burst, true);
    assert.ok(Number.isSafeInteger(report.lost) && report.lost > 2 ** 52);
    assert.ok(report.loss_rate > 0.99 && report.loss_rate <= 1);
    assert.deepEqual(monitor.onFrame(second), report);
  }
});

test("at most 4096 missing seqs are remembered, the newest", () => {
  const monitor = new LinkMonitor();
  monitor.onFrame(0);
  monitor.onFrame(3_001);
  monitor.onFrame(10_001);
  const lost = monitor.report().lost;
  assert.equal(lost, 9_999);
  assert.equal(monitor.onFrame(5_904).lost, lost);
  assert.equal(monitor.onFrame(3_000).lost, lost);
  assert.equal(monitor.onFrame(5_905).lost, lost - 1);
  assert.equal(monitor.onFrame(10_000).lost, lost - 2);
});

test("bad settings of the monitor are replaced", () => {
  const burstAfter = (refLoss: number, threshold: number): number => {
    const monitor = new LinkMonitor(refLoss, threshold);
    monitor.onFrame(0);
    let seq = 0;
    while (seq < 4_000 && !monitor.onFrame((seq += 2)).burst);
    return seq / 2;
  };
  const usual = burstAfter(0.05, 5);
  assert.equal(usual, 6);
  for (const refLoss of [NaN, Infinity, -Infinity]) assert.equal(burstAfter(refLoss, 5), usual);
  for (const threshold of [NaN, Infinity, 0, -1]) assert.equal(burstAfter(0.05, threshold), usual);
  assert.equal(burstAfter(-3, 5), burstAfter(0, 5));
  assert.equal(burstAfter(7, 5), burstAfter(0.99, 5));
});
