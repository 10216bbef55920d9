//! The BulkBlock format by example: the golden block, each field that can be wrong,
//! each limit, and the packing of an observation.

use ncp_spec::ErrorCode;
use ncp_spec::bulk::{
    Block, BulkError, Column, ColumnRef, DataRef, Dtype, MAX_BLOCK_LEN, MAX_COLUMNS, MAX_NAME_LEN, Region, encode,
    pack, pack_observation, unpack,
};
use ncp_spec::wire::Observation;

/// The block of chapter 5.1, byte for byte: `times` 1.5, 2.5, 9.0 and `senders` 7, 7, 9.
#[rustfmt::skip]
const GOLDEN: [u8; 104] = [
    0x4e, 0x43, 0x50, 0x42,  0x01,  0x00,  0x02, 0x00,  0x68, 0x00, 0x00, 0x00,
    0x2c, 0x00, 0x00, 0x00,  0x05, 0x00,  0x02,  0x00,  0x03, 0x00, 0x00, 0x00,  0x38, 0x00, 0x00, 0x00,
    0x31, 0x00, 0x00, 0x00,  0x07, 0x00,  0x04,  0x00,  0x03, 0x00, 0x00, 0x00,  0x50, 0x00, 0x00, 0x00,
    0x74, 0x69, 0x6d, 0x65, 0x73,  0x73, 0x65, 0x6e, 0x64, 0x65, 0x72, 0x73,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xf8, 0x3f,  0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x04, 0x40,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x22, 0x40,
    0x07, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,  0x07, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x09, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
];

/// The first byte of a column's directory entry, then the fields within an entry.
const fn entry(column: usize) -> usize {
    12 + 16 * column
}
const NAME_OFF: usize = 0;
const NAME_LEN: usize = 4;
const DTYPE: usize = 6;
const PAD: usize = 7;
const ROWS: usize = 8;
const DATA_OFF: usize = 12;

/// The golden block with some bytes replaced.
fn golden_with<const N: usize>(at: usize, bytes: [u8; N]) -> Vec<u8> {
    let mut block = GOLDEN.to_vec();
    block[at..at + N].copy_from_slice(&bytes);
    block
}

#[track_caller]
fn assert_rejected(block: &[u8], expected: &BulkError) {
    assert_eq!(Block::parse(block).err().as_ref(), Some(expected));
}

#[test]
fn the_golden_columns_encode_to_exactly_the_golden_bytes() {
    let borrowed = [ColumnRef::new("times", &[1.5, 2.5, 9.0][..]), ColumnRef::new("senders", &[7_i64, 7, 9][..])];
    let owned = [Column::new("times", vec![1.5, 2.5, 9.0]), Column::new("senders", vec![7_i64, 7, 9])];
    assert_eq!(encode(&borrowed).unwrap(), GOLDEN);
    assert_eq!(encode(&owned).unwrap(), GOLDEN);
    assert_eq!(pack(&[1.5, 2.5, 9.0], &[], &[7, 7, 9]).unwrap(), GOLDEN);
    let observation = Observation { times: vec![1.5, 2.5, 9.0], senders: vec![7, 7, 9], ..Observation::default() };
    assert_eq!(pack_observation(&observation).unwrap(), GOLDEN);
}

#[test]
fn the_golden_block_reads_as_its_two_columns_in_order() {
    let block = Block::parse(&GOLDEN).unwrap();
    assert_eq!(block.len(), 2);
    let [times, senders] = [block.column(0).unwrap(), block.column(1).unwrap()];
    assert!(block.column(2).is_none());

    assert_eq!((times.name(), times.dtype(), times.rows()), ("times", Dtype::F64, 3));
    assert_eq!(times.bytes(), &GOLDEN[0x38..0x50]);
    assert_eq!(times.iter::<f64>().unwrap().collect::<Vec<_>>(), [1.5, 2.5, 9.0]);
    assert_eq!(times.get::<f64>(2), Some(9.0));
    assert_eq!(times.get::<f64>(3), None);

    assert_eq!((senders.name(), senders.dtype(), senders.rows()), ("senders", Dtype::I64, 3));
    assert_eq!(senders.bytes(), &GOLDEN[0x50..]);
    assert_eq!(senders.to_vec::<i64>().unwrap(), [7, 7, 9]);

    let (index, found) = block.find("senders").unwrap();
    assert_eq!((index, found.name()), (1, "senders"));
    assert!(block.find("sender").is_none());
    assert_eq!(unpack(&GOLDEN).unwrap(), (vec![1.5, 2.5, 9.0], vec![], vec![7, 7, 9]));
}

