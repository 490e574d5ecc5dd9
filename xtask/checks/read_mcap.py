"""Reads recordings with the MCAP project's own Python reader, which shares no code with this workspace.

Usage: python read_mcap.py FILE.mcap ...   (mcap 1.6.0, mcap-protobuf-support 0.6.0)

Checked for each file: every CRC; every message decodes by the schema in the file; the counts of the summary are those of
the messages; log times never fall, neither over all topics nor within one; no number is NaN or infinite; topics,
metadata and attachments are there. Exit code 1 names the file and what is wrong with it.
"""

import collections
import hashlib
import math
import sys

from mcap.reader import SeekingReader
from mcap_protobuf.decoder import DecoderFactory

TOPICS = ["/bearing/balls", "/bearing/contacts", "/bearing/geometry", "/bearing/state", "/tf"]
ATTACHMENTS = ["case.ron", "tribodyn.json"]
METADATA = "simulation"


class Wrong(Exception):
    """A recording that is not what it should be."""


def require(condition, message):
    if not condition:
        raise Wrong(message)


def numbers(message):
    """Every floating-point number of a decoded message, nested ones included."""
    for field, value in message.ListFields():
        several = value if isinstance(value, collections.abc.Sequence) and not isinstance(value, (str, bytes)) else [value]
        for one in several:
            if isinstance(one, float):
                yield field.name, one
            elif hasattr(one, "ListFields"):
                yield from numbers(one)


def check(path):
    with open(path, "rb") as stream:
        reader = SeekingReader(stream, validate_crcs=True, decoder_factories=[DecoderFactory()])
        summary = reader.get_summary()
        require(summary is not None and summary.statistics is not None, "no summary with statistics")
        statistics = summary.statistics
        counts = collections.Counter()
        last = -1
        span = [None, None]
        digest = hashlib.sha256()
        for _schema, channel, record, message in reader.iter_decoded_messages():
            require(record.log_time >= last, f"{channel.topic}: log time {record.log_time} after {last}")
            last = record.log_time
            span = [record.log_time if span[0] is None else span[0], record.log_time]
            require(record.sequence == counts[channel.id], f"{channel.topic}: sequence {record.sequence}, expected {counts[channel.id]}")
            counts[channel.id] += 1
            digest.update(record.data)
            for name, value in numbers(message):
                require(math.isfinite(value), f"{channel.topic}: {name} is {value}")
        total = sum(counts.values())
        require(total == statistics.message_count, f"{total} messages, the summary says {statistics.message_count}")
        require(dict(counts) == {k: v for k, v in statistics.channel_message_counts.items() if v}, "counts by channel differ")
        require(span == [statistics.message_start_time, statistics.message_end_time], "first or last log time differs")
        topics = {summary.channels[channel].topic: count for channel, count in counts.items()}
        missing = [topic for topic in TOPICS if topic not in topics]
        require(not missing, f"no message on {', '.join(missing)}")
        require(topics["/bearing/state"] == topics["/bearing/balls"], "states and balls differ in number")
        attachments = {a.name: a.data for a in reader.iter_attachments()}
        require(len(attachments) == statistics.attachment_count, "attachments differ from the summary")
        absent = [name for name in ATTACHMENTS if not attachments.get(name)]
        require(not absent, f"no attachment {', '.join(absent)}")
        metadata = {m.name: m.metadata for m in reader.iter_metadata()}
        require(METADATA in metadata, f"no metadata record {METADATA}")
    seconds = (span[1] - span[0]) * 1e-9
    return f"{total} messages on {len(topics)} topics over {seconds:.6f} s, {len(attachments)} attachments, payload {digest.hexdigest()[:16]}"


def main(paths):
    if not paths:
        print("no file named", file=sys.stderr)
        return 2
    failed = 0
    for path in paths:
        try:
            print(f"{path}: {check(path)}")
        except Exception as error:  # a reader's own errors too: each file gets its line
            print(f"{path}: {type(error).__name__}: {error}", file=sys.stderr)
            failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
