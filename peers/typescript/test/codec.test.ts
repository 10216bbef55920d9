import assert from "node:assert/strict";
import { test } from "node:test";
import { create, RateCodec, UAV_CODEC, type Mapping, type SensorFrame } from "@ncp-conformance/peer";
import { Random, refuses } from "./support.js";

const random = new Random(9);
const MAPPING: Mapping = { channel: "a", component: 0, population: "p" };
const HEAD = { t: 1.5, seq: 3, frame_id: "map", mode: "active" } as const;

function sensing(data: readonly number[], channel = "a"): SensorFrame {
  return create("sensor_frame", { channels: { [channel]: { data } } });
}

function codec(...mappings: Partial<Mapping>[]): RateCodec {
  const complete = mappings.map((mapping) => ({ ...MAPPING, ...mapping }));
  return new RateCodec({ encoders: complete, decoders: complete });
}

test("a value within its range comes back from its rate", () => {
  for (let n = 0; n < 5_000; n++) {
    const value_range = [random.between(-9, 9), random.between(-9, 9)] as const;
    const rate_range = [random.between(-9, 500), random.between(-9, 500)] as const;
    const tied = codec({ value_range, rate_range });
    const share = random.between(0, 1);
    const value = value_range[0] + share * (value_range[1] - value_range[0]);
    const rate = tied.encode(sensing([value])).get("p")!;
    assert.ok(Math.abs(rate - (rate_range[0] + share * (rate_range[1] - rate_range[0]))) < 1e-9);
    const back = tied.decode({ p: rate }, HEAD).channels.get("a")!.data[0]!;
    assert.ok(Math.abs(back - value) < 1e-9);
  }
});

test("between ends that are further apart than a double can say, the middle and the ends are where they are", () => {
  const wide = [-1.5e308, 1.5e308] as const;
  const rateOf = (value: number) => codec({ rate_range: wide }).encode(sensing([value])).get("p");
  assert.deepEqual([rateOf(-1), rateOf(0), rateOf(1), rateOf(NaN)], [-1.5e308, 0, 1.5e308, 0]);
  assert.equal(codec({ value_range: wide }).decode({}, HEAD).channels.get("a")!.data[0], 0);
});

test("results never leave their range, whatever the input", () => {
  for (let n = 0; n < 5_000; n++) {
    const value_range = [random.between(-1e3, 1e3), random.between(-1e3, 1e3)] as const;
    const rate_range = [random.between(-1e3, 1e3), random.between(-1e3, 1e3)] as const;
    const tied = codec({ value_range, rate_range });
    const input = random.chance(9) ? random.pick([NaN, Infinity, -Infinity]) : random.double();
    for (const [out, range] of [
      [tied.encode(sensing([input])).get("p")!, rate_range],
      [tied.decode(new Map([["p", input]]), HEAD).channels.get("a")!.data[0]!, value_range],
    ] as const) {
      assert.ok(out >= Math.min(...range) && out <= Math.max(...range), `${input} to ${out} of ${range}`);
    }
  }
});

test("what is missing, not finite or without a range is the middle", () => {
  const rateOf = (tied: RateCodec, sensor: SensorFrame | null): number | undefined => tied.encode(sensor).get("p");
  const tied = codec({ rate_range: [50, 100], component: 1 });
  for (const sensor of [
    null,
    sensing([]),
    sensing([1]),
    sensing([1, NaN]),
    sensing([1, -Infinity]),
    sensing([1, 1], "b"),
  ]) {
    assert.equal(rateOf(tied, sensor), 75);
  }
  assert.equal(rateOf(tied, sensing([9, 1])), 100);
  for (const value_range of [
    [1, 1],
    [NaN, 1],
    [-1, Infinity],
    [-Number.MAX_VALUE, Number.MAX_VALUE],
  ] as const) {
    assert.equal(rateOf(new RateCodec({ encoders: [{ ...MAPPING, value_range }], decoders: [] }), sensing([1])), 100);
  }
  const valueOf = (rates: Record<string, number>, rate_range: readonly [number, number] = [0, 200]): number =>
    codec({ value_range: [2, 4], rate_range })
      .decode(rates, HEAD)
      .channels.get("a")!.data[0]!;
  assert.deepEqual([valueOf({}), valueOf({ p: NaN }), valueOf({ p: Infinity }), valueOf({ p: 0 })], [3, 3, 3, 2]);
  assert.equal(valueOf({ p: 200 }, [7, 7]), 3);
});

test("mappings of components from 4096 on are ignored, and components between others are 0", () => {
  const tied = codec({ component: 4_095 }, { component: 4_096, population: "q" }, { component: 5e9, channel: "b" });
  assert.deepEqual([...tied.encode(null).keys()], ["p"]);
  const { channels } = tied.decode({ p: 200, q: 200 }, HEAD);
  assert.deepEqual([...channels.keys()], ["a"]);
  const { data } = channels.get("a")!;
  assert.equal(data.length, 4_096);
  assert.equal(data[4_095], 1);
  assert.ok(data.subarray(0, 4_095).every((component) => component === 0));
});

test("a codec refuses a component that is none, and a range that nothing can be mapped to", () => {
  for (const component of [-1, 0.5, NaN]) refuses("value", () => codec({ component }));
  refuses("value", () => new RateCodec({ encoders: [{ ...MAPPING, rate_range: [0, NaN] }], decoders: [] }));
  refuses("value", () => new RateCodec({ encoders: [], decoders: [{ ...MAPPING, value_range: [0, Infinity] }] }));
});

test("the default UAV codec encodes the pose error and decodes the velocity", () => {
  const uav = new RateCodec(UAV_CODEC);
  assert.deepEqual(
    [...uav.encode(sensing([-2, 1, 9], "pose_error"))],
    [
      ["err_x", 0],
      ["err_y", 150],
      ["err_z", 200],
    ],
  );
  assert.deepEqual(
    uav.decode({ vel_x: 0, vel_y: 150 }, HEAD),
    create("command_frame", { ...HEAD, channels: { velocity_setpoint: { data: [-1.5, 0.75, 0], unit: "m/s" } } }),
  );
});