#[test]
fn a_block_lends_the_bytes_that_it_was_read_from_and_is_empty_without_columns() {
    let block = Block::parse(&GOLDEN).unwrap();
    assert_eq!(block.bytes(), GOLDEN);
    assert!(!block.is_empty());
    let header = encode::<ColumnRef<'_>>(&[]).unwrap();
    let block = Block::parse(&header).unwrap();
    assert_eq!(block.bytes(), &header[..]);
    assert!(block.is_empty());
}

#[test]
fn shown_to_people_a_block_lists_its_columns_and_a_column_its_type_and_values() {
    let shown = format!("{:?}", Block::parse(&GOLDEN).unwrap());
    let (times, senders) = shown.split_once("senders").unwrap();
    assert!(times.contains("\"times\"") && times.contains("rows: 3"), "{shown}");
    assert!(senders.contains("rows: 3"), "{shown}");
    let whole = Column::new("x", vec![1_i32, -2]);
    assert_eq!(format!("{:?}", whole.data), "i32 [1, -2]");
    assert_eq!(Dtype::F64.to_string(), "f64");
    assert!(!whole.data.is_empty() && whole.data.len() == 2);
    assert!(Column::new("x", Vec::<f32>::new()).data.is_empty());
}

#[test]
fn a_view_gives_values_only_as_the_type_that_the_column_has() {
    let block = encode(&[ColumnRef::new("x", &[1_i64, 2][..])]).unwrap();
    let view = Block::parse(&block).unwrap().column(0).unwrap();
    assert_eq!(view.get::<i64>(1), Some(2));
    assert_eq!(view.get::<f64>(1), None);
    assert!(view.iter::<i32>().is_none());
    assert!(view.to_vec::<f32>().is_none());
    assert!(view.as_slice::<f64>().is_none());
}

#[test]
fn a_slice_is_lent_at_every_address_that_suits_the_type_and_values_are_read_at_all() {
    let block = encode(&[ColumnRef::new("x", &[1.5, -2.5][..])]).unwrap();
    let mut buffer = vec![0; block.len() + 16];
    for shift in 0..16 {
        let moved = &mut buffer[shift..shift + block.len()];
        moved.copy_from_slice(&block);
        let view = Block::parse(moved).unwrap().column(0).unwrap();
        let aligned = view.bytes().as_ptr().addr().is_multiple_of(align_of::<f64>());
        let lent = aligned && cfg!(target_endian = "little");
        assert_eq!(view.as_slice::<f64>().is_some(), lent, "shift {shift}");
        if let Some(slice) = view.as_slice::<f64>() {
            assert_eq!(slice, [1.5, -2.5]);
        }
        assert_eq!(view.to_vec::<f64>().unwrap(), [1.5, -2.5]);
        assert_eq!(view.get::<f64>(1), Some(-2.5));
    }
}

#[test]
fn a_column_without_rows_lends_an_empty_slice_at_any_address() {
    let mut block = encode(&[Column::new("x", Vec::<f64>::new())]).unwrap();
    for offset in 0..=block.len() as u32 {
        block[entry(0) + DATA_OFF..][..4].copy_from_slice(&offset.to_le_bytes());
        let view = Block::parse(&block).unwrap().column(0).unwrap();
        let lent = cfg!(target_endian = "little").then_some(&[][..]);
        assert_eq!(view.as_slice::<f64>(), lent, "offset {offset}");
    }
}

#[test]
fn a_block_without_columns_is_the_header_alone() {
    let block = encode::<Column>(&[]).unwrap();
    assert_eq!(block, *b"NCPB\x01\0\0\0\x0c\0\0\0");
    assert!(Block::parse(&block).unwrap().is_empty());
}

#[test]
fn a_column_without_rows_keeps_its_place_name_and_type() {
    let columns = [
        Column::new("first", Vec::<i32>::new()),
        Column::new("second", vec![3_f32]),
        Column::new("third", Vec::<f64>::new()),
    ];
    let block = encode(&columns).unwrap();
    assert_eq!(Block::parse(&block).unwrap().to_columns(), columns);
    assert_eq!(block.len() % 8, 0, "the last column begins at a multiple of 8 too");
}

#[test]
fn one_column_may_have_the_empty_name() {
    let columns = [Column::new("", vec![1_i32]), Column::new("x", vec![2_i32])];
    let block = encode(&columns).unwrap();
    assert_eq!(Block::parse(&block).unwrap().to_columns(), columns);
}

