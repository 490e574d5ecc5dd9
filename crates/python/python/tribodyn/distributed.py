"""Studies on a cluster, by Dask: ``pip install 'tribodyn[distributed]'``.

Rows are divided into partitions by their measured cost. A worker writes the table of a partition when it is whole, so
that a worker that dies loses no more than what it was at; Dask gives that to another one. An interrupted study goes on
where it stood when the same function is called again with the same folder, which all workers have to see.
"""

from __future__ import annotations

import json
import os
import tempfile
import time
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Optional, Union

from . import __version__ as _version
from ._answer import Answer
from ._errors import ClusterError, FileError, InputError, TribodynError
from ._progress import Bar, Progress
from ._works import STUDY, Done, Equilibria, Partition, Runs, Starts, Work, attempt, file_name, solve_partition
from .case import Case, as_text
from .procedures import Model
from .sweeps import PathLike, Values, grid, merge, product_values, sample_values, single

if TYPE_CHECKING:
    import pandas as pd

Procedure = Literal["solve", "run", "identify"]

#: Chunks that are tried to see how long a row takes.
_TRIED = 3
#: Time between looks at the cluster, s.
_LOOK_S = 0.5
#: Partitions that are given to the cluster beyond those being worked on, for each thread: enough that none waits.
_AHEAD = 3
#: Partitions handed out anew in one call because the scheduler has lost them, at most: a worker holds only a few.
_AGAIN = 100


class Dataset(Answer):
    """A study that is done: a folder of Parquet files, a partition each."""

    #: the folder
    path: str
    #: rows of the whole study
    rows: int
    #: rows without a solution; the column ``error`` says why
    failed_rows: int
    #: files of the folder
    partitions: int
    #: partitions that an earlier call had finished
    resumed_partitions: int
    #: measured time of one row on one thread, s
    row_s: float
    #: wall time of this call, s
    wall_s: float

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """All rows, in order."""
        import pandas

        files = sorted(Path(self.path).glob("part-*.parquet"))
        whole: pd.DataFrame = pandas.concat([pandas.read_parquet(file) for file in files], ignore_index=True)
        whole = whole.set_index("row", drop=False).rename_axis(None)
        return whole

    def merge(self, output: PathLike, *, force: bool = False) -> None:
        """One table of all rows; of equilibria only."""
        merge(sorted(Path(self.path).glob("part-*.parquet")), output, force=force)


def sweep(
    client: Any,
    case: Union[Case, PathLike],
    values: Optional[Mapping[str, Values]] = None,
    *,
    dataset: PathLike,
    samples: Optional[Mapping[str, Iterable[Any]]] = None,
    procedure: Procedure = "solve",
    duration: Optional[float] = None,
    recordings: Optional[PathLike] = None,
    seeds: Iterable[int] = (),
    model: Model = "steady-orbit",
    cold: bool = False,
    seconds: float = 20.0,
    threads: int = 1,
    retries: int = 3,
    patience: float = 60.0,
    progress: Progress = True,
) -> Dataset:
    """A study on a cluster: equilibria, runs in time, or starts of an identification.

    Args:
        client: ``dask.distributed.Client``
        case: the bearing; for an identification the path of its problem file, which all workers have to see
        values, samples, model, cold: as for :func:`tribodyn.sweep`
        dataset: folder of the results; the same call goes on with one that is not finished
        procedure: ``solve`` equilibria, ``run`` in time, ``identify``
        duration: simulated time of each run, s
        recordings: folder for the recordings of runs; without it none is kept
        seeds: seeds of the starts of an identification
        seconds: wall time that a partition is to take: what the death of a worker may cost
        threads: threads of a partition; one where a worker has one process for each core
        retries: how often a partition that fails is tried again
        patience: how long to wait for a cluster without workers, s
        progress: a bar where somebody watches; Dask's dashboard shows more

    Raises:
        ClusterError: the cluster is gone; what is finished stays, and the same call goes on from there
        InputError: a value is refused, or the folder holds another study
    """
    work = _work(case, values, samples, procedure, duration, recordings, seeds, (model, cold))
    folder = Path(os.fspath(dataset))
    began = time.monotonic()
    study = _Study(client, work, folder, threads, retries, patience)
    try:
        with Bar(float(work.rows), "rows", progress) as bar:
            return study.complete(seconds, bar, began)
    except TribodynError:
        raise
    except (OSError, TimeoutError, _DaskTimeout) as error:
        # Dask's own failures to connect have no number of the system.
        if (
            isinstance(error, OSError)
            and error.errno is not None
            and not isinstance(error, (ConnectionError, TimeoutError))
        ):
            raise FileError(f"cannot write {folder}: {error}", file=str(folder)) from error
        raise study.gone(str(error)) from error


