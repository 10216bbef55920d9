//! How fast a BulkBlock is read and written.
//!
//! Views are timed; owned decoding and encoding are compared with copying the same
//! bytes into a fresh vector, in the same run: the two take turns, sample by sample,
//! both allocate their output and free it. What counts is the median sample.
//!
//! `cargo bench -p ncp-spec --bench bulk`; without `--bench` (as under `cargo test`)
//! every measurement runs once, to see that it works.

use std::hint::black_box;

use ncp_spec::bulk::{Block, BulkError, ColumnRef, MAX_BLOCK_LEN, encode, unpack};

use paired::Bench;

mod paired;

fn main() -> Result<(), BulkError> {
    let bench = Bench::from_args();
    views(&bench)?;
    copies(&bench)
}

/// A view costs the same whatever the number of rows.
fn views(bench: &Bench) -> Result<(), BulkError> {
    let few = three_columns(10, 10)?;
    // Header, directory and names ("times", "values", "senders") take 80 bytes.
    let most_rows = (MAX_BLOCK_LEN - 80) / 24;
    let most = three_columns(most_rows, most_rows)?;
    let long = {
        let (long, rest) = (vec![0.5_f32; 10_000_000], vec![0.5_f64; 1_400_000]);
        encode(&[
            ColumnRef::new("values", &long[..]),
            ColumnRef::new("times", &rest[..]),
            ColumnRef::new("senders", &vec![7_i64; 1_400_000][..]),
        ])?
    };
    println!(
        "note   10 million rows of three 8-byte columns (240 MB) are over the limit of 64 MiB; \
         the largest legal block has {most_rows} rows, and one with a 10-million-row f32 column \
         has {} bytes",
        long.len()
    );

    let view = |block: &[u8]| -> usize {
        Block::parse(black_box(block)).map_or(0, |block| block.columns().map(|c| c.rows()).sum())
    };
    let aim = "(aim < 200 ns)";
    let few_time = bench.time(|| view(&few));
    print_time("bulk/view-3-columns, 10 rows", few_time, aim);
    let most_time = bench.time(|| view(&most));
    print_time(&format!("bulk/view-3-columns, {most_rows} rows"), most_time, aim);
    let long_time = bench.time(|| view(&long));
    print_time("bulk/view-3-columns, 10 million rows in one", long_time, aim);
    let ratio = long_time.max(most_time) / few_time;
    println!("ratio  bulk/view-3-columns, most rows vs 10 rows  {ratio:.2} (aim 1: the same time)");

    let names: Vec<_> = (0..4096).map(|column| format!("column {column}")).collect();
    let columns: Vec<_> = names.iter().map(|name| ColumnRef::new(name, &[0.5_f64][..])).collect();
    let wide = encode(&columns)?;
    print_time("bulk/view-4096-columns", bench.time(|| view(&wide)), "");
    Ok(())
}

/// Owned decoding and encoding against memcpy.
fn copies(bench: &Bench) -> Result<(), BulkError> {
    const ROWS: usize = 1_000_000;
    let values: Vec<f64> = (0..ROWS).map(|row| row as f64 * 0.1).collect();
    let columns = [ColumnRef::new("values", &values[..])];
    let block = encode(&columns)?;
    let bytes = block[block.len() - 8 * ROWS..].to_vec();
    // One byte further on, so that no value is aligned.
    let shifted = [&[0], &block[..]].concat();
    let aim = "aim ≤ 1.25: 0.80 of memcpy speed";

    bench.ratio("bulk/encode-1M-f64", "memcpy", aim, || encode(&columns), || bytes.to_vec());
    let decode = |block: &[u8]| Block::parse(block).map(|block| block.to_columns());
    bench.ratio("bulk/decode-1M-f64", "memcpy", aim, || decode(&block), || bytes.to_vec());
    bench.ratio("bulk/decode-1M-f64, unaligned", "memcpy", aim, || decode(&shifted[1..]), || bytes.to_vec());

    let third = three_columns(ROWS / 3, ROWS / 3)?;
    let bytes = third[80..].to_vec();
    bench.ratio("bulk/unpack-observation-8MB", "memcpy", aim, || unpack(&third), || bytes.to_vec());
    Ok(())
}

fn three_columns(rows: usize, senders: usize) -> Result<Vec<u8>, BulkError> {
    let (floats, integers) = (vec![0.5; rows], vec![7_i64; senders]);
    encode(&[
        ColumnRef::new("times", &floats[..]),
        ColumnRef::new("values", &floats[..]),
        ColumnRef::new("senders", &integers[..]),
    ])
}

fn print_time(name: &str, seconds: f64, aim: &str) {
    println!("time   {name}  {:.1} ns {aim}", seconds * 1e9);
}
