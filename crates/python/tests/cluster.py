"""A cluster of real processes on this machine: a scheduler and workers that can be killed."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import TracebackType
from typing import Any, Optional


class Cluster:
    """A scheduler and some workers, each a process of its own with one thread."""

    def __init__(self, folder: Path, workers: int) -> None:
        self.folder = folder
        self.file = folder / "scheduler.json"
        self.scheduler = self._start("scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard")
        self.workers = [self.add() for _ in range(workers)]

    def _start(self, kind: str, *arguments: str) -> subprocess.Popen[bytes]:
        log = (self.folder / f"{kind}-{time.monotonic_ns()}.log").open("wb")
        module = f"distributed.cli.dask_{kind}"
        command = [sys.executable, "-m", module, "--scheduler-file", str(self.file), *arguments]
        return subprocess.Popen(command, stdout=log, stderr=log, cwd=self.folder, start_new_session=True)

    def add(self) -> subprocess.Popen[bytes]:
        """Another worker, without a nanny that would start a new one in its place."""
        options = ["--nthreads", "1", "--no-nanny", "--no-dashboard", "--local-directory", str(self.folder)]
        return self._start("worker", *options)

    def client(self, workers: Optional[int] = None) -> Any:
        """A client, once so many workers are there."""
        from distributed import Client

        deadline = time.monotonic() + 120
        while not self.file.exists():
            assert time.monotonic() < deadline, "no scheduler"
            time.sleep(0.05)
        client = Client(scheduler_file=str(self.file), set_as_default=False)
        client.wait_for_workers(len(self.workers) if workers is None else workers, timeout=120)
        return client

    def kill(self, worker: subprocess.Popen[bytes]) -> None:
        """As the system does when memory runs out."""
        os.kill(worker.pid, signal.SIGKILL)
        worker.wait()
        self.workers.remove(worker)

    def __enter__(self) -> Cluster:
        return self

    def __exit__(
        self, kind: Optional[type[BaseException]], value: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        for process in [*self.workers, self.scheduler]:
            process.terminate()
        for process in [*self.workers, self.scheduler]:
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
