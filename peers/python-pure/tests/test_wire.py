import json
import random
import unittest
from pathlib import Path
from unittest import mock

import ncp_pure as ncp
from ncp_pure import jsontext

from . import samples

PROTO = Path(__file__).parents[3] / "proto" / "ncp.proto"


def command(members):
    return b'{"kind":"command_frame",' + members + b"}"


class Frames(unittest.TestCase):
    def test_every_message_reads_back_as_what_was_written(self):
        source = random.Random(1)
        for kind, frame in ncp.FRAMES.items():
            for _ in range(60):
                message = samples.message(source, frame)
                text = ncp.encode(message)
                # repr tells -0.0 from 0.0, which == does not.
                self.assertEqual(repr(ncp.decode(kind, text)), repr(message))

    def test_the_entries_of_a_map_are_written_by_code_points(self):
        frame = ncp.SensorFrame(channels={"😀": ncp.ChannelValue(), "～": ncp.ChannelValue()})
        self.assertEqual(list(json.loads(ncp.encode(frame))["channels"]), ["～", "😀"])

    def test_a_truncated_or_altered_frame_is_read_or_rejected_and_never_a_crash(self):
        source = random.Random(2)
        rejected = 0
        for _ in range(4000):
            kind, frame = source.choice(list(ncp.FRAMES.items()))
            text = bytearray(ncp.encode(samples.message(source, frame)))
            text[source.randrange(len(text))] = source.choice(b'\x00"\\{}[],:-0e\xff')
            try:
                ncp.decode(kind, text[: source.choice([len(text), source.randrange(len(text))])])
            except ncp.DecodeError:
                rejected += 1
        self.assertGreater(rejected, 1000)

    def test_a_program_that_names_no_mode_means_active_and_a_frame_without_one_holds(self):
        self.assertEqual(ncp.CommandFrame().mode, "active")
        self.assertEqual(ncp.decode("command_frame", command(b'"seq":1')).mode, "hold")

    def test_a_message_that_every_receiver_would_reject_is_not_written(self):
        for message in (
            ncp.CommandFrame(t=float("nan")),
            ncp.CommandFrame(mode="dance"),
            ncp.CommandFrame(seq=2**53),
            ncp.CommandFrame(seq=1.0),
            ncp.SensorFrame(channels={"a": ncp.ChannelValue(data=[float("inf")])}),
            ncp.SensorFrame(frame_id="\ud800"),
            ncp.CloseSession(session_id="a/b"),
            ncp.ObservationFrame(session_id="a", is_simulation_output=False),
            ncp.RunRequest(session_id="a", duration_ms=1, stimulus=ncp.StimulusFrame(session_id="b")),
            ncp.ControlStatus(note="x" * (1 << 20)),
        ):
            with self.subTest(message=repr(message)[:80]), self.assertRaises(ncp.EncodeError):
                ncp.encode(message)

    def test_the_contract_hash_is_that_of_the_schema(self):
        self.assertEqual(ncp.hash_of(PROTO.read_text("utf-8")), ncp.CONTRACT_HASH)

    def test_version_and_hash_are_those_of_the_text(self):
        text = json.loads(PROTO.with_name("projection.json").read_text("utf-8"))
        self.assertEqual((ncp.WIRE_VERSION, ncp.CONTRACT_HASH), (text["wire"], text["contract_hash"]))


class Reading(unittest.TestCase):
    def test_the_fast_way_to_read_numbers_reads_them_as_the_exact_way_does(self):
        source = random.Random(3)
        spellings = ["0", "-0", "-0.0", "1e308", "1e309", "-1E+0400", "1e-400", "9" * 309, "1" + "0" * 400]
        spellings += ["0." + "0" * 300 + "1e310", "1e00000001", "123456789012345678901234567890"]
        for _ in range(3000):
            items = [source.choice(spellings + [repr(samples.double(source))]) for _ in range(3)]
            frame = f'{{"kept":[{",".join(items)}]}}'.encode()
            self.assertEqual(self.read(frame), self.read(frame, exactly=True), frame)

    def read(self, frame, exactly=False):
        try:
            with mock.patch.object(jsontext, "_is_plain", lambda _: False) if exactly else mock.MagicMock():
                return repr(jsontext.read_object(frame))
        except ncp.DecodeError as error:
            return error.code

    def test_brackets_within_strings_are_no_levels(self):
        deep = b'{"a":"' + b"[" * 100 + b'\\"[","b":' + b"[" * 63 + b"]" * 63 + b"}"
        self.assertIn("b", jsontext.read_object(deep))
        with self.assertRaisesRegex(ncp.DecodeError, "levels"):
            jsontext.read_object(b'{"b":' + b"[" * 64 + b"]" * 64 + b"}")

    def test_a_string_that_breaks_off_is_looked_at_once(self):
        with self.assertRaisesRegex(ncp.DecodeError, "Unterminated"):
            jsontext.read_object(b'{"a":"' + b"[" * 100 + b'\\"' * (1 << 19))

    def test_a_million_levels_are_an_error_and_no_overflow(self):
        with self.assertRaisesRegex(ncp.DecodeError, "levels"):
            jsontext.read_object(b'{"a":' * 1_000_000)


class Keys(unittest.TestCase):
    def test_a_pattern_covers_what_a_search_through_all_coverings_finds(self):
        source = random.Random(4)
        for _ in range(5000):
            pattern = [source.choice(["a", "*", "**", "$*b", "a$*", "@a", "a$*a$*", "$*b$*b"]) for _ in range(3)]
            key = [source.choice(["a", "ab", "b", "@a", "aab", "aabb"]) for _ in range(source.randrange(1, 4))]
            with self.subTest(pattern=pattern, key=key):
                self.assertEqual(ncp.matches("/".join(pattern), "/".join(key)), covers(pattern, key))


def covers(pattern, key):
    """The table of section 3.4, word for word."""
    if not pattern:
        return not key
    if pattern[0] == "**":
        return covers(pattern[1:], key) or (bool(key) and key[0][0] != "@" and covers(pattern, key[1:]))
    return bool(key) and within(pattern[0], key[0]) and covers(pattern[1:], key[1:])


def within(chunk, part):
    if part[0] == "@" or "*" not in chunk:
        return chunk == part

    def run(wild, rest):
        if wild.startswith("$*"):
            return any(run(wild[2:], rest[i:]) for i in range(len(rest) + 1))
        return wild == rest if not wild or not rest else wild[0] == rest[0] and run(wild[1:], rest[1:])

    return chunk == "*" or run(chunk, part)


if __name__ == "__main__":
    unittest.main()
