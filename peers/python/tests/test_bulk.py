"""BulkBlocks to and from arrays."""

import array
import random
import struct
import subprocess
import sys
import unittest

import ncp
import numpy

DTYPES = {"f32": numpy.float32, "f64": numpy.float64, "i32": numpy.int32, "i64": numpy.int64}
NAMES = {numpy.dtype(dtype).name: name for name, dtype in DTYPES.items()}


def block_of(name_off, data_off, total, rows=2, dtype=2, n_cols=1, name=b"x"):
    """A block with one column of f64, laid out by hand."""
    head = struct.pack("<4sBBHI", b"NCPB", 1, 0, n_cols, total)
    entry = struct.pack("<IHBBII", name_off, len(name), dtype, 0, rows, data_off)
    block = bytearray(total)
    block[: len(head + entry)] = head + entry
    block[name_off : name_off + len(name)] = name
    values = struct.pack(f"<{rows}d", *range(1, rows + 1))
    block[data_off : data_off + len(values)] = values
    return bytes(block)


class RoundTrips(unittest.TestCase):
    def test_any_columns_come_back_with_their_types_order_and_bits(self):
        draw = random.Random(5)
        for _ in range(200):
            columns = {}
            for nth in range(draw.randrange(12)):
                dtype = numpy.dtype(draw.choice(list(DTYPES.values())))
                raw = draw.randbytes(draw.choice((0, 1, 3, 1000)) * dtype.itemsize)
                columns["ä" * draw.randrange(3) + str(nth)] = numpy.frombuffer(raw, dtype)
            block = ncp.bulk_encode(columns)
            found = ncp.bulk_decode(block)
            self.assertEqual(list(found), list(columns))
            for name, values in columns.items():
                self.assertEqual(found[name].dtype, values.dtype)
                self.assertEqual(found[name].tobytes(), values.tobytes())
            views = ncp.bulk_views(block)
            self.assertEqual([view.values.tobytes() for view in views.values()], [v.tobytes() for v in columns.values()])
            self.assertEqual([view.dtype for view in views.values()], [NAMES[v.dtype.name] for v in columns.values()])

    def test_the_golden_block_lies_as_published(self):
        block = ncp.bulk_encode({"times": numpy.array([1.5, 2.5, 9.0]), "senders": numpy.array([7, 7, 9])})
        self.assertEqual(len(block), 104)
        self.assertEqual(block[0x2C:0x38], b"timessenders")
        self.assertEqual(struct.unpack_from("<3d", block, 0x38), (1.5, 2.5, 9.0))
        self.assertEqual(struct.unpack_from("<3q", block, 0x50), (7, 7, 9))
        self.assertEqual(ncp.observation_pack(array.array("d", [1.5, 2.5, 9.0]), array.array("d"), array.array("q", [7, 7, 9])), block)

    def test_an_observation_comes_back(self):
        arrays = (numpy.array([1.0, 2.0]), numpy.array([numpy.nan, -0.0]), numpy.array([], "i8"))
        found = ncp.observation_unpack(ncp.observation_pack(*arrays))
        for given, back in zip(arrays, found):
            self.assertEqual((given.dtype, given.tobytes()), (back.dtype, back.tobytes()))

    def test_strided_and_reversed_arrays_are_written_as_they_read(self):
        values = numpy.arange(10, dtype="f4")
        block = ncp.bulk_encode([("a", values[::3]), ("b", values[::-1])])
        found = ncp.bulk_decode(block)
        self.assertEqual(found["a"].tolist(), [0, 3, 6, 9])
        self.assertEqual(found["b"].tolist(), values.tolist()[::-1])


