"""What a partition of a distributed study does: it runs on workers, and knows nothing of the cluster.

A work is plain data, so that it can be sent and compared. Rows are grouped in chunks that belong together; a partition
is some whole chunks. Its table has its name only when it is whole: a partition that is done twice writes the same bytes
twice.
"""

from __future__ import annotations

import hashlib
import json
import os
import tempfile
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Any, Optional, Union

from . import _native
from .case import Case
from .runs import identify, run

#: Partition: number, first chunk, chunk after the last one.
Partition = tuple[int, int, int]


@dataclass(frozen=True)
class Done:
    """A partition that is on the disk."""

    rows: int
    failed: int
    seconds: float


@dataclass(frozen=True)
class Equilibria:
    """Equilibria over a grid, or over samples."""

    case: tuple[str, str]
    values: tuple[tuple[str, Union[str, tuple[str, ...]]], ...]
    #: for each path the samples that this one has; the others are elsewhere
    samples: Optional[tuple[tuple[str, tuple[str, ...]], ...]]
    #: row of the first of them
    first: int
    rows: int
    chunk_rows: int
    model: str
    cold: bool

    name = "solve"

    def identity(self) -> dict[str, Any]:
        """What makes two studies the same."""
        swept = self.samples if self.samples is not None else self.values
        return {
            "name": self.name,
            "case": self.case[1],
            "swept": _digest(swept),
            "rows": self.rows,
            "model": self.model,
            "cold": self.cold,
        }

    def of(self, first_chunk: int, end_chunk: int) -> Equilibria:
        """With no more than what some chunks need."""
        if self.samples is None:
            return self
        first, end = first_chunk * self.chunk_rows, end_chunk * self.chunk_rows
        cut = tuple((path, drawn[first - self.first : end - self.first]) for path, drawn in self.samples)
        return Equilibria(self.case, (), cut, first, self.rows, self.chunk_rows, self.model, self.cold)

    def write(self, chunks: tuple[int, int], path: Path, threads: int) -> tuple[int, int]:
        """Rows, and rows without a solution, of a partition that is written."""
        return _grid(self).write_part(chunks, os.fspath(path), threads)

    def attempt(self, chunks: tuple[int, int], threads: int) -> int:
        """Rows that were solved to see how long they take."""
        return len(_grid(self).solve(chunks, threads, None)["row"])


@lru_cache(maxsize=4)
def _grid(work: Equilibria) -> _native.Grid:
    if work.samples is None:
        values = [(path, given if isinstance(given, str) else list(given)) for path, given in work.values]
        return _native.Grid.product(work.case, values, (work.model, work.cold), False)
    drawn = [(path, list(values)) for path, values in work.samples]
    return _native.Grid.samples(work.case, drawn, (work.first, work.rows), (work.model, work.cold))


@dataclass(frozen=True)
class Runs:
    """Runs in time over a grid, or over samples: a row of numbers each."""

    equilibria: Equilibria
    duration: Optional[float]
    #: folder of recordings, ``row-<number>.mcap``; None for none
    recordings: Optional[str]

    name = "run"
    #: each run for itself
    chunk_rows = 1

    @property
    def rows(self) -> int:
        """Number of runs."""
        return self.equilibria.rows

    def identity(self) -> dict[str, Any]:
        """What makes two studies the same."""
        return {**self.equilibria.identity(), "name": self.name, "duration": self.duration}

    def of(self, first_chunk: int, end_chunk: int) -> Runs:
        """With no more than what some runs need."""
        if self.equilibria.samples is None:
            return self
        each = Equilibria(**{**self.equilibria.__dict__, "chunk_rows": 1})
        return Runs(each.of(first_chunk, end_chunk), self.duration, self.recordings)

    def write(self, chunks: tuple[int, int], path: Path, threads: int) -> tuple[int, int]:
        """Runs, and runs that failed, of a partition that is written."""
        records = [self._row(row) for row in range(*chunks)]
        _write(records, path)
        return len(records), sum(not record["converged"] for record in records)

    def attempt(self, chunks: tuple[int, int], threads: int) -> int:
        """Runs that were made to see how long they take."""
        for row in range(*chunks):
            self._row(row)
        return chunks[1] - chunks[0]

    def _row(self, row: int) -> dict[str, Any]:
        text, swept = _grid(self.equilibria).row(row)
        record: dict[str, Any] = {"row": row, **swept, "converged": False, "error": None}
        try:
            if text is None:
                raise ValueError("a path is not in the case of this row")
            case = Case.parse(text, name=self.equilibria.case[0])
            target = None if self.recordings is None else Path(self.recordings) / f"row-{row}.mcap"
            # A worker that died may have left half a run.
            answer = run(case, self.duration, record=target, restart=target is not None, progress=False)
        except Exception as error:
            record["error"] = str(error)
            return record
        record.update(_numbers(answer.to_dict()))
        record["converged"] = True
        return record


