"""Tests of campaigns in one process, in a process pool and on a cluster."""

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import partial
from multiprocessing import active_children
from pathlib import Path

import distributed
import numpy as np
import pytest
import scipy.stats

from lispac.design.monte_carlo import MonteCarloResult, run_monte_carlo, simulate_plan
from lispac.design.plan import System
from lispac.design.plan_search import search
from lispac.errors import Cancelled, LispacError, RankDeficient
from lispac.io.config.plan_file import read_site
from lispac.messages import Level, note
from lispac.progress import Step
from lispac.simulation.closed_form_survey import Ball
from lispac.simulation.scanner import Scanner
from lispac.workflow.planning import cluster as cluster_module
from lispac.workflow.planning.cluster import cluster_mapper
from lispac.workflow.planning.cluster_access import ClusterAccess
from lispac.workflow.planning.parallel_map import choose_mapper
from lispac.workflow.planning.plan_checks import result_heading
from lispac.workflow.planning.process_pool import chunk_size, process_pool_mapper
from tests.cli.test_cli import run, run_json, run_refused
from tests.studies.prediction_study import PLAN
from tests.support.cluster_tasks import (
    Slow,
    kill_process_always,
    kill_process_once,
    raise_correctable_error,
)
from tests.support.clusters import Clusters
from tests.support.command_errors import command_error
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import codes

PORT = Path(__file__).parents[1] / "data" / "port-plan.toml"
QUAY = Path(__file__).parents[2] / "resources" / "sites" / "quay.toml"
SMALL = replace(PLAN, system=System(scanner=Scanner(20_000.0)))


@pytest.fixture(scope="module")
def clusters() -> Iterator[Clusters]:
    started = Clusters()
    yield started
    started.close()


@pytest.fixture
def cluster(clusters: Clusters) -> distributed.LocalCluster:
    """A cluster with two workers."""
    return clusters.with_workers()


def are_identical(one: MonteCarloResult, other: MonteCarloResult) -> bool:
    """Whether two results are equal to the last bit."""
    return np.array_equal(one.errors, other.errors) and np.array_equal(one.sigmas, other.sigmas)


@LONG
def test_monte_carlo_results_do_not_depend_on_the_mapper(cluster: distributed.LocalCluster) -> None:
    here = run_monte_carlo(SMALL, 6)
    with process_pool_mapper(2) as mapper:
        assert are_identical(run_monte_carlo(SMALL, 6, mapper=mapper), here)
    with cluster_mapper(cluster.scheduler_address) as mapper:
        assert are_identical(run_monte_carlo(SMALL, 6, mapper=mapper), here)
    assert np.array_equal(run_monte_carlo(SMALL, 3).errors, here.errors[:3])
    assert not np.isclose(run_monte_carlo(SMALL, 3, seed=1).errors, here.errors[:3]).any()


@pytest.mark.long
def test_search_results_do_not_depend_on_the_mapper(cluster: distributed.LocalCluster) -> None:
    _, site = read_site(QUAY)
    site = replace(
        site, lines=3, along=(-4.0, 1.0, 4.0), heights=(2.0, 8.0), headings_deg=(0.0, 45.0, 135.0)
    )
    designs = []
    for where in (
        process_pool_mapper(1),
        process_pool_mapper(2),
        cluster_mapper(cluster.scheduler_address),
    ):
        with where as mapper:
            designs.append(search(site, plans=300, mapper=mapper))
    here, *others = designs
    for other in others:
        assert (other.value, other.evaluated) == (here.value, here.evaluated)
        assert np.array_equal(other.prediction.information, here.prediction.information)
        assert other.plan.lines == here.plan.lines


