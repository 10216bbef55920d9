/**
 * BulkBlock: packed columns of numbers that a reader can use where they lie (chapter 5.1).
 *
 * @module
 */

import { BulkError } from "./errors.js";
import { BLOCK_BYTES, BLOCK_COLUMNS } from "./limits.js";
import { isWellFormed } from "./unicode.js";

/** The type of a column's values. */
export type Dtype = "f32" | "f64" | "i32" | "i64";

/** A named column; `data` is of the array type that its dtype names. */
export type Column =
  | { readonly name: string; readonly dtype: "f32"; readonly data: Float32Array }
  | { readonly name: string; readonly dtype: "f64"; readonly data: Float64Array }
  | { readonly name: string; readonly dtype: "i32"; readonly data: Int32Array }
  | { readonly name: string; readonly dtype: "i64"; readonly data: BigInt64Array };

/**
 * Reads a block.
 *
 * A column's `data` is a view into `block` where the column is aligned in its buffer to the size of its
 * values, as the columns of {@link encodeBlock} are; elsewhere it is a copy of the column alone. So the
 * columns never take more memory than the block. [NCP-BULK-024]
 *
 * @param block - the bytes of the whole block and no others
 * @returns the columns in the order of the directory [NCP-BULK-021]
 * @throws {@link BulkError} when the block is rejected
 *
 * Rules: NCP-BULK-001 to NCP-BULK-024.
 */
export function decodeBlock(block: Uint8Array): Column[] {
  const length = block.length;
  // [NCP-BULK-015] [NCP-BULK-025]
  if (length > BLOCK_BYTES) throw new BulkError(`the block has more than ${BLOCK_BYTES} bytes`, "limit");
  if (length < HEADER_BYTES) throw new BulkError("the block is shorter than its header"); // [NCP-BULK-001]
  const view = new DataView(block.buffer, block.byteOffset, length);
  if (view.getUint32(0) !== MAGIC) throw new BulkError("the block does not begin with NCPB"); // [NCP-BULK-002]
  if (view.getUint8(4) !== VERSION) throw new BulkError("the block's version is not 1"); // [NCP-BULK-003]
  if (view.getUint8(5) !== 0) throw new BulkError("the block's flags are not 0"); // [NCP-BULK-004]
  const count = view.getUint16(6, true);
  if (view.getUint32(8, true) !== length) throw new BulkError("total_len is not the block's length"); // [NCP-BULK-005]
  // [NCP-BULK-016] [NCP-BULK-017]
  if (count > BLOCK_COLUMNS) throw new BulkError(`the block has more than ${BLOCK_COLUMNS} columns`, "limit");
  const directoryEnd = HEADER_BYTES + ENTRY_BYTES * count;
  if (directoryEnd > length) throw new BulkError("the directory does not fit into the block"); // [NCP-BULK-006]

  const regions = new Regions(length, 1 + 2 * count);
  regions.add(0, directoryEnd, "the directory");
  const entries: Entry[] = [];
  for (let n = 0; n < count; n++) {
    const entry = readEntry(view, HEADER_BYTES + ENTRY_BYTES * n, n);
    regions.add(entry.nameOffset, entry.nameLength, `the name of column ${n}`); // [NCP-BULK-009]
    regions.add(entry.dataOffset, entry.rows * WIDTHS[entry.dtype], `the data of column ${n}`); // [NCP-BULK-011]
    entries.push(entry);
  }
  // All claims are checked before anything is allocated for a column.
  regions.checkDisjoint(); // [NCP-BULK-012]

  const names = new Set<string>();
  return entries.map((entry, n) => {
    const name = readName(block, entry, n);
    if (names.has(name)) throw new BulkError(`column ${n} repeats the name of another`); // [NCP-BULK-013]
    names.add(name);
    return readColumn(block, name, entry);
  });
}

/**
 * Writes a block: the directory, the names, and each column's data at the next multiple of 8.
 *
 * @throws {@link BulkError} when a count, a length or an offset does not fit its field or a limit, when
 * two columns have one name, or when a name has no UTF-8 form
 *
 * Rules: NCP-BULK-030 to NCP-BULK-035.
 */
export function encodeBlock(columns: readonly Column[]): Uint8Array<ArrayBuffer> {
  // [NCP-BULK-031]
  if (columns.length > BLOCK_COLUMNS) throw new BulkError(`there are more than ${BLOCK_COLUMNS} columns`, "limit");
  const names = columns.map(({ name }) => encodeName(name));
  if (new Set(columns.map(({ name }) => name)).size < columns.length) {
    throw new BulkError("two columns have the same name"); // [NCP-BULK-034]
  }

  let end = HEADER_BYTES + ENTRY_BYTES * columns.length;
  const nameOffsets = names.map((name) => (end += name.length) - name.length); // [NCP-BULK-032]
  const dataOffsets = columns.map(({ name, dtype, data }) => {
    if (!(data instanceof ARRAYS[dtype])) throw new BulkError(`the data of ${name} is not of type ${dtype}`);
    const offset = Math.ceil(end / 8) * 8; // [NCP-BULK-033]
    end = offset + data.byteLength;
    return offset;
  });
  if (end > BLOCK_BYTES) throw new BulkError(`the block would have more than ${BLOCK_BYTES} bytes`, "limit");

  const block = new Uint8Array(end);
  const view = new DataView(block.buffer);
  view.setUint32(0, MAGIC);
  view.setUint8(4, VERSION);
  view.setUint16(6, columns.length, true);
  view.setUint32(8, end, true);
  columns.forEach(({ dtype, data }, n) => {
    const at = HEADER_BYTES + ENTRY_BYTES * n;
    view.setUint32(at, nameOffsets[n]!, true);
    view.setUint16(at + 4, names[n]!.length, true);
    view.setUint8(at + 6, DTYPES.indexOf(dtype) + 1);
    view.setUint32(at + 8, data.length, true);
    view.setUint32(at + 12, dataOffsets[n]!, true);
    block.set(names[n]!, nameOffsets[n]!);
    block.set(
      littleEndian(new Uint8Array(data.buffer, data.byteOffset, data.byteLength), WIDTHS[dtype]),
      dataOffsets[n]!,
    );
  });
  return block;
}