#[test]
fn every_type_is_written_little_endian_in_its_own_width() {
    let block = encode(&[
        ColumnRef::new("a", DataRef::F32(&[-1.5])),
        ColumnRef::new("b", DataRef::F64(&[-0.0])),
        ColumnRef::new("c", DataRef::I32(&[-2])),
        ColumnRef::new("d", DataRef::I64(&[i64::MIN + 1])),
    ])
    .unwrap();
    // 12 + 4 × 16 + 4 = 80 is a multiple of 8 already.
    #[rustfmt::skip]
    assert_eq!(block[80..], [
        0x00, 0x00, 0xc0, 0xbf,  0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0x80,
        0xfe, 0xff, 0xff, 0xff,  0, 0, 0, 0,
        1, 0, 0, 0, 0, 0, 0, 0x80,
    ]);
    assert_eq!([1, 2, 3, 4], Dtype::ALL.map(Dtype::code));
    assert_eq!([1, 2, 3, 4], [0, 1, 2, 3].map(|column| block[entry(column) + DTYPE]));
}

#[test]
fn a_buffer_shorter_than_the_header_is_rejected() {
    for len in 0..12 {
        assert_rejected(&GOLDEN[..len], &BulkError::HeaderTruncated { len });
    }
}

#[test]
fn a_wrong_magic_version_or_flag_is_rejected() {
    assert_rejected(&golden_with(0, *b"NCPb"), &BulkError::Magic { found: *b"NCPb" });
    assert_rejected(&golden_with(0, *b"BPCN"), &BulkError::Magic { found: *b"BPCN" });
    for found in [0, 2, 255] {
        assert_rejected(&golden_with(4, [found]), &BulkError::Version { found });
    }
    for found in [1, 0x80, 255] {
        assert_rejected(&golden_with(5, [found]), &BulkError::Flags { found });
    }
}

#[test]
fn a_total_length_other_than_the_buffers_is_rejected() {
    for stated in [0, 103, 105, u32::MAX] {
        assert_rejected(&golden_with(8, stated.to_le_bytes()), &BulkError::LengthMismatch { stated, len: 104 });
    }
    let longer = [&GOLDEN[..], &[0]].concat();
    assert_rejected(&longer, &BulkError::LengthMismatch { stated: 104, len: 105 });
    assert_rejected(&GOLDEN[..103], &BulkError::LengthMismatch { stated: 104, len: 103 });
}

#[test]
fn a_directory_that_does_not_fit_is_rejected() {
    assert_rejected(
        &golden_with(6, 6_u16.to_le_bytes()),
        &BulkError::DirectoryTruncated { columns: 6, end: 108, len: 104 },
    );
}

#[test]
fn fewer_columns_than_the_directory_has_room_for_leave_a_gap() {
    let one = golden_with(6, 1_u16.to_le_bytes());
    assert_eq!(Block::parse(&one).unwrap().to_columns(), [Column::new("times", vec![1.5, 2.5, 9.0])]);
}

#[test]
fn an_unknown_dtype_or_a_set_pad_byte_is_rejected() {
    for found in [0, 5, 255] {
        assert_rejected(&golden_with(entry(1) + DTYPE, [found]), &BulkError::UnknownDtype { column: 1, found });
    }
    assert_rejected(&golden_with(entry(0) + PAD, [1]), &BulkError::Pad { column: 0, found: 1 });
}

#[test]
fn a_name_that_leaves_the_block_is_rejected() {
    assert_rejected(
        &golden_with(entry(1) + NAME_OFF, 98_u32.to_le_bytes()),
        &BulkError::OutOfBounds { region: Region::Name(1), start: 98, end: 105, len: 104 },
    );
    assert_rejected(
        &golden_with(entry(0) + NAME_OFF, u32::MAX.to_le_bytes()),
        &BulkError::OutOfBounds { region: Region::Name(0), start: 0xffff_ffff, end: 0x1_0000_0004, len: 104 },
    );
}