def test_at_the_command_line(
    cluster: distributed.LocalCluster, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ("campaign", PORT, "--surveys", 4)
    here = run_json(capsys, *words, "--workers", 1)
    assert run_json(capsys, *words, "--cluster", cluster.scheduler_address) == here
    assert len(here["coverage_95"]) == 3
    code, out, err = run(capsys, *words, "--workers", 1, "--flatness-known")
    assert code == 0, err
    assert "4 surveys simulated and adjusted" in out
    assert "predicted" in out


def test_a_lost_worker_loses_no_result(cluster: distributed.LocalCluster, tmp_path: Path) -> None:
    marker = tmp_path / "killed"
    with cluster_mapper(cluster.scheduler_address) as mapper:
        assert list(mapper(partial(kill_process_once, marker), range(100))) == [
            k**2 for k in range(100)
        ]
    assert marker.exists()


@pytest.mark.long
def test_a_worker_killed_from_outside_loses_no_result(
    cluster: distributed.LocalCluster,
) -> None:
    """The operating system kills the worker during the campaign."""
    here = run_monte_carlo(SMALL, 20)
    killed: list[int] = []
    with (
        distributed.Client(cluster.scheduler_address, set_as_default=False) as client,
        cluster_mapper(cluster.scheduler_address) as mapper,
    ):
        workers = list(client.run(os.getpid).values())

        def kill(fraction: float, step: Step | None = None) -> None:
            if not killed:
                killed.append(workers[0])
                os.kill(workers[0], signal.SIGTERM if sys.platform == "win32" else signal.SIGKILL)

        assert are_identical(run_monte_carlo(SMALL, 20, mapper=mapper, progress=kill), here)
        client.wait_for_workers(2, timeout=120)
        assert workers[0] not in client.run(os.getpid).values()


@pytest.mark.long
def test_a_task_that_ends_every_worker_ends_the_campaign(cluster: distributed.LocalCluster) -> None:
    with (
        cluster_mapper(cluster.scheduler_address) as mapper,
        pytest.raises(LispacError) as raised,
    ):
        list(mapper(kill_process_always, range(20)))
    assert raised.value.code == "cluster.worker_lost_repeatedly"
    with process_pool_mapper(2) as mapper, pytest.raises(LispacError) as raised:
        list(mapper(kill_process_always, range(20)))
    assert raised.value.code == "plan_survey.process_ended"


def test_an_error_in_a_worker_is_raised_unchanged(cluster: distributed.LocalCluster) -> None:
    for where in (
        process_pool_mapper(1),
        process_pool_mapper(2),
        cluster_mapper(cluster.scheduler_address),
    ):
        with where as mapper, pytest.raises(LispacError, match=r"^number 3 is too large$"):
            list(mapper(raise_correctable_error, [3]))


def stopped_at_once(results: Iterable[int]) -> None:
    """Cancel after the first result, like the progress of a search."""
    for _ in results:
        raise Cancelled


@pytest.mark.parametrize("place", ["pool", "cluster"])
def test_a_cancelled_campaign_stops(
    place: str, cluster: distributed.LocalCluster, tmp_path: Path
) -> None:
    address = cluster.scheduler_address
    where: Callable = {
        "pool": lambda: process_pool_mapper(2),
        "cluster": lambda: cluster_mapper(address),
    }[place]
    before = set(active_children())
    with pytest.raises(Cancelled), where() as mapper:
        stopped_at_once(mapper(Slow(tmp_path), range(2000)))
    # No process of the pool; a process of another test's cluster may have ended meanwhile
    assert set(active_children()) <= before
    with distributed.Client(address, set_as_default=False) as client:
        until = time.monotonic() + 20
        while any(client.processing().values()):  # tasks that have begun are finished
            assert time.monotonic() < until
            time.sleep(0.1)
    assert 0 < len(list(tmp_path.iterdir())) < 200


def test_addresses_without_a_scheduler_are_refused(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cluster_module, "CONNECT_TIMEOUT", 1.0)
    words = ("campaign", PORT, "--cluster")
    assert command_error(*words, "office-7").code == "cluster.bad_address"
    with socket.socket() as closed:
        closed.bind(("127.0.0.1", 0))
        nobody = f"tcp://127.0.0.1:{closed.getsockname()[1]}"
        start = time.monotonic()
        refusal = command_error(*words, nobody)
        assert refusal.code == "cluster.no_scheduler"
        assert nobody in str(refusal)
    with socket.create_server(("127.0.0.1", 0)) as mute:  # another service, which does not answer
        address = f"127.0.0.1:{mute.getsockname()[1]}"
        refusal = command_error("design", QUAY, "--cluster", address)
        assert refusal.code == "cluster.no_scheduler"
        assert address in str(refusal)
    assert time.monotonic() - start < 20
    code, _, err = run(capsys, *words, nobody, "--workers", 2)
    assert code == 2
    assert "not allowed with argument" in err


def test_workers_of_another_version_are_refused(
    cluster: distributed.LocalCluster, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cluster_module, "__version__", "9.9.9")
    with (
        pytest.raises(LispacError) as raised,
        cluster_mapper(cluster.scheduler_address),
    ):
        pass
    assert raised.value.code == "cluster.worker_version"
    assert raised.value.message is not None
    assert raised.value.message.params["expected"] == "9.9.9"
    assert str(raised.value.message.params["address"]).startswith("tcp://")
    task = partial(cluster_module._map_on_worker, abs, "9.9.9")
    with (
        distributed.Client(cluster.scheduler_address, set_as_default=False) as client,
        pytest.raises(LispacError) as raised,
    ):
        client.submit(task, [1]).result()
    assert raised.value.code == "cluster.late_worker_version"


@LONG
def test_a_cluster_without_workers_is_refused_without_waiting(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(cluster_module, "START_TIMEOUT", 1.0)
    with distributed.LocalCluster(n_workers=0, dashboard_address=":0") as empty:
        address = empty.scheduler_address
        with pytest.raises(LispacError) as raised, cluster_mapper(address):
            pass
        assert raised.value.code == "cluster.no_workers"
        empty.scale(1)
        empty.wait_for_workers(1, timeout=120)
        monkeypatch.setattr(cluster_module, "POLL_INTERVAL", 0.1)
        monkeypatch.setattr(cluster_module, "WORKER_TIMEOUT", 0.3)
        with cluster_mapper(address) as mapper:
            results = mapper(abs, range(3))
            assert next(results) == 0
            tasks = empty.scheduler.tasks
            while sum(task.state == "memory" for task in list(tasks.values())) < 2:
                time.sleep(0.05)
            empty.scale(0)  # its results are lost with it
            while empty.scheduler.workers:
                time.sleep(0.05)
            with pytest.raises(LispacError) as raised:
                list(results)
            assert raised.value.code == "cluster.no_workers_left"
            with pytest.raises(LispacError) as raised:
                list(mapper(abs, range(3)))
            assert raised.value.code == "cluster.no_workers_left"


def test_a_lost_scheduler_is_reported(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The scheduler is a separate process, which is killed."""
    monkeypatch.setattr(cluster_module, "START_TIMEOUT", 1.0)
    words = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--no-dashboard"]
    words += ["--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(tmp_path / "where")]
    scheduler = subprocess.Popen(words, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    try:
        until = time.monotonic() + 60
        while not (tmp_path / "where").exists():
            assert time.monotonic() < until
            time.sleep(0.1)
        address = json.loads((tmp_path / "where").read_text())["address"]
        with pytest.raises(LispacError) as raised, cluster_mapper(address):
            pass
        assert raised.value.code == "cluster.no_workers"
        capfd.readouterr()
        client = distributed.Client(address, timeout=1, set_as_default=False)
        scheduler.kill()
        scheduler.wait()
        cluster = cluster_module._Cluster(client, address)
        with cluster_module._suppressed_logs():
            with pytest.raises(LispacError) as raised:
                list(cluster.map(abs, range(3)))
            assert raised.value.code == "cluster.connection_lost"
            cluster.close()
        assert capfd.readouterr().err == ""
    finally:
        scheduler.kill()
        scheduler.wait()


def test_a_missing_package_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    refusal = run_refused(capsys, "campaign", PORT, "--cluster", "tcp://127.0.0.1:8786")
    assert "pip install -e '.[cluster]'" in refusal
    with choose_mapper(1, None) as mapper:
        assert mapper is map


def test_chunks() -> None:
    assert [chunk_size(n, 2) for n in (0, 1, 16, 144, 1000)] == [1, 1, 1, 9, 16]
    assert chunk_size(200, 0) == 16


def test_plans_that_cannot_be_adjusted_are_refused() -> None:
    with pytest.raises(RankDeficient, check=has_code("design.undetermined")):
        run_monte_carlo(SMALL.with_lines(SMALL.lines[:1]), 2)
    own = replace(SMALL, targets=tuple(replace(t, flatness=0.001) for t in SMALL.targets))
    with pytest.raises(LispacError, check=has_code("design.own_flatness")):
        run_monte_carlo(own, 2, flatness_known=True)
    assert run_monte_carlo(own, 2).sigmas.shape == (2, 3)


def test_balls_are_simulated() -> None:
    """Without errors on a calm sea, all points lie on the ball, as many as the scanner measures."""
    ball = Ball("S1", (0.0, -13.0, 6.0), 0.2)
    found = run_monte_carlo(SMALL.with_targets((*SMALL.targets, ball)), 3)
    assert found.failed == 0
    exact = simulate_plan(
        SMALL.with_targets([ball]), np.random.default_rng(1), perfect=True, calm=True
    )
    mounting = SMALL.system.mounting
    places = mounting.lever_arm + exact.points_lidar
    turn = exact.attitude[:, 2]
    north = np.cos(turn) * places[:, 0] + np.sin(turn) * places[:, 1]
    west = -np.sin(turn) * places[:, 0] + np.cos(turn) * places[:, 1]
    local = exact.position + np.column_stack([north, west, places[:, 2]])
    assert np.linalg.norm(local - ball.centre, axis=1) == pytest.approx(0.2, abs=1e-9)
    assert exact.radii == {"S1": 0.2}


def test_the_summary_names_the_sigma_that_is_too_small() -> None:
    generator = np.random.default_rng(3)
    sigmas, alone = np.full((400, 3), 1e-4), np.eye(3)
    found = MonteCarloResult(
        generator.normal(0.0, 1e-4, (400, 3)) * [1, 1, 5], sigmas, sigmas[0], alone, 2
    )
    yaw, chi, failed = found.messages
    assert (yaw.code, yaw.level) == ("campaign.sigma_too_small", Level.WARNING)
    assert yaw.params["angle"] == note("adjustment.angle_yaw")
    assert chi.code == "campaign.errors_larger"
    assert failed == note("campaign.not_adjusted", count=2)
    others = MonteCarloResult(found.errors * [1, 1, 0.2], sigmas, sigmas[0], alone, 0)
    assert codes(others.messages) == ["campaign.coverage_agrees", "campaign.errors_agree"]
    off = replace(others, errors=others.errors + [0.0, 5e-5, 0.0])
    (mean_error,) = (each for each in off.messages if each.code == "campaign.mean_error")
    assert mean_error.params["angle"] == note("adjustment.angle_pitch")
    assert mean_error.params["mean"] == pytest.approx(5e-5, rel=0.3)
    small = replace(others, errors=0.8 * others.errors)
    assert "campaign.errors_smaller" in codes(small.messages)


def test_chi_square_uses_the_correlation_of_the_angles() -> None:
    """Errors drawn with a known covariance, against the chi-square distribution of SciPy."""
    covariance = 1e-8 * np.array([[4.0, -1.9, 0.3], [-1.9, 1.0, 0.2], [0.3, 0.2, 2.0]])
    sigma = np.sqrt(np.diag(covariance))
    correlation = covariance / np.outer(sigma, sigma)
    errors = np.random.default_rng(8).multivariate_normal(np.zeros(3), covariance, 2000)
    found = MonteCarloResult(errors, np.tile(sigma, (2000, 1)), sigma, correlation, 0)
    low, high = found.chi_square_bounds
    assert (low, high) == pytest.approx(scipy.stats.chi2.ppf((0.025, 0.975), 6000), rel=1e-9)
    assert low < found.chi_square < high
    each = [e @ np.linalg.solve(covariance, e) for e in errors]
    assert found.chi_square == pytest.approx(sum(each), rel=1e-9)


@LONG
def test_a_cancelled_campaign_reports_its_finished_surveys_if_enough() -> None:
    def cancelled_after(count: int) -> Callable[[float, str], None]:
        def progress(fraction: float, step: Step | None = None) -> None:
            if fraction >= count / 14:
                raise Cancelled

        return progress

    whole = run_monte_carlo(SMALL, 14)
    part = run_monte_carlo(SMALL, 14, enough=6, progress=cancelled_after(8))
    assert np.array_equal(part.errors, whole.errors[:8])
    assert (
        str(result_heading("Pier", part, 14)) == "Pier: cancelled after 8 of 14 simulated surveys"
    )
    assert str(result_heading("Pier", whole, 14)) == "Pier: 14 surveys simulated and adjusted"
    for enough in (6, None):
        with pytest.raises(Cancelled):
            run_monte_carlo(SMALL, 14, enough=enough, progress=cancelled_after(5))


@pytest.fixture(scope="module")
def certificates(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path, Path]:
    """Certificate authority, a certificate signed by it for this computer, and its key."""
    openssl = shutil.which("openssl")
    if openssl is None:
        pytest.skip("openssl is not installed")
    folder = tmp_path_factory.mktemp("certificates")

    def make(*words: str) -> None:
        subprocess.run([openssl, *words], cwd=folder, check=True, capture_output=True)

    new = ("-newkey", "rsa:2048", "-nodes")
    make("req", "-x509", *new, "-keyout", "ca.key", "-out", "ca.pem", "-subj", "/CN=CA", "-addext",
         "keyUsage=critical,keyCertSign")  # fmt: skip
    make("req", *new, "-keyout", "own.key", "-out", "own.csr", "-subj", "/CN=localhost")
    (folder / "names").write_text("subjectAltName=DNS:localhost,IP:127.0.0.1\n")
    make("x509", "-req", "-in", "own.csr", "-CA", "ca.pem", "-CAkey", "ca.key", "-CAcreateserial",
         "-out", "own.pem", "-extfile", "names")  # fmt: skip
    return folder / "ca.pem", folder / "own.pem", folder / "own.key"


def test_a_cluster_is_reached_by_tls(
    certificates: tuple[Path, Path, Path], tmp_path_factory: pytest.TempPathFactory
) -> None:
    authority, certificate, key = map(str, certificates)
    security = distributed.Security(
        require_encryption=True, tls_ca_file=authority, tls_scheduler_cert=certificate,
        tls_scheduler_key=key, tls_worker_cert=certificate, tls_worker_key=key,
        tls_client_cert=certificate, tls_client_key=key,
    )  # fmt: skip
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address=":0",
        silence_logs=50, protocol="tls", security=security,
    ) as secure:  # fmt: skip
        address = secure.scheduler_address
        assert address.startswith("tls://")
        with cluster_mapper(ClusterAccess(address, certificates)) as mapper:
            assert list(mapper(abs, [-1, -2])) == [1, 2]
        with (
            pytest.raises(LispacError, check=has_code("cluster.no_certificates")),
            cluster_mapper(ClusterAccess(address)),
        ):
            pass
        other = tmp_path_factory.mktemp("other")
        (other / "ca.pem").write_text("no certificate")
        wrong = ClusterAccess(address, (other / "ca.pem", *certificates[1:]))
        with pytest.raises(LispacError) as raised, cluster_mapper(wrong):
            pass
        assert raised.value.code == "cluster.unusable_certificates"


def test_a_scheduler_without_the_certificate_is_refused(
    certificates: tuple[Path, Path, Path], cluster: distributed.LocalCluster
) -> None:
    """Another server answers at the address of the scheduler."""
    address = cluster.scheduler_address.replace("tcp://", "tls://")
    with (
        pytest.raises(LispacError) as raised,
        cluster_mapper(ClusterAccess(address, certificates)),
    ):
        pass
    assert raised.value.code == "cluster.no_scheduler"


@pytest.mark.parametrize(
    ("address", "url"),
    [
        ("127.0.0.1:8786", "tcp://127.0.0.1:8786"), ("localhost:1", "tcp://localhost:1"),
        ("[::1]:8786", "tcp://[::1]:8786"), ("office-7:8786", "tls://office-7:8786"),
        ("tls://192.168.1.20:8786", "tls://192.168.1.20:8786"),
        ("tcp://127.1.2.3:8786", "tcp://127.1.2.3:8786"),
    ],
)  # fmt: skip
def test_tls_is_the_protocol_to_other_computers(address: str, url: str) -> None:
    access = ClusterAccess(address)
    assert access.url == url
    assert not access.is_open


@pytest.mark.parametrize(
    "address",
    others_long(["tcp://192.168.1.20:8786", "tcp://office-7:8786", "tcp://localhost.evil.org:1"]),
)
def test_plain_tcp_to_other_computers_requires_an_option(
    address: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cluster_module, "CONNECT_TIMEOUT", 0.2)
    assert "--plain-tcp" in run_refused(capsys, "campaign", PORT, "--cluster", address)
    assert ClusterAccess(address, plain_tcp=True).is_open
    code, _, err = run(capsys, "campaign", PORT, "--plain-tcp")
    assert code == 2
    assert "--cluster" in err
