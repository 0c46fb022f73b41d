"""Tests of the reader of Velodyne packets, on packets written from Velodyne's published layout."""

import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lispac.errors import InputError
from lispac.io.format_types import FilePreview, PointChunk
from lispac.io.formats import format_of, recognise_formats
from lispac.io.points import velodyne
from lispac.io.points.line_times import read_line_times
from lispac.io.points.velodyne import utc_of_rmc
from tests.support.error_codes import has_code
from tests.support.message_codes import codes
from tests.support.velodyne_packets import (
    AZIMUTH_STEP_DEG,
    BLOCKS,
    CHANNELS,
    DISTANCE_STEP_M,
    DUAL,
    LAST,
    STRONGEST,
    TOP_OF_HOUR,
    UTC,
    Sent,
    Turning,
    data_packet,
    position_packet,
    rmc,
    sorted_rows,
    write_pcap,
    write_pcapng,
)

VELODYNE = format_of("velodyne")
RNG = np.random.default_rng(40)
HOUR = 3600.0
TIME_TOLERANCE_S = 1e-6


def still(seconds: float, **options: Any) -> bytes:
    """Packet of a scanner at rest, with all returns at 10 m."""
    return data_packet(seconds, np.zeros(BLOCKS), np.full((BLOCKS, CHANNELS), 10.0), **options)


def whole(path: Path, **choice: str) -> PointChunk:
    chunks = list(VELODYNE.read(path, choice))
    assert all(isinstance(chunk, PointChunk) for chunk in chunks)
    return PointChunk(
        np.concatenate([chunk.xyz for chunk in chunks]),
        np.concatenate([chunk.time for chunk in chunks]),
        {name: np.concatenate([c.extra[name] for c in chunks]) for name in chunks[0].extra},
    )


def preview(path: Path, **choice: str) -> FilePreview:
    return VELODYNE.preview(path, choice)


def of_stamps(path: Path, *stamps: tuple[float, float], more: tuple[Sent, ...] = ()) -> Path:
    """Write packets with the time of the computer and the time of the scanner."""
    return write_pcap(path, [*more, *(Sent(host, still(seconds)) for host, seconds in stamps)])


@pytest.mark.parametrize("mode", [STRONGEST, LAST, DUAL])
def test_points_are_those_of_the_manual(tmp_path: Path, mode: int) -> None:
    """Within the steps of the format, 2 mm and 0.01 deg, and a microsecond."""
    sent = Turning(RNG, mode=mode)
    read = whole(write_pcap(tmp_path / "a.pcap", sent.packets))
    assert len(read.xyz) == len(sent.xyz)
    order, wanted = (
        sorted_rows(read.time, read.extra["ring"], read.xyz),
        sorted_rows(sent.time, sent.ring, sent.xyz),
    )
    xyz, truth = read.xyz[order], sent.xyz[wanted]
    np.testing.assert_allclose(read.time[order], sent.time[wanted], rtol=0, atol=TIME_TOLERANCE_S)
    np.testing.assert_array_equal(read.extra["ring"][order], sent.ring[wanted])
    np.testing.assert_array_equal(read.extra["intensity"][order], sent.intensity[wanted])
    np.testing.assert_allclose(xyz[:, 2], truth[:, 2], atol=1e-4)
    horizontal, expected = np.hypot(*xyz[:, :2].T), np.hypot(*truth[:, :2].T)
    np.testing.assert_allclose(horizontal, expected, atol=DISTANCE_STEP_M / 10)
    turned = np.degrees(np.arctan2(xyz[:, 0], xyz[:, 1]) - np.arctan2(truth[:, 0], truth[:, 1]))
    off = (turned + 180) % 360 - 180
    assert np.abs(off).max() < AZIMUTH_STEP_DEG
    assert abs(off.mean()) < AZIMUTH_STEP_DEG / 10
    types = {STRONGEST: {1}, LAST: {2}, DUAL: {1, 2, 3}}[mode]
    assert set(read.extra["return_type"].tolist()) == types


def test_times_are_as_exact_at_any_place_of_a_chunk(tmp_path: Path) -> None:
    sent = Turning(RNG, count=700)
    read = whole(write_pcap(tmp_path / "a.pcap", sent.packets))
    np.testing.assert_allclose(read.time, sent.time, rtol=0, atol=3e-7)