@dataclass(frozen=True)
class Starts:
    """Starts of an identification, each with a seed of its own."""

    problem: str
    seeds: tuple[int, ...]
    #: what stands in the problem and its case
    texts: tuple[str, ...] = field(default=())

    name = "identify"
    chunk_rows = 1

    @property
    def rows(self) -> int:
        """Number of starts."""
        return len(self.seeds)

    def identity(self) -> dict[str, Any]:
        """What makes two studies the same."""
        return {"name": self.name, "case": "\n".join(self.texts), "swept": _digest(self.seeds), "rows": self.rows}

    def of(self, first_chunk: int, end_chunk: int) -> Starts:
        """As it is: seeds are few."""
        return self

    def write(self, chunks: tuple[int, int], path: Path, threads: int) -> tuple[int, int]:
        """Starts, and starts that found nothing, of a partition that is written."""
        records = [record for row in range(*chunks) for record in self._rows(row, threads)]
        _write(records, path)
        return chunks[1] - chunks[0], sum(not record["converged"] for record in records)

    def attempt(self, chunks: tuple[int, int], threads: int) -> int:
        """Starts that were made to see how long they take."""
        for row in range(*chunks):
            self._rows(row, threads)
        return chunks[1] - chunks[0]

    def _rows(self, row: int, threads: int) -> list[dict[str, Any]]:
        base: dict[str, Any] = {"row": row, "seed": self.seeds[row]}
        try:
            answers = identify(self.problem, seed=self.seeds[row], starts=1, threads=threads, progress=False)
        except Exception as error:
            return [{**base, "hypothesis": None, "converged": False, "error": str(error)}]
        return [
            {
                **base,
                "hypothesis": answer.hypothesis,
                "converged": True,
                "error": None,
                "cost": answer.cost,
                "data_cost": answer.data_cost,
                "log_evidence": answer.log_evidence,
                **{parameter["name"]: parameter["value"] for parameter in answer.parameters},
            }
            for answer in answers
        ]


Work = Union[Equilibria, Runs, Starts]


def solve_partition(work: Work, partition: Partition, folder: str, threads: int) -> Done:
    """Does a partition, unless its table is there already."""
    number, first, end = partition
    path = Path(folder) / file_name(number)
    began = time.perf_counter()
    rows, failed = work.write((first, end), path, threads)
    return Done(rows, failed, time.perf_counter() - began)


def attempt(work: Work, first: int, end: int, folder: str, threads: int) -> tuple[int, float, bool]:
    """Rows and seconds of some chunks, of which nothing is kept; and whether the folder is seen from here."""
    began = time.perf_counter()
    rows = work.attempt((first, end), threads)
    return rows, time.perf_counter() - began, (Path(folder) / STUDY).exists()


#: File of a dataset that says which study it belongs to.
STUDY = "_study.json"


def file_name(number: int) -> str:
    """Name of a partition's table."""
    return f"part-{number:06}.parquet"


def _digest(swept: object) -> str:
    return hashlib.sha256(json.dumps(swept, sort_keys=True).encode()).hexdigest()


def _numbers(values: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Single numbers, those of groups with the group's name before theirs."""
    flat: dict[str, Any] = {}
    for name, value in values.items():
        if isinstance(value, dict):
            flat.update(_numbers(value, f"{prefix}{name}_"))
        elif isinstance(value, (bool, int, float)) and name not in _CLOCK:
            flat[prefix + name] = value
    return flat


#: Not the same from one time to the next.
_CLOCK = ("wall_s", "simulated_per_wall")


def _write(records: list[dict[str, Any]], path: Path) -> None:
    import pyarrow
    from pyarrow import parquet

    names = list(dict.fromkeys(name for record in records for name in record))
    table = pyarrow.table({name: [record.get(name) for record in records] for name in names})
    handle, temporary = tempfile.mkstemp(prefix=".", suffix=".part", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as file:
            parquet.write_table(table, file)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise
