import assert from "node:assert/strict";
import { test } from "node:test";
import {
  BulkError,
  create,
  decode,
  decodeBlock,
  encode,
  encodeBlock,
  fromBulkObservation,
  pack,
  toBulkObservation,
  unpack,
  type Column,
  type Observation,
} from "@ncp-conformance/peer";
import { Random, refuses } from "./support.js";

/** The golden block, as the text prints it. */
const GOLDEN = Buffer.from(
  `4e 43 50 42  01  00  02 00  68 00 00 00
   2c 00 00 00  05 00  02  00  03 00 00 00  38 00 00 00
   31 00 00 00  07 00  04  00  03 00 00 00  50 00 00 00
   74 69 6d 65 73  73 65 6e 64 65 72 73
   00 00 00 00 00 00 f8 3f  00 00 00 00 00 00 04 40  00 00 00 00 00 00 22 40
   07 00 00 00 00 00 00 00  07 00 00 00 00 00 00 00  09 00 00 00 00 00 00 00`.replace(/\s/g, ""),
  "hex",
);
const GOLDEN_COLUMNS: Column[] = [
  { name: "times", dtype: "f64", data: Float64Array.of(1.5, 2.5, 9) },
  { name: "senders", dtype: "i64", data: BigInt64Array.of(7n, 7n, 9n) },
];

interface Raw {
  readonly name: string | Uint8Array;
  readonly nameOffset?: number;
  readonly nameLength?: number;
  readonly dtype: number;
  readonly pad?: number;
  readonly rows: number;
  readonly dataOffset?: number;
  readonly data: Uint8Array;
}

/** A block put together by hand: names after the directory, data after them without alignment. */
function raw(columns: readonly Raw[], trailing = 0): Buffer {
  const names = columns.map(({ name }) => Buffer.from(name));
  let at = 12 + 16 * columns.length;
  const nameOffsets = names.map((name) => (at += name.length) - name.length);
  const dataOffsets = columns.map(({ data }) => (at += data.length) - data.length);
  const block = Buffer.alloc(at + trailing);
  block.write("NCPB\x01\x00", "latin1");
  block.writeUInt16LE(columns.length, 6);
  block.writeUInt32LE(block.length, 8);
  columns.forEach((column, n) => {
    const entry = 12 + 16 * n;
    block.writeUInt32LE(column.nameOffset ?? nameOffsets[n]!, entry);
    block.writeUInt16LE(column.nameLength ?? names[n]!.length, entry + 4);
    block.writeUInt8(column.dtype, entry + 6);
    block.writeUInt8(column.pad ?? 0, entry + 7);
    block.writeUInt32LE(column.rows, entry + 8);
    block.writeUInt32LE(column.dataOffset ?? dataOffsets[n]!, entry + 12);
    block.set(names[n]!, nameOffsets[n]!);
    block.set(column.data, dataOffsets[n]!);
  });
  return block;
}

const one = (column: Partial<Raw>): Buffer =>
  raw([{ name: "a", dtype: 2, rows: 1, data: new Uint8Array(8), ...column }]);

function isRejected(block: Uint8Array): void {
  assert.throws(() => decodeBlock(block), BulkError);
}

test("the golden block is written to the byte and read back", () => {
  assert.equal(GOLDEN.length, 104);
  assert.deepEqual(Buffer.from(encodeBlock(GOLDEN_COLUMNS)), GOLDEN);
  assert.deepEqual(decodeBlock(GOLDEN), GOLDEN_COLUMNS);
});

test("every value of every dtype is read exactly", () => {
  const columns: Column[] = [
    {
      name: "f32",
      dtype: "f32",
      data: Float32Array.of(0, -0, 1.5, 1e-45, -3.4028234663852886e38, NaN, Infinity, -Infinity),
    },
    {
      name: "f64",
      dtype: "f64",
      data: Float64Array.of(0, -0, 0.1, 5e-324, -Number.MAX_VALUE, NaN, Infinity, -Infinity),
    },
    { name: "i32", dtype: "i32", data: Int32Array.of(0, -1, 1, 2147483647, -2147483648) },
    { name: "i64", dtype: "i64", data: BigInt64Array.of(0n, -1n, 1n, 2n ** 63n - 1n, -(2n ** 63n)) },
  ];
  assert.deepEqual(decodeBlock(encodeBlock(columns)), columns);
});

test("a block without columns and a column without rows are read and written", () => {
  const empty = encodeBlock([]);
  assert.equal(empty.length, 12);
  assert.deepEqual(decodeBlock(empty), []);
  const columns: Column[] = [
    { name: "", dtype: "f32", data: new Float32Array(0) },
    { name: "x", dtype: "i32", data: Int32Array.of(5) },
    { name: "none", dtype: "i64", data: new BigInt64Array(0) },
  ];
  assert.deepEqual(decodeBlock(encodeBlock(columns)), columns);
});

test("a header that is not that of a block is rejected", () => {
  isRejected(GOLDEN.subarray(0, 0));
  isRejected(GOLDEN.subarray(0, 11));
  isRejected(GOLDEN.subarray(0, 103));
  isRejected(Buffer.concat([GOLDEN, Buffer.alloc(1)]));
  for (const [at, value] of [
    [0, 0x6e],
    [3, 0],
    [4, 0],
    [4, 2],
    [5, 1],
    [5, 0x80],
    [6, 3],
    [7, 1],
    [8, 0x67],
    [8, 0x69],
    [11, 1],
  ] as const) {
    const block = Buffer.from(GOLDEN);
    block[at] = value;
    isRejected(block);
  }
});

test("a directory that claims what is not there is rejected", () => {
  const faulty: Partial<Raw>[] = [
    { dtype: 0 },
    { dtype: 5 },
    { dtype: 255 },
    { pad: 1 },
    { nameOffset: 37 },
    { nameOffset: 0xffffffff },
    { nameLength: 10 },
    { nameLength: 0xffff },
    { nameOffset: 36, nameLength: 2 },
    { rows: 2 },
    { rows: 0x20000000 },
    { rows: 0xffffffff },
    { dataOffset: 30 },
    { dataOffset: 0xfffffff8 },
    { dataOffset: 38 },
    { rows: 0, dataOffset: 38 },
    { nameLength: 0, nameOffset: 38 },
    { rows: 0, dataOffset: 0xffffffff },
  ];
  for (const column of faulty) isRejected(one(column));
  decodeBlock(one({}));
  decodeBlock(one({ rows: 0, dataOffset: 37 }));
  decodeBlock(one({ rows: 0, dataOffset: 0 }));
  decodeBlock(one({ nameLength: 0, nameOffset: 37 }));
});

test("a name that is not UTF-8 is rejected, and one that is, is kept as it is", () => {
  for (const name of [[0xff], [0xc3], [0xed, 0xa0, 0x80], [0xc0, 0x80]])
    isRejected(one({ name: Uint8Array.from(name) }));
  for (const name of ["é", "😀", "\ufeffa", "\0", "x".repeat(65_535)])
    assert.equal(decodeBlock(one({ name }))[0]!.name, name);
});

test("two regions that share a byte are rejected, whichever they are", () => {
  const two = (first: Partial<Raw>, second: Partial<Raw>): Buffer =>
    raw([
      { name: "aa", dtype: 1, rows: 2, data: new Uint8Array(8), ...first },
      { name: "bb", dtype: 1, rows: 2, data: new Uint8Array(8), ...second },
    ]);
  const names = 44;
  const data = 48;
  decodeBlock(two({}, {}));
  const faulty = [
    two({}, { dataOffset: data }),
    two({}, { dataOffset: data + 4 }),
    two({ dataOffset: data + 7 }, {}),
    two({}, { nameOffset: names }),
    two({}, { nameOffset: names + 1 }),
    two({ dataOffset: names - 1 }, {}),
    two({ dataOffset: names + 3 }, {}),
    two({ dataOffset: 0 }, {}),
    two({ dataOffset: 8 }, {}),
    two({ dataOffset: 20 }, {}),
    two({ nameOffset: 0 }, {}),
    two({ nameOffset: 43 }, {}),
    two({ nameOffset: data + 15, nameLength: 1 }, {}),
  ];
  for (const block of faulty) isRejected(block);
});

test("many columns that claim the same bytes are rejected without being copied", () => {
  const columns = Array.from({ length: 4_096 }, (_, n): Raw => ({
    name: String(n),
    dtype: 2,
    rows: 100_000,
    dataOffset: 90_000,
    data: new Uint8Array(n === 0 ? 1_000_000 : 0),
  }));
  const before = process.memoryUsage().arrayBuffers;
  const block = raw(columns);
  isRejected(block);
  assert.ok(process.memoryUsage().arrayBuffers - before < 10_000_000);
});

