"""Reads recordings with the MCAP project's own Python reader, which shares no code with this workspace.

Usage: python read_mcap.py FILE.mcap ...   (mcap 1.6.0, mcap-protobuf-support 0.6.0)

Checked for each file: every CRC; every message decodes by the schema in the file; the counts of the summary are those of
the messages; no chunk is without messages, and the chunk indexes, from which viewers take the time span, have the first
and the last log time; log times never fall, neither over all topics nor within one; no number is NaN or infinite; topics,
metadata and attachments are there. A quasi-static solution has balls with every state, a transient run with some of them;
both have their time in the message as in its record. A recovered file may lack messages: those that it has must be in
order. Exit code 1 names the file and what is wrong with it.
"""

import collections
import hashlib
import math
import sys

from mcap.reader import SeekingReader
from mcap_protobuf.decoder import DecoderFactory

SOLUTION_TOPICS = ["/bearing/azimuth", "/bearing/balls", "/bearing/contacts", "/bearing/geometry", "/bearing/state", "/tf"]
RUN_TOPICS = SOLUTION_TOPICS + ["/bearing/wear"]
# At the end of a run, which a recovered file need not have.
RUN_END_TOPICS = ["/bearing/coating", "/bearing/orbit"]
STAMPED = ["/bearing/balls", "/bearing/state"]
SCHEMAS = {
    "/bearing/balls": ["tribodyn.v1.Balls"],
    "/bearing/state": ["tribodyn.v1.BearingState", "tribodyn.v1.TransientState"],
}
ATTACHMENTS = ["case.ron", "tribodyn.json"]
METADATA = "simulation"
RUN = "transient run"
RECOVERED = "recovery"


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


def stamp(message):
    return message.timestamp.seconds * 1_000_000_000 + message.timestamp.nanos


class Messages:
    """What the messages of a file say together, each checked by itself."""

    def __init__(self, gaps):
        self.gaps = gaps
        self.counts = collections.Counter()
        self.sequences = {}
        self.span = None
        self.times = {topic: [] for topic in STAMPED}
        self.digest = hashlib.sha256()

    def take(self, schema, channel, record, message):
        topic, time = channel.topic, record.log_time
        encodings = (schema.encoding, channel.message_encoding)
        require(encodings == ("protobuf", "protobuf"), f"{topic}: encoded as {encodings}")
        require(schema.name in SCHEMAS.get(topic, [schema.name]), f"{topic}: messages are {schema.name}")
        require(self.span is None or time >= self.span[1], f"{topic}: log time {time} after {self.span and self.span[1]}")
        self.span = (time if self.span is None else self.span[0], time)
        expected = self.sequences.get(channel.id, -1) + 1
        in_order = record.sequence >= expected if self.gaps else record.sequence == expected
        require(in_order, f"{topic}: sequence {record.sequence}, expected {expected}")
        self.sequences[channel.id] = record.sequence
        self.counts[channel.id] += 1
        self.digest.update(record.data)
        for name, value in numbers(message):
            require(math.isfinite(value), f"{topic}: {name} is {value}")
        if topic in self.times:
            require(stamp(message) == time, f"{topic}: timestamp {stamp(message)} in a message of {time}")
            self.times[topic].append(time)


def check_summary(statistics, messages, summary):
    total = sum(messages.counts.values())
    require(total == statistics.message_count, f"{total} messages, the summary says {statistics.message_count}")
    stated = {channel: count for channel, count in statistics.channel_message_counts.items() if count}
    require(dict(messages.counts) == stated, "counts by channel differ")
    require(messages.span == (statistics.message_start_time, statistics.message_end_time), "first or last log time differs")
    require(len(summary.channels) == statistics.channel_count, "channels differ from the summary")
    require(len(summary.schemas) == statistics.schema_count, "schemas differ from the summary")


def check_chunks(summary):
    """The span that a viewer shows: of a chunk without messages the index says that it starts at time 0, in 1970."""
    statistics, chunks = summary.statistics, summary.chunk_indexes
    require(len(chunks) == statistics.chunk_count, "chunks differ from the summary")
    empty = [chunk.chunk_start_offset for chunk in chunks if not chunk.message_index_offsets]
    require(not empty, f"no message in the chunk at byte {', '.join(map(str, empty))}")
    span = (min(c.message_start_time for c in chunks), max(c.message_end_time for c in chunks))
    stated = (statistics.message_start_time, statistics.message_end_time)
    require(span == stated, f"chunks span {span}, the messages {stated}")


def check_topics(topics, times, is_run, is_recovered):
    required = RUN_TOPICS if is_run else SOLUTION_TOPICS
    if is_run and not is_recovered:
        required = required + RUN_END_TOPICS
    missing = [topic for topic in required if topic not in topics]
    require(not missing, f"no message on {', '.join(missing)}")
    require(topics["/bearing/geometry"] == 1, f"{topics['/bearing/geometry']} messages on /bearing/geometry")
    states, balls = times["/bearing/state"], times["/bearing/balls"]
    alone = set(balls) - set(states)
    require(is_recovered or not alone, f"{len(alone)} messages of balls without a state")
    require(is_run or is_recovered or states == balls, "states without balls")


def check(path):
    with open(path, "rb") as stream:
        reader = SeekingReader(stream, validate_crcs=True, decoder_factories=[DecoderFactory()])
        summary = reader.get_summary()
        require(summary is not None and summary.statistics is not None, "no summary with statistics")
        statistics = summary.statistics
        metadata = {m.name: m.metadata for m in reader.iter_metadata()}
        require(METADATA in metadata, f"no metadata record {METADATA}")
        require(len(metadata) == statistics.metadata_count, "metadata differ from the summary")
        is_run, is_recovered = metadata[METADATA].get("kind") == RUN, RECOVERED in metadata
        messages = Messages(gaps=is_recovered)
        for schema, channel, record, message in reader.iter_decoded_messages():
            messages.take(schema, channel, record, message)
        check_summary(statistics, messages, summary)
        check_chunks(summary)
        topics = {summary.channels[channel].topic: count for channel, count in messages.counts.items()}
        check_topics(topics, messages.times, is_run, is_recovered)
        attachments = {a.name: a.data for a in reader.iter_attachments()}
        require(len(attachments) == statistics.attachment_count, "attachments differ from the summary")
        absent = [name for name in ATTACHMENTS if not attachments.get(name)]
        require(not absent, f"no attachment {', '.join(absent)}")
    kind = ("recovered " if is_recovered else "") + ("run" if is_run else "solution")
    seconds = (messages.span[1] - messages.span[0]) * 1e-9
    total = sum(messages.counts.values())
    payload = messages.digest.hexdigest()[:16]
    return f"{kind}, {total} messages on {len(topics)} topics over {seconds:.6f} s, payload {payload}"


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