#[test]
fn data_that_leaves_the_block_is_rejected_however_large_its_count() {
    assert_rejected(
        &golden_with(entry(1) + ROWS, 4_u32.to_le_bytes()),
        &BulkError::OutOfBounds { region: Region::Data(1), start: 80, end: 112, len: 104 },
    );
    // 2²⁹ rows of 8 bytes are 2³²: 0 to whoever multiplies in 32 bits.
    assert_rejected(
        &golden_with(entry(1) + ROWS, (1_u32 << 29).to_le_bytes()),
        &BulkError::OutOfBounds { region: Region::Data(1), start: 80, end: 80 + (1 << 32), len: 104 },
    );
    // −16 and 3 rows of 8 bytes end at 8 when offsets wrap.
    assert_rejected(
        &golden_with(entry(1) + DATA_OFF, 0xffff_fff0_u32.to_le_bytes()),
        &BulkError::OutOfBounds { region: Region::Data(1), start: 0xffff_fff0, end: 0x1_0000_0008, len: 104 },
    );
}

#[test]
fn a_name_or_data_within_header_or_directory_is_rejected() {
    for start in [0_u32, 11, 12, 43] {
        let in_directory = |region| BulkError::InDirectory { region, start: u64::from(start), directory_end: 44 };
        let name = golden_with(entry(0) + NAME_OFF, start.to_le_bytes());
        assert_rejected(&name, &in_directory(Region::Name(0)));
        let data = golden_with(entry(1) + DATA_OFF, start.to_le_bytes());
        assert_rejected(&data, &in_directory(Region::Data(1)));
    }
}

#[test]
fn a_block_whose_columns_overlap_is_rejected() {
    let overlap = |first, second, at| BulkError::Overlap { first, second, at };
    // The same data for both, then only the last byte.
    assert_rejected(
        &golden_with(entry(1) + DATA_OFF, 56_u32.to_le_bytes()),
        &overlap(Region::Data(0), Region::Data(1), 56),
    );
    assert_rejected(
        &golden_with(entry(1) + DATA_OFF, 79_u32.to_le_bytes()),
        &overlap(Region::Data(0), Region::Data(1), 79),
    );
    // The same name for both, then only its last byte.
    assert_rejected(
        &golden_with(entry(1) + NAME_OFF, 44_u32.to_le_bytes()),
        &overlap(Region::Name(0), Region::Name(1), 44),
    );
    assert_rejected(
        &golden_with(entry(0) + NAME_LEN, 6_u16.to_le_bytes()),
        &overlap(Region::Name(0), Region::Name(1), 49),
    );
    // A name in data.
    assert_rejected(
        &golden_with(entry(1) + NAME_OFF, 55_u32.to_le_bytes()),
        &overlap(Region::Name(1), Region::Data(0), 56),
    );
    // One region inside another, with a third one between their starts.
    assert_rejected(
        &golden_with(entry(0) + NAME_LEN, 60_u16.to_le_bytes()),
        &overlap(Region::Name(0), Region::Name(1), 49),
    );
}

#[test]
fn empty_regions_overlap_nothing_but_begin_within_the_block() {
    let mut block = golden_with(entry(1) + ROWS, 0_u32.to_le_bytes());
    for start in [0_u32, 12, 50, 60, 104] {
        block[entry(1) + DATA_OFF..][..4].copy_from_slice(&start.to_le_bytes());
        let columns = Block::parse(&block).unwrap().to_columns();
        assert_eq!(columns[1], Column::new("senders", Vec::<i64>::new()));
    }
    block[entry(1) + DATA_OFF..][..4].copy_from_slice(&105_u32.to_le_bytes());
    assert_rejected(&block, &BulkError::OutOfBounds { region: Region::Data(1), start: 105, end: 105, len: 104 });
}

#[test]
fn a_name_that_is_not_utf_8_is_rejected() {
    // A lone continuation byte, an overlong slash, a surrogate, a cut sequence.
    for (bytes, valid_up_to) in [(*b"ti\x80es", 2), (*b"t\xc0\xafes", 1), (*b"t\xed\xa0\x80s", 1), (*b"time\xc3", 4)] {
        assert_rejected(&golden_with(0x2c, bytes), &BulkError::NameNotUtf8 { column: 0, valid_up_to });
    }
    let sigma = golden_with(0x2c, *"t\u{3c3}ms".as_bytes().first_chunk::<5>().unwrap());
    assert_eq!(Block::parse(&sigma).unwrap().column(0).unwrap().name(), "t\u{3c3}ms");
}