def test_equal_returns_are_one_point(tmp_path: Path) -> None:
    distance = np.full((BLOCKS, CHANNELS), 10.0)
    distance[1::2, :8] = 12.0  # the strongest return of the first eight lasers
    payload = data_packet(800.0, np.zeros(BLOCKS), distance, mode=DUAL)
    path = write_pcap(tmp_path / "a.pcap", [Sent(UTC, payload)])
    read = whole(path)
    numbers = dict(zip(*np.unique(read.extra["return_type"], return_counts=True), strict=True))
    assert numbers == {1: 48, 2: 48, 3: 144}
    near = np.linalg.norm(read.xyz[read.extra["return_type"] == 2], axis=1)
    far = np.linalg.norm(read.xyz[read.extra["return_type"] == 1], axis=1)
    np.testing.assert_allclose([near.max(), far.min()], [10, 12], atol=0.02)
    assert read_line_times(path, VELODYNE, {}).count == 240
    assert preview(path).facts["returns"].code == "fact.returns_dual"  # type: ignore[union-attr]


WRITERS: dict[str, Callable[[Path, list[Sent]], Path]] = {
    "little": write_pcap,
    "big": lambda path, packets: write_pcap(path, packets, order=">"),
    "nano": lambda path, packets: write_pcap(path, packets, nano=True),
    "vlan": lambda path, packets: write_pcap(path, packets, vlan=True),
    "pcapng": write_pcapng,
}


@pytest.mark.parametrize("kind", WRITERS)
def test_all_kinds_of_captures_are_read_alike(tmp_path: Path, kind: str) -> None:
    sent = Turning(np.random.default_rng(1), count=5)
    others = [Sent(UTC, bytes(40)), Sent(UTC, bytes(1206)), Sent(UTC, bytes(512))]
    expected = whole(write_pcap(tmp_path / "b.pcap", sent.packets))
    path = WRITERS[kind](tmp_path / "a.pcap", [*others, *sent.packets])
    assert VELODYNE.sniff(path) == 1
    assert [found.key for found, _ in recognise_formats(path, "points")] == ["velodyne"]
    read = whole(path)
    np.testing.assert_array_equal(read.xyz, expected.xyz)
    np.testing.assert_array_equal(read.time, expected.time)


def gnss(host: float, seconds: float, sentence: bytes, **options: Any) -> Sent:
    return Sent(host, position_packet(seconds, sentence, **options))


def test_the_hour_comes_from_gprmc(tmp_path: Path) -> None:
    """The clock of the computer is 5 h off; the sentence arrives half a second later."""
    for k, talker in enumerate(("GP", "GN")):
        fix = gnss(UTC + 5 * HOUR + 0.3, 800.6, rmc(talker=talker))
        path = of_stamps(tmp_path / f"{k}.pcap", (UTC + 5 * HOUR + 0.2, 800.5), more=(fix,))
        np.testing.assert_allclose(whole(path).time[0], UTC + 0.5, rtol=0, atol=1e-6)
        found = preview(path)
        assert (found.choice["hour_from"], found.choice["time_base"]) == ("gprmc", "unix")
        assert "assumed.hour_gprmc" in codes(found.assumptions)
        assert found.file_warnings == ()


def test_the_hour_comes_from_gprmc_just_before_the_full_hour(tmp_path: Path) -> None:
    """The sentence is of the second before the hour and arrives after it."""
    fix = gnss(50.9, 0.4, rmc("215959.00"))
    path = of_stamps(tmp_path / "a.pcap", (50.0, 3599.5), (50.6, 0.1), more=(fix,))
    starts = whole(path).time[:: BLOCKS * CHANNELS]
    np.testing.assert_allclose(starts, TOP_OF_HOUR + np.array([-0.5, 0.1]), rtol=0, atol=1e-6)


def test_the_hour_comes_from_the_computer(tmp_path: Path) -> None:
    path = of_stamps(tmp_path / "a.pcap", (UTC + 12.0, 800.0))
    assert whole(path).time[0] == UTC
    found = preview(path)
    assert (found.choice["hour_from"], found.choice["time_base"]) == ("capture", "unix")
    (assumed,) = [each for each in found.assumptions if each.code == "assumed.hour_capture"]
    assert assumed.params["difference"] == pytest.approx(12.0)


def test_the_hour_is_left_to_the_trajectory(tmp_path: Path) -> None:
    """The clock of the computer is half an hour off, or shows no date."""
    for k, host in enumerate((UTC + HOUR / 2, 0.0)):
        path = of_stamps(tmp_path / f"{k}.pcap", (host, 800.0), (host + 0.5, 800.5))
        assert whole(path).time.min() == 800.0
        found = preview(path)
        assert (found.choice["hour_from"], found.choice["time_base"]) == ("trajectory", "utc-hour")
        assert "assumed.hour_trajectory" in codes(found.assumptions)


