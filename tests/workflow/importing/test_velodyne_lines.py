"""Lines as Velodyne packets: time base, ambiguous hours, and the boresight of a whole survey."""

from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from lispac.cli.main import main
from lispac.errors import InputError
from lispac.io.las.las_format import write_points
from lispac.messages import note
from lispac.project import LineSource, Project, Reading, Settings
from lispac.simulation.motion_source import SailedTrajectory
from lispac.simulation.port_scene import LOCAL_ORIGIN, TARGET_NAMES, port_scene, six_lines
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.simulation.scanner import Scanner
from lispac.simulation.simulated_survey import (
    BORESIGHT_DEG,
    LEVER_ARM,
    POS_HEIGHT,
    SimulatedLine,
    SimulatedSurvey,
    SurveySetup,
    simulate_survey,
)
from lispac.survey.georeferencing import Mounting
from lispac.survey.time_base import GPS_EPOCH, HOUR, WEEK
from lispac.workflow.calibration.estimation import estimate
from lispac.workflow.calibration.picking import pick_target
from lispac.workflow.importing.input_files import InputFiles
from lispac.workflow.planning.simulate import write_trajectory
from lispac.workflow.project.projects import new_project
from lispac.workflow.project.survey import Survey
from tests.support.error_codes import has_code
from tests.support.input_file_samples import LEVER, START, codes_about, import_files, named
from tests.support.trajectory_files import vessel, write_records
from tests.support.velodyne_packets import (
    AZIMUTH_STEP_DEG,
    BLOCKS,
    CHANNELS,
    CYCLE_S,
    ELEVATION_DEG,
    FIRING_S,
    LASERS,
    Sent,
    data_packet,
    point_of,
    position_packet,
    rmc,
    write_pcap,
)

GPS_WEEK, LEAP_SECONDS = 2300, 18
UNIX_OF_WEEK = GPS_EPOCH + GPS_WEEK * WEEK - LEAP_SECONDS
"""Unix time of second 0 of the GPS week."""
EARLIER_S = -25.0
"""Added to all times of the simulated survey, so that its first line crosses a full hour of UTC."""
SEQUENCES_PER_PACKET, PACKETS_PER_TURN = 24, 75
PACKET_S = SEQUENCES_PER_PACKET * CYCLE_S


# -- time bases ------------------------------------------------------------------------------------


def write_line(path: Path, *, gprmc: bool = False, host: float | None = 0.0) -> Path:
    """Write 20 s of packets within the trajectory; ``host`` is the error of the computer."""
    packets = []
    for time in START + 30 + np.arange(0, 20, 0.05):
        utc = UNIX_OF_WEEK + time
        payload = data_packet(utc, np.zeros(BLOCKS), np.full((BLOCKS, CHANNELS), 10.0))
        captured = time - START if host is None else utc + host
        if gprmc and time % 1 < 0.05:
            moment = datetime.fromtimestamp(int(utc), UTC)
            sentence = rmc(f"{moment:%H%M%S}.00", f"{moment:%d%m%y}")
            packets.append(Sent(captured, position_packet(utc, sentence)))
        packets.append(Sent(captured, payload))
    return write_pcap(path, packets)


def write_track(path: Path, seconds: float = 100.0) -> Path:
    records = vessel(max(5000, int(2 * seconds)))
    records[:, 0] = records[0, 0] + np.linspace(0, seconds, len(records))
    write_records(path, records)
    return path


def project_of(folder: Path, track: Path, line: Path, **options: str) -> tuple[Project, Survey]:
    reading = Reading("velodyne", tuple(options.items())) if options else Reading()
    return new_project(
        folder / "p", trajectory=track, lines=[LineSource("L", line, reading=reading)],
        settings=Settings(lever_arm=LEVER),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("gprmc", "host"), [(True, 5 * 3600.0), (False, 20.0), (False, None), (False, 1000.0)]
)
def test_packets_are_placed_on_the_trajectory(
    tmp_path: Path, gprmc: bool, host: float | None
) -> None:
    """By GPRMC, by the clock of the computer, and by the trajectory without either."""
    track = write_track(tmp_path / "pos.sbet")
    line = write_line(tmp_path / "a.pcap", gprmc=gprmc, host=host)
    project, survey = project_of(tmp_path, track, line)
    time = survey.scans["L"].time
    np.testing.assert_allclose(time.min(), START + 30, rtol=0, atol=1e-6)
    (shifted,) = [each for each in survey.notes if each.code == "import.shift_follows"]
    key = "time_base.unix" if gprmc or host == 20.0 else "time_base.utc_hour"
    assert shifted.params["base"] == note("time_base.of_file", base=note(key))
    assert project.lines[0].reading.format == "velodyne"