test("two columns of one name are rejected and refused", () => {
  isRejected(
    raw([
      { name: "a", dtype: 1, rows: 0, data: new Uint8Array(0) },
      { name: "a", dtype: 2, rows: 0, data: new Uint8Array(0) },
    ]),
  );
  const column: Column = { name: "a", dtype: "i32", data: Int32Array.of(1) };
  refuses("block", () => encodeBlock([column, column]));
});

test("bytes that belong to no region and columns in any place are accepted", () => {
  const block = raw([{ name: "b", dtype: 4, rows: 1, data: Buffer.from("0123456789abcdef", "hex") }], 5);
  block[block.length - 1] = 0xff;
  const [column] = decodeBlock(block);
  assert.deepEqual(column!.data, BigInt64Array.of(BigInt.asIntN(64, 0xefcdab8967452301n)));
});

test("a column is a view where it is aligned, and a copy of its own bytes elsewhere", () => {
  const block = encodeBlock([{ name: "abc", dtype: "f64", data: Float64Array.of(1, 2) }]);
  assert.equal(decodeBlock(block)[0]!.data.buffer, block.buffer);
  for (let shift = 0; shift < 9; shift++) {
    const buffer = new Uint8Array(block.length + shift);
    buffer.set(block, shift);
    const { data } = decodeBlock(buffer.subarray(shift))[0]!;
    assert.deepEqual([...data], [1, 2]);
    assert.equal(data.buffer === buffer.buffer, shift % 8 === 0);
    assert.ok(data.buffer === buffer.buffer || data.buffer.byteLength === 16);
  }
});

test("each column's data begins at a multiple of 8, and the bytes between are 0", () => {
  const block = encodeBlock([
    { name: "a", dtype: "i32", data: Int32Array.of(-1) },
    { name: "b", dtype: "f32", data: Float32Array.of(1) },
  ]);
  assert.equal(block.length, 48 + 8 + 4);
  assert.deepEqual([...block.subarray(46, 48)], [0, 0]);
  assert.deepEqual([...block.subarray(48, 56)], [255, 255, 255, 255, 0, 0, 0, 0]);
});

test("what does not fit a field or a limit is refused", () => {
  const column = (name: string, rows = 0): Column => ({ name, dtype: "f64", data: new Float64Array(rows) });
  encodeBlock(Array.from({ length: 4_096 }, (_, n) => column(`c${n}`)));
  refuses("limit", () => encodeBlock(Array.from({ length: 4_097 }, (_, n) => column(`c${n}`))));
  encodeBlock([column("x".repeat(65_535))]);
  refuses("block", () => encodeBlock([column("x".repeat(65_536))]));
  refuses("block", () => encodeBlock([column("é".repeat(32_768))]));
  refuses("block", () => encodeBlock([column("\ud800")]));
  assert.equal(encodeBlock([column("12345678901", 8_388_608 - 5)]).length, 67_108_864);
  refuses("limit", () => encodeBlock([column("123456789012", 8_388_608 - 4)]));
  refuses("block", () => encodeBlock([{ name: "a", dtype: "f32", data: new Float64Array(1) } as unknown as Column]));
});

test("a block of 64 MiB and 4096 columns is read, and one of more is rejected", () => {
  const column = (n: number): Raw => ({ name: String(n), dtype: 3, rows: 0, data: new Uint8Array(0) });
  assert.equal(decodeBlock(raw(Array.from({ length: 4_096 }, (_, n) => column(n)))).length, 4_096);
  refuses("limit", () => decodeBlock(raw(Array.from({ length: 4_097 }, (_, n) => column(n)))));
  const large = raw([], 67_108_864 - 12);
  assert.deepEqual(decodeBlock(large), []);
  refuses("limit", () => decodeBlock(raw([], 67_108_864 - 11)));
});