class Views(unittest.TestCase):
    def test_an_aligned_column_shares_the_memory_of_the_block(self):
        block = ncp.bulk_encode({"a": numpy.arange(100.0), "b": numpy.arange(3, dtype="i4")})
        memory = numpy.frombuffer(block, "u1")
        for values in ncp.bulk_decode(block).values():
            self.assertTrue(numpy.shares_memory(values, memory))
            self.assertTrue(values.flags.aligned)
            self.assertFalse(values.flags.writeable)
            with self.assertRaises(ValueError):
                values[0] = 1
        for column in ncp.bulk_views(block).values():
            self.assertTrue(numpy.shares_memory(numpy.asarray(column.values), memory))
            self.assertTrue(column.values.readonly)

    def test_a_column_that_lies_unaligned_is_copied(self):
        block = block_of(name_off=28, data_off=29, total=45)
        values = ncp.bulk_decode(block)["x"]
        self.assertEqual(values.tolist(), [1.0, 2.0])
        self.assertTrue(values.flags.aligned)
        self.assertFalse(values.flags.writeable)
        self.assertFalse(numpy.shares_memory(values, numpy.frombuffer(block, "u1")))
        self.assertEqual(ncp.bulk_views(block)["x"].values.tolist(), [1.0, 2.0])

    def test_a_buffer_that_changes_later_changes_no_column(self):
        for kind in (bytearray, lambda block: memoryview(bytearray(block))):
            buffer = kind(ncp.bulk_encode({"a": numpy.arange(4.0)}))
            values, view = ncp.bulk_decode(buffer)["a"], ncp.bulk_views(buffer)["a"].values
            memoryview(buffer).cast("B")[-8:] = b"\xff" * 8
            self.assertEqual((values[3], view[3]), (3.0, 3.0))

    def test_the_views_keep_the_block_alive(self):
        values = ncp.bulk_decode(ncp.bulk_encode({"a": numpy.arange(1000.0)}))["a"]
        junk = [bytes(8100) for _ in range(100)]
        self.assertEqual((values[999], len(junk)), (999.0, 100))


class Refusals(unittest.TestCase):
    def test_columns_that_overlap_are_refused(self):
        # [NCP-BULK-012] The name lies within the data.
        with self.assertRaises(ncp.NcpError) as caught:
            ncp.bulk_decode(block_of(name_off=30, data_off=28, total=44))
        self.assertEqual(caught.exception.code, "block")

    def test_a_count_beyond_the_block_allocates_nothing(self):
        block = bytearray(block_of(name_off=28, data_off=32, total=48))
        block[20:24] = struct.pack("<I", 2**32 - 1)
        with self.assertRaises(ncp.NcpError):
            ncp.bulk_decode(block)

    def test_an_array_of_another_type_is_no_column(self):
        for values in (
            [1.0],
            1.0,
            "text",
            None,
            b"raw",
            numpy.arange(3, dtype="u4"),
            numpy.arange(3, dtype="i2"),
            numpy.arange(3, dtype=">f8"),
            numpy.zeros(3, "?"),
            numpy.zeros(3, "f2"),
            numpy.zeros(3, "c8"),
            numpy.zeros((2, 2)),
            numpy.float64(1.0),
            numpy.zeros(3, "M8[s]"),
            numpy.array(["a"], dtype=object),
        ):
            with self.subTest(repr(values)), self.assertRaises(TypeError):
                ncp.bulk_encode({"a": values})

    def test_two_equal_names_are_refused(self):
        with self.assertRaises(ncp.NcpError) as caught:
            ncp.bulk_encode([("a", numpy.zeros(1)), ("a", numpy.zeros(1))])
        self.assertEqual(caught.exception.code, "block")

    def test_arrays_of_an_observation_agree_in_length_and_type(self):
        two, three = numpy.zeros(2), numpy.zeros(3)
        with self.assertRaises(ncp.NcpError):
            ncp.observation_pack(two, three, numpy.zeros(0, "i8"))
        with self.assertRaises(TypeError):
            ncp.observation_pack(two, two, two)
        with self.assertRaises(ncp.NcpError):
            ncp.observation_unpack(ncp.bulk_encode({"times": numpy.zeros(2, "f4")}))


class WithoutNumpy(unittest.TestCase):
    def test_the_module_works_without_numpy_but_for_arrays_of_it(self):
        program = """
import sys
sys.modules["numpy"] = None
import array, ncp
block = ncp.bulk_encode({"a": array.array("d", [1.0, 2.0]), "b": array.array("q", [3])})
print(ncp.bulk_views(block)["b"].values.tolist())
try:
    ncp.bulk_decode(block)
except ImportError:
    print("no arrays")
packed = ncp.observation_pack(array.array("d", [1.5]), array.array("d"), array.array("q", [7]))
print([view.tolist() for view in ncp.observation_views(packed)])
"""
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.split("\n"), ["[3]", "no arrays", "[[1.5], [], [7]]", ""])


if __name__ == "__main__":
    unittest.main()
