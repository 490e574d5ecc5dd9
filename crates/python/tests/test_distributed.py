"""Studies on a real cluster: nothing is lost, nothing is there twice, and numbers are those of one machine."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import textwrap
import threading
import time
from pathlib import Path

import pytest
import tribodyn
from pandas.testing import assert_frame_equal
from tribodyn import Case, ClusterError, InputError

from .cluster import Cluster
from .conftest import CASES, SHORT_S
from .test_runs import PROBLEM

pytest.importorskip("distributed")
from tribodyn import distributed  # noqa: E402

#: Rows of the short form, and of the long one.
SHORT, LONG = 800, 20_000


def values(rows: int) -> dict[str, str]:
    return {"ring.z.Force": f"kN(1..3 in {rows // 20})", "speed.inner.Constant": "rpm(3000..9000 in 20)"}


def whole(dataset: distributed.Dataset, case: Case, rows: int) -> None:
    """Every row once, bit for bit that of one machine."""
    frame = dataset.to_pandas()
    assert list(frame["row"]) == list(range(rows))
    local = tribodyn.sweep(case, values(rows), model="traction", progress=False).to_pandas()
    assert_frame_equal(frame, local, check_exact=True, check_dtype=False)
    assert dataset.failed_rows == (~local["converged"]).sum()


@pytest.mark.parametrize("rows", [SHORT, pytest.param(LONG, marks=pytest.mark.full)])
def test_identity_a_study_outlives_its_workers(plain: Case, tmp_path: Path, rows: int) -> None:
    """One worker killed, and the one in its place killed too; then the client goes away and comes back."""
    folder = tmp_path / "dataset"
    with Cluster(tmp_path, 3) as cluster:
        client = cluster.client()
        kills: list[int] = []

        def kill_twice() -> None:
            while len(kills) < 2:
                parts = len(list(folder.glob("part-*.parquet")))
                if parts >= 3 * (len(kills) + 1):
                    cluster.kill(cluster.workers[-1])
                    kills.append(parts)
                    cluster.workers.append(cluster.add())
                time.sleep(0.02)

        def interrupt(done: float, all_: float) -> None:
            if len(kills) == 2 and done < all_:
                raise KeyboardInterrupt

        killer = threading.Thread(target=kill_twice, daemon=True)
        killer.start()
        with pytest.raises(KeyboardInterrupt):
            seconds = 0.1 if rows == SHORT else 2.0
            distributed.sweep(
                client, plain, values(rows), dataset=folder, seconds=seconds, model="traction", progress=interrupt
            )
        killer.join(10)
        assert len(kills) == 2
        client.close()
        finished = len(list(folder.glob("part-*.parquet")))
        partitions = len(json.loads((folder / "_study.json").read_text())["partitions"])
        assert 0 < finished < partitions
        # A worker that is killed while it writes leaves half a file.
        (folder / ".part-000000.parquet.part").write_bytes(b"half")
        with cluster.client() as again:
            dataset = distributed.sweep(again, plain, values(rows), dataset=folder, model="traction", progress=False)
            assert dataset.resumed_partitions >= finished and dataset.partitions == partitions
            assert dataset.rows == rows and dataset.row_s > 0
            once_more = distributed.sweep(again, plain, values(rows), dataset=folder, model="traction", progress=False)
            assert once_more.resumed_partitions == partitions
            with pytest.raises(InputError, match="another study: another swept"):
                distributed.sweep(again, plain, values(2 * rows), dataset=folder, model="traction", progress=False)
            with pytest.raises(InputError, match="something else"):
                distributed.sweep(again, plain, values(rows), dataset=tmp_path, model="traction", progress=False)
    whole(dataset, plain, rows)
    dataset.merge(tmp_path / "merged.parquet")
    assert len(tribodyn.sweeps.Table({"output": str(tmp_path / "merged.parquet")}).to_pandas()) == rows
    assert not list(folder.glob(".*"))


def test_identity_samples_runs_and_starts_go_the_same_way(plain: Case, paper: Case, tmp_path: Path) -> None:
    (tmp_path / "case.ron").write_text((CASES / "paper-handset.ron").read_text())
    (tmp_path / "problem.ron").write_text(PROBLEM)
    with Cluster(tmp_path, 2) as cluster, cluster.client() as client:
        drawn = tribodyn.sobol({"ring.z.Force": ("kN", (1.0, 3.0)), "ring.x.Force": ("N", (0, 500))}, 64, seed=3)
        sampled = distributed.sweep(
            client, plain, samples=drawn, dataset=tmp_path / "samples", model="traction", progress=False
        )
        local = tribodyn.sweep(plain, samples=drawn, model="traction", progress=False).to_pandas()
        assert_frame_equal(sampled.to_pandas(), local, check_exact=True, check_dtype=False)

        forces = {"ring.z.Force": "kN(40),kN(50),kN(60)"}
        options = {"procedure": "run", "duration": SHORT_S, "recordings": tmp_path}
        runs = distributed.sweep(
            client, paper, forces, dataset=tmp_path / "runs", progress=False, **options
        ).to_pandas()  # type: ignore[arg-type]
        alone = tribodyn.run(paper.replace({"ring.z.Force": "kN(50)"}), SHORT_S, progress=False)
        assert list(runs["ring.z.Force [kN]"]) == [40.0, 50.0, 60.0] and list(runs["converged"]) == [True] * 3
        assert runs["cage_speed_mean_rpm"][1] == alone.cage_speed_mean_rpm
        assert runs["power_shaft_w"][1] == alone.power["shaft_w"]
        assert (tmp_path / "row-2.mcap").exists()

        starts = distributed.sweep(
            client, tmp_path / "problem.ron", procedure="identify", seeds=range(4), dataset=tmp_path / "starts",
            progress=False,
        ).to_pandas()  # fmt: skip
        best = tribodyn.identify(tmp_path / "problem.ron", seed=2, starts=1, progress=False)[0]
        assert starts.loc[2, "axial load"] == best.parameters[0]["value"] and len(starts) == 4


def test_limit_a_cluster_that_goes_away_is_an_exception(plain: Case, tmp_path: Path) -> None:
    folder = tmp_path / "dataset"
    with Cluster(tmp_path, 1) as cluster:
        client = cluster.client()

        def kill(done: float, all_: float) -> None:
            if done > 0 and cluster.scheduler.poll() is None:
                cluster.scheduler.kill()

        with pytest.raises(ClusterError) as caught:
            distributed.sweep(
                client, plain, values(SHORT), dataset=folder, seconds=0.1, model="traction", progress=kill
            )
        assert caught.value.dataset == str(folder) and 0 < caught.value.finished < caught.value.rows == SHORT
        assert "goes on from there" in str(caught.value)
        client.close(timeout=1)


def test_limit_workers_that_are_gone_are_waited_for_and_then_missed(plain: Case, tmp_path: Path) -> None:
    with Cluster(tmp_path, 1) as cluster, cluster.client() as client:

        def kill(done: float, all_: float) -> None:
            if done > 0 and cluster.workers:
                cluster.kill(cluster.workers[0])

        with pytest.raises(ClusterError, match="no worker for 2 s"):
            distributed.sweep(
                client,
                plain,
                values(SHORT),
                dataset=tmp_path / "dataset",
                seconds=0.1,
                patience=2.0,
                model="traction",
                progress=kill,
            )


def test_limit_bad_studies_are_refused_before_they_begin(plain: Case, tmp_path: Path) -> None:
    for options in (
        {"values": {"ring.z.Force": "mm(1),mm(2)"}},
        {"values": {"ring.z.Force": "kN(1),kN(2)"}, "procedure": "guess"},
        {"procedure": "identify"},
    ):
        with pytest.raises(InputError) as caught:
            distributed.sweep(None, plain, dataset=tmp_path / "dataset", **options)  # type: ignore[arg-type]
        assert caught.value.allowed
    assert not (tmp_path / "dataset").exists()


@pytest.mark.full
def test_limit_two_workers_are_nearly_twice_as_fast_as_one(tmp_path: Path) -> None:
    """Needs two cores for itself; prints what it finds."""
    program = textwrap.dedent(
        f"""
        import sys, time
        from pathlib import Path
        import tribodyn
        from tribodyn import distributed
        from tests.cluster import Cluster
        case = tribodyn.Case.read({str(CASES / "angular-7210.ron")!r})
        for workers in (1, 2):
            folder = Path(sys.argv[1]) / str(workers)
            folder.mkdir()
            with Cluster(folder, workers) as cluster, cluster.client() as client:
                options = dict(dataset=folder / "d", seconds=1, model="traction", progress=False)
                done = distributed.sweep(client, case, {values(6000)!r}, **options)
                print(done.wall_s)
        """
    )
    done = subprocess.run(
        [sys.executable, "-c", program, str(tmp_path)], capture_output=True, text=True, check=True,
        cwd=Path(__file__).parents[1], env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[1])},
    )  # fmt: skip
    one, two = map(float, done.stdout.split())
    print(f"one worker {one:.1f} s, two workers {two:.1f} s, speed-up {one / two:.2f}")
    assert one / two > 1.5