#[test]
fn two_columns_of_one_name_are_rejected_and_refused() {
    let mut block = golden_with(0x2c, *b"xtimetime");
    block[entry(0) + NAME_OFF..][..6].copy_from_slice(&[0x2d, 0, 0, 0, 4, 0]);
    block[entry(1) + NAME_OFF..][..6].copy_from_slice(&[0x31, 0, 0, 0, 4, 0]);
    let duplicate = BulkError::DuplicateName { first: 0, second: 1 };
    assert_rejected(&block, &duplicate);

    // Equal in the first six bytes and in the length, or by zeros behind, is not equal.
    let column = |name: &str| Column::new(name, vec![0_i32]);
    let names = ["sender", "sender\0", "sender_a", "sender_b", "sende", "sende\0", ""];
    let mut columns = names.map(column).to_vec();
    assert!(encode(&columns).is_ok());
    columns.push(column("sender_a"));
    assert_eq!(encode(&columns), Err(BulkError::DuplicateName { first: 2, second: 7 }));
}

#[test]
fn four_thousand_and_ninety_six_columns_are_read_and_one_more_is_not() {
    let mut columns: Vec<_> = (0..MAX_COLUMNS as i32).map(|i| Column::new(format!("c{i}"), vec![i])).collect();
    let block = encode(&columns).unwrap();
    assert_eq!(Block::parse(&block).unwrap().to_columns(), columns);

    columns.push(Column::new("one more", vec![0]));
    let too_many = BulkError::TooManyColumns { columns: 4097 };
    assert_eq!(encode(&columns), Err(too_many.clone()));
    columns.resize(70_000, Column::new("", vec![0]));
    assert_eq!(encode(&columns), Err(BulkError::TooManyColumns { columns: 70_000 }));

    // With room for all of the 4,097 entries.
    let mut stated = vec![0; 12 + 16 * 4097];
    stated[..8].copy_from_slice(b"NCPB\x01\0\x01\x10");
    let len = stated.len() as u32;
    stated[8..12].copy_from_slice(&len.to_le_bytes());
    assert_rejected(&stated, &too_many);
    assert_eq!(too_many.code(), ErrorCode::Limit);
}

#[test]
fn a_block_of_64_mib_is_read_and_written_and_one_byte_more_is_not() {
    // 12 + 16 + 4 bytes are 32: one f64 column may have 32 bytes less than the limit.
    let mut values = vec![0.25_f64; (MAX_BLOCK_LEN - 32) / 8];
    let mut block = encode(&[ColumnRef::new("full", &values[..])]).unwrap();
    assert_eq!(block.len(), MAX_BLOCK_LEN);
    assert_eq!(Block::parse(&block).unwrap().column(0).unwrap().rows(), values.len());

    values.push(0.25);
    let too_long = BulkError::TooLong { len: MAX_BLOCK_LEN as u64 + 8 };
    assert_eq!(encode(&[ColumnRef::new("full", &values[..])]), Err(too_long));

    block.push(0);
    let len = block.len() as u32;
    block[8..12].copy_from_slice(&len.to_le_bytes());
    let too_long = BulkError::TooLong { len: MAX_BLOCK_LEN as u64 + 1 };
    assert_rejected(&block, &too_long);
    assert_eq!(too_long.code(), ErrorCode::Limit);
}

#[test]
fn columns_that_share_their_memory_count_each_time_when_a_block_is_measured() {
    let shared = vec![0_i64; 1 << 20];
    let names: Vec<_> = (0..MAX_COLUMNS).map(|i| i.to_string()).collect();
    let columns: Vec<_> = names.iter().map(|name| ColumnRef::new(name, &shared[..])).collect();
    assert!(matches!(encode(&columns), Err(BulkError::TooLong { .. })));
}

#[test]
fn a_name_of_65535_bytes_is_written_and_one_more_is_refused() {
    let column = |len| Column::new("n".repeat(len), vec![1_i32]);
    let longest = [column(MAX_NAME_LEN)];
    let block = encode(&longest).unwrap();
    assert_eq!(Block::parse(&block).unwrap().to_columns(), longest);
    assert_eq!(
        encode(&[Column::new("x", vec![1_i32]), column(65_536)]),
        Err(BulkError::NameTooLong { column: 1, len: 65_536 })
    );
}

#[test]
fn names_alone_can_fill_a_block_beyond_its_limit() {
    let columns: Vec<_> = (0..1100).map(|i| Column::new(format!("{i:>MAX_NAME_LEN$}"), vec![0_i32])).collect();
    assert!(matches!(encode(&columns), Err(BulkError::TooLong { .. })));
    assert!(encode(&columns[..1000]).is_ok());
}