interface Entry {
  readonly nameOffset: number;
  readonly nameLength: number;
  readonly dtype: Dtype;
  readonly rows: number;
  readonly dataOffset: number;
}

const MAGIC = 0x4e435042;
const VERSION = 1;
const HEADER_BYTES = 12;
const ENTRY_BYTES = 16;
const NAME_BYTES = 0xffff;

/** The dtypes in the order of their numbers, from 1. */
const DTYPES: readonly Dtype[] = ["f32", "f64", "i32", "i64"];
const WIDTHS: Readonly<Record<Dtype, number>> = { f32: 4, f64: 8, i32: 4, i64: 8 };
const ARRAYS = { f32: Float32Array, f64: Float64Array, i32: Int32Array, i64: BigInt64Array } as const;

const HOST_IS_LITTLE_ENDIAN = new Uint8Array(new Uint16Array([1]).buffer)[0] === 1;

// Without `ignoreBOM`, the decoder would drop a U+FEFF at the begin of a name.
const UTF8 = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true });

function readEntry(view: DataView, at: number, n: number): Entry {
  const dtype = DTYPES[view.getUint8(at + 6) - 1];
  if (dtype === undefined) throw new BulkError(`the dtype of column ${n} is not known`); // [NCP-BULK-007]
  if (view.getUint8(at + 7) !== 0) throw new BulkError(`the pad byte of column ${n} is not 0`); // [NCP-BULK-008]
  // [NCP-BULK-022]
  return {
    nameOffset: view.getUint32(at, true),
    nameLength: view.getUint16(at + 4, true),
    dtype,
    rows: view.getUint32(at + 8, true),
    dataOffset: view.getUint32(at + 12, true),
  };
}

function readName(block: Uint8Array, { nameOffset, nameLength }: Entry, n: number): string {
  try {
    return UTF8.decode(block.subarray(nameOffset, nameOffset + nameLength));
  } catch {
    throw new BulkError(`the name of column ${n} is not UTF-8`); // [NCP-BULK-010]
  }
}

/** [NCP-BULK-018] [NCP-BULK-019] [NCP-BULK-023] */
function readColumn(block: Uint8Array, name: string, { dtype, rows, dataOffset }: Entry): Column {
  const width = WIDTHS[dtype];
  let bytes = block.subarray(dataOffset, dataOffset + rows * width);
  // Not `slice`, which is a view where the bytes are a Node buffer.
  if (bytes.byteOffset % width !== 0) bytes = new Uint8Array(bytes);
  bytes = littleEndian(bytes, width);
  const data = new ARRAYS[dtype](bytes.buffer as ArrayBuffer, bytes.byteOffset, rows);
  return { name, dtype, data } as Column;
}

/** The bytes of values of this width, turned round if the host is big-endian. */
function littleEndian(bytes: Uint8Array, width: number): Uint8Array {
  if (HOST_IS_LITTLE_ENDIAN) return bytes;
  const turned = new Uint8Array(bytes);
  for (let at = 0; at < turned.length; at += width) turned.subarray(at, at + width).reverse();
  return turned;
}

function encodeName(name: string): Uint8Array {
  if (!isWellFormed(name)) throw new BulkError("the name of a column has no UTF-8 form");
  if (name.length > NAME_BYTES) throw new BulkError(`the name of a column has more than ${NAME_BYTES} bytes`);
  const bytes = new TextEncoder().encode(name);
  if (bytes.length > NAME_BYTES) throw new BulkError(`the name of a column has more than ${NAME_BYTES} bytes`);
  return bytes;
}

/**
 * The regions of a block: each must lie within it, and no two may share a byte. What lies between them
 * belongs to none and has no meaning. [NCP-BULK-020]
 */
class Regions {
  private readonly length: number;
  /** Each region that is not empty as begin · 2^27 + end: a block ends before 2^27, so this sorts by begin. */
  private readonly packed: Float64Array;
  private count = 0;

  constructor(length: number, most: number) {
    this.length = length;
    this.packed = new Float64Array(most);
  }

  add(offset: number, length: number, what: string): void {
    // [NCP-BULK-014] An empty region may begin at the end, but not beyond it.
    if (offset + length > this.length) throw new BulkError(`${what} does not lie within the block`);
    // Empty regions share no byte with anything.
    if (length > 0) this.packed[this.count++] = offset * SHIFT + offset + length;
  }

  checkDisjoint(): void {
    const sorted = this.packed.subarray(0, this.count).sort();
    let end = 0;
    for (const region of sorted) {
      if (Math.floor(region / SHIFT) < end) throw new BulkError("two regions of the block share a byte");
      end = region % SHIFT;
    }
  }
}

const SHIFT = 2 ** 27;
