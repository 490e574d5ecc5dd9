"""Ctrl-C ends long work soon, and nothing goes on calculating after it."""

from __future__ import annotations

import signal
import subprocess
import sys
import textwrap
import time

import pytest

from .conftest import CASES

pytestmark = pytest.mark.alone

WORK = {
    "sweep": "tribodyn.sweep(case, {'ring.x.Force': 'kN(1..9 in 300)'}, progress=False)",
    "plan": "tribodyn.plan(case, {'ring.x.Force': 'kN(1..9 in 300)', 'speed.inner.Constant': 'rpm(10..20 in 9)'})",
    "stiffness": "tribodyn.stiffness(case, speeds=range(200, 9000, 5), time_limit=float('inf'))",
    "identify": f"tribodyn.identify({str(CASES.parent / 'identify/paper.ron')!r}, progress=False)",
    "life": "tribodyn.life(tribodyn.Case.read(paper), strides=2000, progress=False)",
}


@pytest.mark.parametrize("work", WORK)
def test_limit_an_interrupt_ends_work_and_nothing_goes_on(work: str) -> None:
    program = textwrap.dedent(
        f"""
        import signal, time, tribodyn
        # A shell that starts the tests in the background has them ignore interrupts.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        case = tribodyn.Case.read({str(CASES / "angular-7210.ron")!r})
        paper = {str(CASES / "paper-ag.ron")!r}
        print("begun", flush=True)
        try:
            {WORK[work]}
            print("done", flush=True)
        except KeyboardInterrupt:
            print("stopped", flush=True)
            time.sleep(1.0)
            spent = time.process_time()
            time.sleep(1.0)
            print(time.process_time() - spent < 0.2, flush=True)
        """
    )
    process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None and process.stdout.readline() == "begun\n"
    # Long enough for the work to be under way, short enough for the quickest of it.
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    began = time.monotonic()
    ended = process.stdout.readline()
    seconds = time.monotonic() - began
    # Half a second is meant; the machine may have other work.
    assert ended == "stopped\n" and seconds < 2.0, (ended, seconds)
    assert process.communicate(timeout=30)[0] == "True\n"