test("random columns read back as what was written, and changed blocks do no more than be rejected", () => {
  const random = new Random(6);
  for (let n = 0; n < 3_000; n++) {
    const columns = Array.from({ length: random.below(5) }, (_, i): Column => {
      const name = `${i}${random.text()}`;
      const items = Array.from({ length: random.below(5) }, () => random.bits() | 0);
      return random.pick<Column>([
        { name, dtype: "f32", data: Float32Array.from(items) },
        { name, dtype: "f64", data: Float64Array.from(items, () => random.double()) },
        { name, dtype: "i32", data: Int32Array.from(items) },
        { name, dtype: "i64", data: BigInt64Array.from(items, (item) => BigInt(item) * 4_294_967_311n) },
      ]);
    });
    const block = encodeBlock(columns);
    assert.deepEqual(decodeBlock(block), columns);
    for (let times = 1 + random.below(3); times > 0; times--)
      block[random.below(block.length)] = random.pick([0, 1, 2, 255, random.below(256)]);
    try {
      const read = decodeBlock(block);
      assert.ok(read.reduce((sum, { data }) => sum + data.byteLength, 0) <= block.length);
    } catch (error) {
      assert.ok(error instanceof BulkError, `a crash: ${String(error)}`);
    }
  }
});

test("an observation is packed without columns for empty arrays", () => {
  assert.deepEqual(Buffer.from(pack({ times: [1.5, 2.5, 9], values: [], senders: [7, 7, 9] })), GOLDEN);
  assert.deepEqual(decodeBlock(pack({ times: [], values: [], senders: [] })), []);
  assert.deepEqual(
    decodeBlock(pack({ times: [1], values: [2], senders: BigInt64Array.of(-(2n ** 63n)) })).map(({ name, dtype }) => [
      name,
      dtype,
    ]),
    [
      ["times", "f64"],
      ["values", "f64"],
      ["senders", "i64"],
    ],
  );
});

test("arrays that differ in length are refused and rejected", () => {
  refuses("block", () => pack({ times: [1], values: [1, 2], senders: [] }));
  refuses("block", () => pack({ times: [], values: [1, 2], senders: [1] }));
  refuses("block", () => pack({ times: [1], values: [], senders: [1, 2] }));
  refuses("block", () => pack({ times: [1], values: [], senders: [1.5] }));
  const lengths = (times: number, senders: number): Uint8Array =>
    encodeBlock([
      { name: "times", dtype: "f64", data: new Float64Array(times) },
      { name: "senders", dtype: "i64", data: new BigInt64Array(senders) },
    ]);
  refuses("block", () => unpack(lengths(1, 2)));
  assert.equal(unpack(lengths(0, 2)).senders.length, 2);
});

test("the columns of an observation are found in any order and among others", () => {
  const samples = unpack(
    encodeBlock([
      { name: "senders", dtype: "i64", data: BigInt64Array.of(1n) },
      { name: "weights", dtype: "f32", data: Float32Array.of(1, 2, 3) },
      { name: "times", dtype: "f64", data: Float64Array.of(2) },
    ]),
  );
  assert.deepEqual(samples, { times: Float64Array.of(2), values: new Float64Array(0), senders: BigInt64Array.of(1n) });
});

test("a column of an observation in another dtype is rejected", () => {
  refuses("block", () => unpack(encodeBlock([{ name: "times", dtype: "f32", data: Float32Array.of(1) }])));
  refuses("block", () => unpack(encodeBlock([{ name: "values", dtype: "i64", data: BigInt64Array.of(1n) }])));
  refuses("block", () => unpack(encodeBlock([{ name: "senders", dtype: "i32", data: Int32Array.of(1) }])));
});

test("a packed observation travels as a frame and comes back", () => {
  const frame = create("observation_frame", {
    session_id: "s",
    records: {
      p: {
        port: "p",
        target: "exc",
        times: [0.1, 0.2],
        values: [-65, -64.5],
        senders: [1, 2],
        unit: "mV",
        recordable: "V_m",
      },
    },
  });
  const observation: Observation = frame.records.get("p")!;
  const text = encode(toBulkObservation(observation));
  assert.deepEqual(fromBulkObservation(decode("bulk_observation", text)), {
    ...observation,
    senders: BigInt64Array.of(1n, 2n),
  });
});

test("a block that is not padded base64 is rejected", () => {
  const text = GOLDEN.toString("base64");
  const read = (block: string): unknown => fromBulkObservation(create("bulk_observation", { block }));
  read(text);
  for (const block of [
    "",
    text.replace(/=+$/, ""),
    `${text} `,
    `\n${text}`,
    text.replaceAll("A", "_"),
    `${text}=`,
    "TkNQQgEAAAAMAAAB",
  ]) {
    refuses("block", () => read(block));
  }
});
