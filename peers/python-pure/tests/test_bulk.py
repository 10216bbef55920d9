import random
import unittest

import ncp_pure as ncp
from ncp_pure.bulk import Column, decode, encode

GOLDEN = bytes.fromhex(
    "4e435042 01 00 0200 68000000"
    "2c000000 0500 02 00 03000000 38000000"
    "31000000 0700 04 00 03000000 50000000"
    "74696d6573 73656e64657273"
    "000000000000f83f 0000000000000440 0000000000002240"
    "0700000000000000 0700000000000000 0900000000000000"
)


class Blocks(unittest.TestCase):
    def test_the_golden_observation_makes_the_golden_block(self):
        block = ncp.observation.pack([1.5, 2.5, 9.0], [], [7, 7, 9])
        self.assertEqual(block, GOLDEN)
        self.assertEqual(ncp.observation.unpack(block), ([1.5, 2.5, 9.0], [], [7, 7, 9]))

    def test_random_columns_come_back_as_they_were(self):
        source = random.Random(1)
        for _ in range(500):
            columns = []
            for i in range(source.randrange(5)):
                dtype = source.choice(["f32", "f64", "i32", "i64"])
                data = [source.randrange(-1000, 1000) for _ in range(source.randrange(5))]
                columns.append((f"é{i}", dtype, data))
            back = [(name, dtype, list(data)) for name, dtype, data in decode(encode(columns))]
            self.assertEqual(back, columns)

    def test_an_altered_block_is_read_or_rejected_and_gives_no_more_than_it_holds(self):
        source = random.Random(2)
        rejected = 0
        for _ in range(5000):
            block = bytearray(GOLDEN)
            for _ in range(source.randrange(1, 4)):
                block[source.randrange(len(block))] = source.choice([0, 1, 8, 0x38, 0x7F, 0xFF])
            try:
                columns = decode(block)
            except ncp.BulkError:
                rejected += 1
            else:
                self.assertLessEqual(sum(len(c.data) * c.data.itemsize for c in columns), len(block))
        self.assertGreater(rejected, 1000)

    def test_columns_that_share_their_bytes_are_rejected(self):
        shared = bytearray(GOLDEN)
        shared[0x28:0x2C] = shared[0x18:0x1C]
        with self.assertRaisesRegex(ncp.BulkError, "share"):
            decode(shared)

    def test_a_column_that_reaches_beyond_the_block_is_rejected(self):
        for offset, value in ((0x24, 4), (0x28, 0x51), (0x20, 0x100)):
            beyond = bytearray(GOLDEN)
            beyond[offset : offset + 2] = value.to_bytes(2, "little")
            with self.subTest(offset=offset), self.assertRaises(ncp.BulkError):
                decode(beyond)

    def test_padding_puts_each_column_at_a_multiple_of_eight(self):
        block = encode([Column("abc", "f32", [1.0]), Column("", "f64", [2.0])])
        self.assertEqual(block[12 + 32 + 3 :], bytes(1) + b"\0\0\x80\x3f" + bytes(4) + b"\0" * 7 + b"\x40")

    def test_what_does_not_fit_its_field_is_refused_and_not_cut_off(self):
        for columns in (
            [Column("a" * 65_536, "f64", [])],
            [Column(str(i), "f64", []) for i in range(4097)],
            [Column("a", "i32", [1 << 31])],
            [Column("a", "i64", [1 << 63])],
            [Column("a", "f32", [1e39])],
            [Column("a", "f64", [0.0] * (8 << 20))],
            [Column("a", "f64", []), Column("a", "f64", [])],
        ):
            with self.subTest(column=columns[0].name[:3]), self.assertRaises(ncp.BulkError):
                encode(columns)


if __name__ == "__main__":
    unittest.main()