def test_an_ambiguous_hour_is_refused(tmp_path: Path) -> None:
    track = write_track(tmp_path / "pos.sbet", 5 * 3600.0)
    line = write_line(tmp_path / "a.pcap", host=None)
    with pytest.raises(InputError, check=has_code("import.hour_unknown")) as refused:
        project_of(tmp_path, track, line)
    assert len(refused.value.message.params["shifts"]) == 3  # type: ignore[arg-type]
    line = write_line(tmp_path / "b.pcap", gprmc=True, host=None)
    _, survey = project_of(tmp_path, track, line)
    np.testing.assert_allclose(survey.scans["L"].time.min(), START + 30, rtol=0, atol=1e-6)


def test_the_import_window_shifts_packets(tmp_path: Path) -> None:
    track = write_track(tmp_path / "pos.sbet")
    line = write_line(tmp_path / "a.pcap")
    files = import_files(InputFiles(), track, line)
    file = named(files, "a.pcap")
    assert (file.role, file.format.key) == ("points", "velodyne")
    assert file.shift == pytest.approx(-UNIX_OF_WEEK)
    assert file.content.count == 400 * BLOCKS * CHANNELS
    assert "import.shift_follows" in codes_about(files, "a.pcap")
    long = write_track(tmp_path / "long.sbet", 5 * 3600.0)
    files = import_files(InputFiles(), long, write_line(tmp_path / "b.pcap", host=None))
    assert named(files, "b.pcap").shift == 0
    assert "import.outside_with_shift" in codes_about(files, "b.pcap")