#[test]
fn packing_writes_a_column_for_each_array_that_is_not_empty() {
    let packed = |times: &[f64], values: &[f64], senders: &[i64]| {
        Block::parse(&pack(times, values, senders).unwrap()).unwrap().to_columns()
    };
    let times = || Column::new("times", vec![1.0, 2.0]);
    let values = || Column::new("values", vec![-65.0, f64::NAN]);
    let senders = || Column::new("senders", vec![1_i64, i64::MAX]);
    assert_eq!(packed(&[1.0, 2.0], &[-65.0, f64::NAN], &[1, i64::MAX]), [times(), values(), senders()]);
    assert_eq!(packed(&[1.0, 2.0], &[-65.0, f64::NAN], &[]), [times(), values()]);
    assert_eq!(packed(&[], &[-65.0, f64::NAN], &[1, i64::MAX]), [values(), senders()]);
    assert_eq!(packed(&[], &[], &[1, i64::MAX]), [senders()]);
    assert_eq!(packed(&[], &[], &[]), []);
}

#[test]
fn arrays_that_are_there_must_agree_in_length() {
    let differ =
        |first, first_rows, second, second_rows| BulkError::RowsDiffer { first, first_rows, second, second_rows };
    assert_eq!(pack(&[1.0], &[1.0, 2.0], &[]), Err(differ("times", 1, "values", 2)));
    assert_eq!(pack(&[1.0], &[], &[1, 2]), Err(differ("times", 1, "senders", 2)));
    assert_eq!(pack(&[], &[1.0], &[1, 2]), Err(differ("values", 1, "senders", 2)));
    assert_eq!(pack(&[1.0], &[1.0], &[1, 2]), Err(differ("times", 1, "senders", 2)));

    let block = encode(&[
        Column::new("senders", vec![1_i64, 2]),
        Column::new("values", vec![0.5]),
        Column::new("times", Vec::<f64>::new()),
    ])
    .unwrap();
    assert_eq!(unpack(&block), Err(differ("values", 1, "senders", 2)));
}

#[test]
fn unpacking_takes_the_three_columns_in_any_order_and_ignores_others() {
    let block = encode(&[
        Column::new("senders", vec![4_i64, 5]),
        Column::new("Times", vec![0_i32; 7]),
        Column::new("values", Vec::<f64>::new()),
        Column::new("times", vec![0.5, 1.5]),
        Column::new("", vec![0_f32; 3]),
    ])
    .unwrap();
    assert_eq!(unpack(&block).unwrap(), (vec![0.5, 1.5], vec![], vec![4, 5]));
}

#[test]
fn unpacking_rejects_a_column_of_another_type_than_the_packed_one() {
    for (name, data, expected) in [
        ("times", DataRef::F32(&[1.0]), Dtype::F64),
        ("values", DataRef::I64(&[1]), Dtype::F64),
        ("senders", DataRef::I32(&[1]), Dtype::I64),
        ("senders", DataRef::F64(&[]), Dtype::I64),
    ] {
        let block = encode(&[ColumnRef::new("other", &[0_i32][..]), ColumnRef { name, data }]);
        let error = unpack(&block.unwrap()).unwrap_err();
        assert_eq!(error, BulkError::ColumnDtype { column: 1, name, expected, found: data.dtype() });
        assert_eq!(error.code(), ErrorCode::Block);
    }
}

#[test]
fn equality_of_columns_is_that_of_their_bits() {
    let nan = |bits| Column::new("x", vec![f64::from_bits(bits)]);
    assert_eq!(nan(0x7ff8_0000_0000_0001), nan(0x7ff8_0000_0000_0001));
    assert_ne!(nan(0x7ff8_0000_0000_0001), nan(0x7ff8_0000_0000_0002));
    assert_ne!(Column::new("x", vec![0.0]), Column::new("x", vec![-0.0]));
    assert_ne!(Column::new("x", vec![0_i32]), Column::new("x", vec![0_f32]));
    assert_ne!(Column::new("x", Vec::<i32>::new()), Column::new("x", Vec::<f32>::new()));
}

#[test]
fn an_error_names_the_column_and_the_numbers() {
    let message = |at, bytes: [u8; 4]| Block::parse(&golden_with(at, bytes)).unwrap_err().to_string();
    assert_eq!(
        message(entry(1) + DATA_OFF, 79_u32.to_le_bytes()),
        "the data of column 0 and the data of column 1 share the byte at 79"
    );
    assert_eq!(
        message(entry(0) + NAME_OFF, 101_u32.to_le_bytes()),
        "the name of column 0 takes bytes 101 to 106, the block ends at 104"
    );
    assert_eq!(message(0, *b"RIFF"), "the magic is [52, 49, 46, 46], not \"NCPB\"");
}