def test_the_source_of_the_hour_can_be_given(tmp_path: Path) -> None:
    path = of_stamps(tmp_path / "a.pcap", (UTC + 200.0, 800.0), more=(gnss(UTC, 800.0, rmc()),))
    assert whole(path, hour_from="gprmc").time[0] == UTC
    assert whole(path, hour_from="trajectory").time[0] == 800.0
    assert whole(path, hour_from="capture").time[0] == UTC
    bare = of_stamps(tmp_path / "b.pcap", (12.0, 800.0))
    with pytest.raises(InputError, check=has_code("velodyne.no_gprmc")):
        whole(bare, hour_from="gprmc")
    with pytest.raises(InputError, check=has_code("velodyne.no_date")):
        whole(bare, hour_from="capture")


def test_a_clock_that_is_not_synchronised_is_reported(tmp_path: Path) -> None:
    path = of_stamps(tmp_path / "a.pcap", (UTC, 100.0), more=(gnss(UTC, 100.0, rmc()),))
    found = preview(path)
    (reported,) = [w for w in found.file_warnings if w.code == "velodyne.not_synchronised"]
    assert reported.params["difference"] == pytest.approx(700.0)
    assert found.choice["hour_from"] == "trajectory"
    free = of_stamps(tmp_path / "b.pcap", (UTC, 800.0), more=(gnss(UTC, 800.0, rmc(), pps=0),))
    assert codes(preview(free).file_warnings) == ["velodyne.no_pps"]


def test_sentences_without_a_position_are_not_used(tmp_path: Path) -> None:
    assert utc_of_rmc(rmc("221320.50")) == UTC + 0.5
    damaged = rmc().replace(b"4826", b"4827")
    for sentence in (rmc(status="V"), damaged, b"$GPGGA,221320*00", b"$GPRMC", b"", rmc("99", "")):
        assert utc_of_rmc(sentence) is None
        path = of_stamps(tmp_path / "a.pcap", (0.0, 800.0), more=(gnss(0.0, 800.0, sentence),))
        assert preview(path).choice["hour_from"] == "trajectory"


def test_times_continue_after_full_hours_and_pauses(tmp_path: Path) -> None:
    """Full hour within the recording, a pause of 3 h, and two packets in the wrong order."""
    base = TOP_OF_HOUR + 3 * HOUR
    passed = np.array([-0.002, 0.001, -0.001, 0.002, 3 * HOUR + 5.0, 3 * HOUR + 5.001])
    stamps = [(base + t + 3.0, (base + t) % HOUR) for t in passed]
    read = whole(of_stamps(tmp_path / "a.pcap", *stamps))
    np.testing.assert_allclose(read.time[::384], base + passed, rtol=0, atol=TIME_TOLERANCE_S)
    # The times of all points of a packet are within a microsecond, whatever the pause.
    np.testing.assert_allclose(read.time[384 * 4 + 1] - read.time[384 * 4], 2.304e-6, atol=1e-6)


def test_a_step_of_the_computer_does_not_change_the_times(tmp_path: Path) -> None:
    stamps = [(UTC, 800.0), (UTC + 0.01, 800.01), (UTC + 7000.0, 800.02), (UTC + 7000.1, 800.03)]
    read = whole(of_stamps(tmp_path / "a.pcap", *stamps))
    np.testing.assert_allclose(read.time[::384], UTC + np.arange(4) * 0.01, rtol=0, atol=1e-6)


def test_a_step_of_the_scanner_is_refused(tmp_path: Path) -> None:
    """Its clock is set when the receiver finds satellites."""
    stamps = [(UTC, 100.0), (UTC + 0.01, 100.01), (UTC + 0.02, 800.02)]
    with pytest.raises(InputError, check=has_code("velodyne.clock_set")) as refused:
        whole(of_stamps(tmp_path / "a.pcap", *stamps))
    assert refused.value.message.params["step"] == pytest.approx(700.0)


