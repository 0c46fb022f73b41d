"""Reading of a vessel from TOML: mounting, motion and POS errors."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from lispac.errors import InputError
from lispac.io.config.toml_table import TomlTable
from lispac.messages import error
from lispac.project import Triple
from lispac.simulation.pos_error_models import (
    GnssOutage,
    PosErrors,
    StepErrors,
    WhiteNoise,
    combine_models,
)
from lispac.simulation.pos_errors import PosErrorModel
from lispac.simulation.vessel_motion import SMALL_VESSEL, VesselHandling
from lispac.survey.georeferencing import Mounting

MAX_POSITION_ERROR_M, MAX_ATTITUDE_ERROR_DEG, MAX_TIME_S = 1e3, 10.0, 1e9
"""Limits of the given POS errors: position in metres, attitude in degrees, times in seconds."""
POS_ERROR_KINDS = ("gauss-markov", "white", "outage", "jumps")


@dataclass(frozen=True)
class MountingErrors:
    """Differences of the true mounting from the mounting given by the surveyor.

    Attributes
    ----------
    boresight_deg : three of float
        True roll, pitch, yaw; the surveyor starts from zero.
    lever_arm : three of float, metres, body
        Added to the given lever arm.
    range_offset : float, metres
    scan_angle_offset_deg : float
    latency : float, seconds
    """

    boresight_deg: Triple = (0.0, 0.0, 0.0)
    lever_arm: Triple = (0.0, 0.0, 0.0)
    range_offset: float = 0.0
    scan_angle_offset_deg: float = 0.0
    latency: float = 0.0

    def mounting(self, lever_arm: Triple) -> Mounting:
        """True mounting for a given lever arm.

        Parameters
        ----------
        lever_arm : three of float, metres, body frame
            The given lever arm.

        Raises
        ------
        InputError
            If an error exceeds the limits of a mounting.
        """
        for code, values, limit in (
            ("vessel.boresight_too_large", np.radians(self.boresight_deg), np.pi),
            (
                "vessel.scan_angle_offset_too_large",
                np.radians([self.scan_angle_offset_deg]),
                np.pi,
            ),
            ("vessel.lever_arm_error_too_large", np.array(self.lever_arm), 100.0),
            ("vessel.range_offset_too_large", np.array([self.range_offset]), 10.0),
            ("vessel.latency_too_large", np.array([self.latency]), 10.0),
        ):
            largest = float(np.abs(values).max())
            if largest > limit:
                raise InputError(error(code, value=largest, most=limit))
        return Mounting(
            np.array(lever_arm) + np.array(self.lever_arm),
            np.radians(self.boresight_deg),
            self.range_offset,
            float(np.radians(self.scan_angle_offset_deg)),
            self.latency,
        )


@dataclass(frozen=True)
class Vessel:
    """A vessel with its POS.

    Attributes
    ----------
    title : str
    lever_arm : three of float, metres, body
        Lever arm given by the surveyor.
    pos_height : float, metres
        Height of the POS above the zero level of the scene.
    handling : VesselHandling
    errors : MountingErrors
    pos : PosErrors
    """

    title: str
    lever_arm: Triple
    pos_height: float
    handling: VesselHandling
    errors: MountingErrors
    pos: PosErrors


def read_vessel(path: Path) -> Vessel:
    """Read a vessel.

    Raises
    ------
    InputError
        If the content is not valid; the message names the file, the key and the action.
    """
    with TomlTable.read(path, "vessel") as table:
        parts = [_read_pos_errors(part) for part in table.tables("pos")]
        if not parts:
            raise table.refuse("pos", "vessel.no_pos_errors")
        with table.table("errors") as errors:
            found = read_mounting_errors(errors)
        return Vessel(
            table.text("title"), table.three_numbers("lever_arm_m"), table.number("pos_height_m"),
            _read_handling(table), found, combine_models(parts),
        )  # fmt: skip


def read_mounting_errors(table: TomlTable) -> MountingErrors:
    """Read the table of mounting errors."""
    return MountingErrors(
        table.three_numbers("boresight_deg", (0.0, 0.0, 0.0)),
        table.three_numbers("lever_arm_m", (0.0, 0.0, 0.0)),
        table.number("range_offset_m", 0.0),
        table.number("scan_angle_offset_deg", 0.0),
        table.number("latency_s", 0.0),
    )


def _read_handling(table: TomlTable) -> VesselHandling:
    with table.table("handling") as sailed, table.table("motion") as sea:
        speed = sailed.number("speed_m_s", over=0, high=50)
        shortest = sea.number("shortest_s", SMALL_VESSEL.periods[0], over=0)
        return VesselHandling(
            speed=speed,
            speed_abeam=sailed.number("speed_abeam_m_s", speed, over=0, high=speed),
            slow_time=sailed.number("slow_s", SMALL_VESSEL.slow_time, over=0),
            ramp=sailed.number("ramp_s", SMALL_VESSEL.ramp, over=0),
            transit=sailed.number("transit_s", SMALL_VESSEL.transit, over=0),
            wait=sailed.number("wait_s", SMALL_VESSEL.wait, over=0),
            roll=float(np.radians(sea.number("roll_deg", low=0, high=45))),
            pitch=float(np.radians(sea.number("pitch_deg", low=0, high=45))),
            yaw=float(np.radians(sea.number("yaw_deg", low=0, high=45))),
            heave=sea.number("heave_m", low=0),
            drift=sea.number("drift_m", low=0),
            periods=(shortest, sea.number("longest_s", SMALL_VESSEL.periods[1], low=shortest)),
        )


def _read_pos_errors(table: TomlTable) -> PosErrors:
    kind = table.one_of("kind", POS_ERROR_KINDS)
    position = table.three_numbers("position_m", low=0, high=MAX_POSITION_ERROR_M)
    roll, pitch, heading = np.radians(
        table.three_numbers("attitude_deg", low=0, high=MAX_ATTITUDE_ERROR_DEG)
    )
    attitude = (float(roll), float(pitch), float(heading))
    if kind == "gauss-markov":
        return PosErrorModel(
            position, attitude, table.number("position_s", over=0, high=MAX_TIME_S),
            table.number("attitude_s", over=0, high=MAX_TIME_S),
        )  # fmt: skip
    if kind == "white":
        return WhiteNoise(position, attitude)
    if kind == "outage":
        return GnssOutage(
            table.number("start_s", low=0, high=MAX_TIME_S),
            table.number("duration_s", over=0, high=MAX_TIME_S), position, attitude,
            table.boolean("smoothed", True),
        )  # fmt: skip
    step_times = table.numbers("at_s", None, (), low=0)
    return StepErrors(position, attitude, step_times, table.number("per_hour", 0.0, low=0))