def _work(
    case: Union[Case, PathLike],
    values: Optional[Mapping[str, Values]],
    samples: Optional[Mapping[str, Iterable[Any]]],
    procedure: str,
    duration: Optional[float],
    recordings: Optional[PathLike],
    seeds: Iterable[int],
    model_and_cold: tuple[Model, bool],
) -> Work:
    if procedure == "identify":
        return _starts(case, tuple(int(seed) for seed in seeds))
    if not isinstance(case, Case):
        raise InputError(f"case = {case!r}: allowed is a Case", path="case", value=repr(case), allowed="a Case")
    if procedure not in ("solve", "run"):
        allowed = "allowed are solve, run, identify"
        raise InputError(f"procedure = {procedure}: {allowed}", path="procedure", value=procedure, allowed=allowed)
    drawn = None if samples is None else tuple((path, tuple(given)) for path, given in sample_values(samples))
    if drawn is not None:
        case = case.replace({path: as_text(single(path, given)) for path, given in (values or {}).items()})
    kept_samples = None if drawn is None else dict(drawn)
    model, cold = model_and_cold
    rows = grid(case, None if drawn is not None else values, samples=kept_samples, model=model, cold=cold)
    fixed: tuple[tuple[str, Union[str, tuple[str, ...]]], ...] = ()
    if drawn is None:
        given = product_values(values or {})
        fixed = tuple((path, value if isinstance(value, str) else tuple(value)) for path, value in given)
    equilibria = Equilibria((case.file, case.text), fixed, drawn, 0, rows.rows, rows.chunk_rows, model, cold)
    if procedure == "solve":
        return equilibria
    kept = None if recordings is None else os.fspath(recordings)
    return Runs(equilibria, duration, kept)


def _starts(problem: Union[Case, PathLike], seeds: tuple[int, ...]) -> Starts:
    if isinstance(problem, Case) or not seeds:
        allowed = "allowed are the path of a problem file, and one seed or more"
        raise InputError(f"identify: {allowed}", path="seeds", value=str(len(seeds)), allowed=allowed)
    path = os.path.abspath(os.fspath(problem))
    try:
        return Starts(path, seeds, (Path(path).read_text(encoding="utf-8"),))
    except OSError as error:
        raise FileError(f"cannot read {path}: {error}", file=path) from error