def test_the_command_line_inspects_and_imports_packets(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    track, line = write_track(tmp_path / "pos.sbet"), write_line(tmp_path / "a.pcap", gprmc=True)
    assert main(["inspect", str(line)]) == 0
    shown = capsys.readouterr().out
    assert "VLP-16" in shown
    assert "UTC seconds since 1970-01-01" in shown
    lever = [str(value) for value in LEVER]
    folder = tmp_path / "p"
    command = ["new", str(folder), str(line), "--trajectory", str(track), "--lever-arm", *lever]
    assert main(command) == 0


# -- boresight -------------------------------------------------------------------------------------


FORWARD = np.pi / 2
"""Yaw that turns y, the axis forward in the manual, to x, the axis forward in the program."""


@dataclass(frozen=True)
class Vlp16(Scanner):
    """VLP-16 that turns clockwise, with every 24th firing sequence in a sector to both sides."""

    def turn(self, starboard: bool) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        sequence = np.arange(0, SEQUENCES_PER_PACKET * PACKETS_PER_TURN, 24)
        delay = CYCLE_S * sequence[:, None] + FIRING_S * np.arange(LASERS)
        azimuth = 2 * np.pi * self.turns_per_second * delay
        beam = np.broadcast_to(np.arange(LASERS), delay.shape)
        seen = np.abs(np.sin(azimuth[:, 0])) > np.cos(np.radians(50))
        seen &= (np.sin(azimuth[:, 0]) > 0) == starboard
        return np.pi / 2 - azimuth[seen].ravel(), delay[seen].ravel(), beam[seen].ravel()


@pytest.fixture(scope="module")
def simulated() -> SimulatedSurvey:
    scanner = Vlp16(
        1.0, 1 / (PACKETS_PER_TURN * PACKET_S), elevations=tuple(np.radians(ELEVATION_DEG)),
        axis="z", angle_sigma=0.0, range_sigma=0.01, divergence=0.0,
    )  # fmt: skip
    mounting = Mounting(np.array(LEVER_ARM), np.radians(BORESIGHT_DEG) + [0, 0, FORWARD])
    setup = SurveySetup(
        LOCAL_ORIGIN, port_scene(), TARGET_NAMES, (), SailedTrajectory(six_lines(), POS_HEIGHT),
        HYDROGRAPHIC_INS, scanner, mounting,
    )  # fmt: skip
    survey = simulate_survey(setup, seed=16)
    trajectory = replace(survey.trajectory, time=survey.trajectory.time + EARLIER_S)
    lines = tuple(replace(line, time=line.time + EARLIER_S) for line in survey.lines)
    return replace(survey, trajectory=trajectory, lines=lines)


def returns_of(line: SimulatedLine, start: float) -> tuple[np.ndarray, ...]:
    """Firing sequence, laser and distance of each point of a line."""
    distance = np.linalg.norm(line.points_lidar, axis=1)
    elevation = np.degrees(np.arcsin(line.points_lidar[:, 2] / distance))
    laser = np.argmin(np.abs(elevation[:, None] - ELEVATION_DEG), axis=1)
    sequence = np.rint((line.time - start - FIRING_S * laser) / CYCLE_S).astype(int)
    return sequence, laser, distance


def write_packets(line: SimulatedLine, path: Path, start: float) -> tuple[np.ndarray, np.ndarray]:
    """Write a line as packets; return the same points and times without quantisation."""
    sequence, laser, distance = returns_of(line, start)
    turn_deg = 360.0 / (PACKETS_PER_TURN * SEQUENCES_PER_PACKET)
    packet, rest = np.divmod(sequence, SEQUENCES_PER_PACKET)
    block, half = np.divmod(rest, 2)
    packets = []
    for number in np.unique(packet):
        own = packet == number
        returns = np.zeros((BLOCKS, CHANNELS))
        returns[block[own], LASERS * half[own] + laser[own]] = distance[own]
        first = number * SEQUENCES_PER_PACKET
        azimuth = turn_deg * (first + 2 * np.arange(BLOCKS)) % 360
        utc = UNIX_OF_WEEK + start + number * PACKET_S
        packets.append(Sent(utc + 0.3, data_packet(utc, azimuth, returns, 80)))
    write_pcap(path, packets)
    azimuth = turn_deg * (sequence + FIRING_S / CYCLE_S * laser)
    return point_of(azimuth, distance, laser), line.time


def estimated(
    folder: Path, simulated: SimulatedSurvey, trajectory: tuple[Path, Path], paths: list[Path]
) -> Project:
    settings = Settings(
        lever_arm=LEVER_ARM, boresight_deg=(0.0, 0.0, float(np.degrees(FORWARD))), lidar_sigma=0.01
    )
    project, survey = new_project(
        folder, trajectory=trajectory[0], accuracy=trajectory[1], settings=settings,
        lines=[LineSource(path.stem, path) for path in paths],
    )  # fmt: skip
    for name, seed in simulated.targets.items():
        project = pick_target(project, survey, tuple(map(float, seed)), name=name)
    return estimate(project, survey, cross_check=False)


def test_packets_give_the_same_boresight_as_las(tmp_path: Path, simulated: SimulatedSurvey) -> None:
    utc = UNIX_OF_WEEK + simulated.lines[0].time
    assert utc.min() // HOUR < utc.max() // HOUR
    trajectory = write_trajectory(simulated, tmp_path)
    pcap, las = [], []
    for line in simulated.lines:
        x, y, _ = line.points_lidar[0]
        turned = np.arctan2(x, y) / (2 * np.pi) % 1
        start = float(line.time[0]) - turned * PACKETS_PER_TURN * PACKET_S
        pcap.append(tmp_path / f"{line.name}.pcap")
        las.append(tmp_path / f"{line.name}.las")
        write_points(las[-1], *write_packets(line, pcap[-1], start), np.full(len(line.time), 80.0))
    by_packets = estimated(tmp_path / "packets", simulated, trajectory, pcap)
    by_las = estimated(tmp_path / "las", simulated, trajectory, las)
    assert by_packets.result is not None
    assert by_las.result is not None
    found, expected = by_packets.result.mounting.boresight, by_las.result.mounting.boresight
    sigma = np.sqrt(np.diag(by_packets.result.covariance_all))[:3]
    assert np.abs(np.degrees(found - expected)).max() < AZIMUTH_STEP_DEG / 2
    assert (np.abs(found - expected) < 0.3 * sigma).all()
    assert (np.abs(found - simulated.boresight) < 3 * sigma).all()
    assert np.degrees(sigma).max() < 0.05