def test_memory_is_bounded_and_chunks_do_not_matter(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sent = Turning(np.random.default_rng(2), count=50)
    path = write_pcap(tmp_path / "a.pcap", sent.packets)
    expected = whole(path)
    monkeypatch.setattr(velodyne, "PACKETS_PER_CHUNK", 7)
    chunks = list(VELODYNE.read(path, {}))
    assert max(len(chunk.time) for chunk in chunks) <= 7 * BLOCKS * CHANNELS
    np.testing.assert_array_equal(np.concatenate([c.xyz for c in chunks]), expected.xyz)
    times = np.concatenate([chunk.time for chunk in chunks])
    np.testing.assert_allclose(times, expected.time, rtol=0, atol=TIME_TOLERANCE_S)


def test_the_number_of_points_is_estimated(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    sent = Turning(np.random.default_rng(2), count=200)
    path = write_pcap(tmp_path / "a.pcap", sent.packets)
    monkeypatch.setattr(velodyne, "FIRST_PACKETS", 20)
    about = preview(path).facts["points"]
    assert about.code == "fact.about"  # type: ignore[union-attr]
    assert about.params["count"] == pytest.approx(len(sent.xyz), rel=0.02)  # type: ignore[union-attr]


def test_several_scanners_are_numbered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The second scanner begins after the packets that are examined first."""
    monkeypatch.setattr(velodyne, "FIRST_PACKETS", 3)
    one, two = Turning(RNG, count=8), Turning(RNG, start=UTC + 0.0005, count=4)
    for packet in two.packets:
        packet.sender = "192.168.1.202"
    packets = [*one.packets[:4], *two.packets, *one.packets[4:]]
    read = whole(write_pcap(tmp_path / "a.pcap", packets))
    for number, sent in enumerate((one, two)):
        own = read.extra["scanner_channel"] == number
        np.testing.assert_allclose(np.sort(read.time[own]), np.sort(sent.time), rtol=0, atol=1e-6)


@pytest.mark.parametrize(
    ("options", "code", "params"),
    [
        ({"model": 0x31}, "velodyne.model", {"model": "Velarray"}),
        ({"model": 0x99}, "velodyne.model", {"model": "0x99"}),
        ({"mode": 0x3B}, "velodyne.returns", {"mode": "0x3B"}),
    ],
)
def test_packets_that_cannot_be_decoded_are_refused(
    tmp_path: Path, options: dict[str, int], code: str, params: dict[str, str]
) -> None:
    path = write_pcap(tmp_path / "a.pcap", [Sent(UTC, still(800.0, **options))])
    for task in (lambda: preview(path), lambda: whole(path)):
        with pytest.raises(InputError, check=has_code(code)) as refused:
            task()
        assert params.items() <= refused.value.message.params.items()


def test_hdl_64e_is_refused(tmp_path: Path) -> None:
    """Its second block is of the lower lasers, and its last byte is a state."""
    payload = bytearray(still(800.0))
    payload[100:102] = b"\xff\xdd"
    path = write_pcap(tmp_path / "a.pcap", [Sent(UTC, bytes(payload))])
    with pytest.raises(InputError, check=has_code("velodyne.model")) as refused:
        preview(path)
    assert refused.value.message.params["model"] == "HDL-64E"


def test_several_models_at_one_address_are_refused(tmp_path: Path) -> None:
    packets = [Sent(UTC, still(800.0)), Sent(UTC + 0.01, still(800.01, model=0x24))]
    with pytest.raises(InputError, check=has_code("velodyne.several_models")):
        whole(write_pcap(tmp_path / "a.pcap", packets))


def test_captures_of_other_devices_are_refused(tmp_path: Path) -> None:
    path = write_pcap(tmp_path / "a.pcap", [Sent(UTC, bytes(1206)), Sent(UTC, bytes(100))])
    for task in (lambda: preview(path), lambda: whole(path)):
        with pytest.raises(InputError, check=has_code("velodyne.no_packets")):
            task()
    assert 0 < VELODYNE.sniff(path) < 1
    none = write_pcap(tmp_path / "b.pcap", [Sent(UTC, still(800.0).replace(b"\x88\x13", b"\0\0"))])
    with pytest.raises(InputError, check=has_code("file.no_points")):
        preview(none)


@pytest.mark.parametrize("write", [write_pcap, write_pcapng])
def test_cut_captures_are_refused_wherever_they_end(
    tmp_path: Path, write: Callable[[Path, list[Sent]], Path]
) -> None:
    sent = Turning(np.random.default_rng(3), count=3)
    path = write(tmp_path / "a.pcap", sent.packets)
    content = path.read_bytes()
    one = write(tmp_path / "b.pcap", sent.packets[:2]).stat().st_size
    for size in (one + 1, one + 7, one + 15, one + 16, one + 20, len(content) - 1):
        if write is write_pcapng and size == one + 16:
            continue
        path.write_bytes(content[:size])
        with pytest.raises(InputError, check=has_code("capture.cut")):
            whole(path)
    path.write_bytes(content[:one])
    assert len(np.unique(np.round(whole(path).time - UTC, 4))) > 1


def test_records_of_impossible_size_are_refused(tmp_path: Path) -> None:
    path = write_pcap(tmp_path / "a.pcap", [Sent(UTC, still(800.0)), Sent(UTC, still(800.1))])
    content = bytearray(path.read_bytes())
    struct.pack_into("<I", content, 24 + 8, 0xFFFFFFF0)
    path.write_bytes(content)
    with pytest.raises(InputError, check=has_code("capture.record_size")):
        whole(path)