class _Study:
    """One call: its work, its folder and its cluster."""

    def __init__(self, client: Any, work: Work, folder: Path, threads: int, retries: int, patience: float) -> None:
        self.client = client
        self.work = work
        self.folder = folder
        self.threads = threads
        self.retries = retries
        # How many partitions may be handed out anew in all, because the scheduler lost them with a worker.
        self.again = _AGAIN
        self.patience = patience
        self.rows = 0
        self.failed = 0
        self.seen_workers = time.monotonic()

    def complete(self, seconds: float, bar: Bar, began: float) -> Dataset:
        """Does what is not done."""
        plan = self._plan(seconds)
        partitions = [tuple(partition) for partition in plan["partitions"]]
        open_ = [partition for partition in partitions if not self._finished(partition)]
        bar(float(self.rows))
        self._drive(open_, bar)
        # Half files of workers that were killed while they wrote.
        for half in self.folder.glob(".*.part"):
            half.unlink(missing_ok=True)
        facts = {
            "path": str(self.folder),
            "rows": self.work.rows,
            "failed_rows": self.failed,
            "partitions": len(partitions),
            "resumed_partitions": len(partitions) - len(open_),
            "row_s": plan["row_s"],
            "wall_s": time.monotonic() - began,
        }
        return Dataset(facts)

    def _plan(self, seconds: float) -> dict[str, Any]:
        """The partitions: those of the folder, or new ones by the measured cost of a row."""
        identity = {"tribodyn": _version, **self.work.identity()}
        path = self.folder / STUDY
        if path.exists():
            return self._earlier(path, identity)
        if self.folder.exists() and any(self.folder.iterdir()):
            allowed = "allowed is a new folder, or that of the same study"
            raise InputError(
                f"{self.folder} holds something else; {allowed}",
                path="dataset",
                value=str(self.folder),
                allowed=allowed,
            )
        self.folder.mkdir(parents=True, exist_ok=True)
        # Workers look for this file to see whether they see the folder.
        plan: dict[str, Any] = {"identity": identity, "partitions": None, "row_s": None}
        _write_json(path, plan)
        return self._measured(path, plan, seconds)

    def _earlier(self, path: Path, identity: dict[str, Any]) -> dict[str, Any]:
        try:
            plan: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
            held = plan["identity"]
        except (OSError, ValueError, KeyError) as error:
            raise FileError(f"{path} is not the description of a study: {error}", file=str(path)) from error
        different = [name for name in identity if identity[name] != held.get(name)]
        if different:
            allowed = "allowed is the folder of the same study, or a new one"
            what = ", ".join(different)
            raise InputError(
                f"{self.folder} is of another study: another {what}; {allowed}",
                path="dataset",
                value=str(self.folder),
                allowed=allowed,
            )
        return plan if plan["partitions"] is not None else self._measured(path, plan, 20.0)

    def _measured(self, path: Path, plan: dict[str, Any], seconds: float) -> dict[str, Any]:
        """Some chunks over the whole range, tried on the cluster; then whole partitions of so many seconds."""
        chunks = -(-self.work.rows // self.work.chunk_rows)
        places = sorted({chunks * k // _TRIED for k in range(_TRIED)})
        tried = [
            self.client.submit(
                attempt,
                self.work.of(place, place + 1),
                place,
                place + 1,
                os.path.abspath(self.folder),
                self.threads,
                key=f"tribodyn-attempt-{place}-{time.time_ns()}",
                pure=False,
                retries=self.retries,
            )
            for place in places
        ]
        answers = [answer for _, answer in self._results(dict(zip(tried, places))) if answer is not None]
        if not answers:
            raise self.gone("the scheduler has lost what it was given")
        if not all(seen for _, _, seen in answers):
            allowed = "allowed is a folder that all workers see, such as one on a shared file system"
            raise InputError(
                f"a worker does not see {self.folder}; {allowed}",
                path="dataset",
                value=str(self.folder),
                allowed=allowed,
            )
        plan["row_s"] = sum(took for _, took, _ in answers) / max(sum(rows for rows, _, _ in answers), 1)
        per_chunk = plan["row_s"] * self.work.chunk_rows
        # No more than that, and enough partitions for all threads to end at about the same time.
        cores = max(sum(self.client.nthreads().values()), 1)
        size = max(1, min(int(seconds / per_chunk) if per_chunk > 0 else chunks, -(-chunks // (4 * cores))))
        plan["partitions"] = [
            (number, first, min(first + size, chunks)) for number, first in enumerate(range(0, chunks, size))
        ]
        _write_json(path, plan)
        return plan

    def _finished(self, partition: Partition) -> bool:
        """Whether the table of a partition is there; counts its rows."""
        from pyarrow import ArrowInvalid, parquet

        number, first, end = partition
        path = self.folder / file_name(number)
        rows = min(end * self.work.chunk_rows, self.work.rows) - first * self.work.chunk_rows
        try:
            converged = parquet.read_table(path, columns=["row", "converged"])
        except (FileNotFoundError, ArrowInvalid):
            return False
        if len(set(converged["row"].to_pylist())) != rows:
            return False
        self.rows += rows
        self.failed += sum(1 for truth in converged["converged"].to_pylist() if not truth)
        return True

    def _drive(self, partitions: list[Partition], bar: Bar) -> None:
        """Hands out partitions, some ahead of those being worked on."""
        waiting = list(reversed(partitions))
        given: dict[Any, Partition] = {}
        try:
            while waiting or given:
                ahead = _AHEAD * max(sum(self.client.nthreads().values()), 1)
                while waiting and len(given) < ahead:
                    partition = waiting.pop()
                    given[self._submit(partition)] = partition
                for partition, done in self._results(given, first=True):
                    if done is None:
                        waiting.append(partition)
                        continue
                    self.rows += done.rows
                    self.failed += done.failed
                    bar(float(self.rows))
        finally:
            if given and self.client.status == "running":
                self.client.cancel(list(given))

    def _submit(self, partition: Partition) -> Any:
        number, first, end = partition
        return self.client.submit(
            solve_partition,
            self.work.of(first, end),
            partition,
            os.path.abspath(self.folder),
            self.threads,
            key=f"tribodyn-{self.work.name}-{number}-{time.time_ns()}",
            pure=False,
            retries=self.retries,
        )

    def _results(self, given: dict[Any, Any], first: bool = False) -> list[tuple[Any, Any]]:
        """Results of what was given, all or the first ones; these are taken out of it."""
        found: list[tuple[Any, Any]] = []
        while given:
            done = self._wait(given)
            found.extend((given.pop(future), self._result(future)) for future in done)
            if first and found:
                break
        return found

    def _wait(self, given: dict[Any, Any]) -> list[Any]:
        """Waits for the next results, and sees whether there is still a cluster."""
        import distributed

        wait: Any = distributed.wait
        while True:
            ready = [future for future in given if future.status != "pending"]
            if ready:
                return ready
            if self.client.status != "running":
                raise self.gone(f"the client is {self.client.status}")
            try:
                with self.client.as_current():
                    wait(list(given), timeout=_LOOK_S, return_when="FIRST_COMPLETED")
            except (TimeoutError, _DaskTimeout):
                self._look()

    def _look(self) -> None:
        """Workers may come back for a while."""
        if self.client.nthreads():
            self.seen_workers = time.monotonic()
        elif time.monotonic() - self.seen_workers > self.patience:
            raise self.gone(f"there has been no worker for {self.patience:g} s")

    def _result(self, future: Any) -> Any:
        """What a worker answered; None if the scheduler has lost it and it may be handed out anew."""
        from concurrent.futures import CancelledError

        from distributed.scheduler import KilledWorker

        if future.status in ("cancelled", "lost"):
            return self._anew()
        try:
            return future.result()
        except KilledWorker as error:
            raise self.gone(f"a partition has ended several workers, one after the other: {error}") from error
        except CancelledError:
            return self._anew()

    def _anew(self) -> None:
        """A result went with its worker. Tables of partitions are written whole, so that one may be done again."""
        if self.client.status != "running" or self.again == 0:
            raise self.gone("the scheduler has lost what it was given")
        self.again -= 1

    def gone(self, why: str) -> ClusterError:
        """A cluster that is gone, with what is finished."""
        done = f"{self.rows} of {self.work.rows} rows are finished in {self.folder}"
        return ClusterError(
            f"{why}; {done}: the same call goes on from there",
            dataset=str(self.folder),
            finished=self.rows,
            rows=self.work.rows,
        )


def _write_json(path: Path, data: dict[str, Any]) -> None:
    handle, temporary = tempfile.mkstemp(prefix=".", suffix=".part", dir=path.parent)
    with os.fdopen(handle, "w", encoding="utf-8") as file:
        json.dump(data, file)
    os.replace(temporary, path)


def _dask_timeout() -> type[BaseException]:
    import asyncio

    return asyncio.TimeoutError


_DaskTimeout = _dask_timeout()
__all__ = ["Dataset", "Done", "Procedure", "sweep"]
