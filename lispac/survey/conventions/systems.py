"""Conventions of other programs, and how reliably each is known.

An angle is the rotation about one axis of the system's own frame; the angles of a system define a
product of three such rotations. Properties that were not found in the documentation or code of the
system are assumptions, which are shown with every number.
"""

from dataclasses import dataclass
from typing import Literal

from lispac.errors import InputError
from lispac.language import N_, LazyText, gettext_lazy
from lispac.messages import Message, error, note
from lispac.survey.conventions.axes import FORWARD_PORT_UP, Axes

Status = Literal["verified", "partly", "unverified"]
Scanner = Literal["turned", "kept", "mounted"]
Direction = Literal["lidar_to_body", "body_to_lidar"]

STATUS_WORDS: dict[Status, str] = {
    "verified": N_("verified"),
    "partly": N_("partly verified"),
    "unverified": N_("not verified"),
}
SCANNER_WORDS: dict[Scanner, str] = {
    "turned": N_(
        "The scanner axes have the same names as the body axes: angles of zero mean that "
        "they are parallel."
    ),
    "kept": N_("The scanner axes are those of the raw points."),
    "mounted": N_(
        "An axis permutation (mounting) first maps the raw scanner axes to the body axes; the "
        "angles are the remaining rotation."
    ),
}
DIRECTION_WORDS: dict[Direction, str] = {  # conversion of coordinates by the matrix
    "lidar_to_body": N_("LiDAR to body"),
    "body_to_lidar": N_("body to LiDAR"),
}

_STARBOARD_DOWN = N_("positive starboard side down")
_BOW_UP = N_("positive bow up")
_CLOCKWISE = N_("positive clockwise seen from above")
_RIGHT_HANDED = N_("right-handed")


ANGLE_CODES = {
    "roll": "quantity.roll",
    "pitch": "quantity.pitch",
    "yaw": "quantity.yaw",
    "heading": "quantity.heading",
    "X rotation": "quantity.x_rotation",
    "Y rotation": "quantity.y_rotation",
    "Z rotation": "quantity.z_rotation",
}
"""Code of the message with the name of each angle."""


@dataclass(frozen=True)
class AxisRotation:
    """Rotation about one axis.

    Attributes
    ----------
    name : name of the angle in the system
    axis : 0, 1 or 2, the axis of rotation in the body frame of the system
    sign : +1 if the matrix is Rx, Ry or Rz of the angle, -1 if it is that of the negative angle
    meaning : description of the sign
    """

    name: str
    axis: int
    sign: int
    meaning: str

    @property
    def title(self) -> Message:
        """Name of the angle as part of a message."""
        return note(ANGLE_CODES[self.name])

    @property
    def factor(self) -> LazyText:
        """Rotation matrix in a formula, such as ``Rz(heading)``."""
        name = gettext_lazy(self.name)
        if self.sign < 0:
            return gettext_lazy("R{axis}(-{angle})", axis="xyz"[self.axis], angle=name)
        return gettext_lazy("R{axis}({angle})", axis="xyz"[self.axis], angle=name)


@dataclass(frozen=True)
class Convention:
    """Convention of a program for boresight and lever arm.

    Attributes
    ----------
    key : name in commands and files
    name : name on the screen and in the report
    axes : body axes of the system
    turns : the three angles in the order of input and lists; empty if the system takes a matrix
        only
    order : indices into ``turns``, factors of the matrix product from the left
    status : degree of verification
    direction : coordinates that the product converts, from LiDAR to body or from body to LiDAR
    scanner : relation of the system's scanner axes to those of the raw points
    open_axes : whether the body axes depend on the device, so that the user has to specify them
    source : document or code from which the convention was taken
    assumption : undocumented properties and their assumed values; shown with every number
    """

    key: str
    name: str
    axes: Axes
    turns: tuple[AxisRotation, ...]
    order: tuple[int, ...]
    status: Status
    source: str
    assumption: str = ""
    direction: Direction = "lidar_to_body"
    scanner: Scanner = "turned"
    open_axes: bool = False

    @property
    def has_angles(self) -> bool:
        """Whether the boresight of the system is given as angles, not only as a matrix."""
        return bool(self.turns)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the angles in the order of ``turns``."""
        return tuple(turn.name for turn in self.turns)

    @property
    def formula(self) -> LazyText:
        """The matrix product, such as ``Rz(heading) · Ry(pitch) · Rx(roll)``."""
        if not self.has_angles:
            return gettext_lazy("matrix only")
        first, middle, last = (self.turns[k].factor for k in self.order)
        return gettext_lazy("{first} · {middle} · {last}", first=first, middle=middle, last=last)


def _z_down_rotations(
    heading: str = N_("heading"),
) -> tuple[AxisRotation, AxisRotation, AxisRotation]:
    # X forward, Y starboard, Z down: all three rotations are right-handed.
    return (
        AxisRotation(N_("roll"), 0, 1, _STARBOARD_DOWN),
        AxisRotation(N_("pitch"), 1, 1, _BOW_UP),
        AxisRotation(heading, 2, 1, _CLOCKWISE),
    )


def _z_up_rotations(
    heading: str = N_("heading"),
) -> tuple[AxisRotation, AxisRotation, AxisRotation]:
    # X starboard, Y forward, Z up: a right-handed rotation about Z is to port.
    return (
        AxisRotation(N_("roll"), 1, 1, _STARBOARD_DOWN),
        AxisRotation(N_("pitch"), 0, 1, _BOW_UP),
        AxisRotation(heading, 2, -1, _CLOCKWISE),
    )


def _left_handed_rotations() -> tuple[AxisRotation, AxisRotation, AxisRotation]:
    # X starboard, Y forward, Z down: the axes are left-handed, so all signs are reversed.
    return (
        AxisRotation(N_("roll"), 1, -1, _STARBOARD_DOWN),
        AxisRotation(N_("pitch"), 0, -1, _BOW_UP),
        AxisRotation(N_("yaw"), 2, -1, _CLOCKWISE),
    )


def _rotations_about_axes() -> tuple[AxisRotation, AxisRotation, AxisRotation]:
    # Right-handed rotations about the axes X, Y and Z.
    return (
        AxisRotation(N_("X rotation"), 0, 1, _RIGHT_HANDED),
        AxisRotation(N_("Y rotation"), 1, 1, _RIGHT_HANDED),
        AxisRotation(N_("Z rotation"), 2, 1, _RIGHT_HANDED),
    )


FORWARD_STARBOARD_DOWN: Axes = ("forward", "starboard", "down")
STARBOARD_FORWARD_DOWN: Axes = ("starboard", "forward", "down")
STARBOARD_FORWARD_UP: Axes = ("starboard", "forward", "up")
HEADING_PITCH_ROLL = (2, 1, 0)
"""Order of the factors from the left, as indices into angles roll, pitch, heading."""

LISPAC_CONVENTION = Convention(
    key="lispac",
    name=N_("LISPAC (as iXblue)"),
    axes=FORWARD_PORT_UP,
    turns=(
        AxisRotation(N_("roll"), 0, 1, N_("positive port side up")),
        AxisRotation(N_("pitch"), 1, 1, N_("positive bow down")),
        AxisRotation(N_("yaw"), 2, -1, _CLOCKWISE),
    ),
    order=HEADING_PITCH_ROLL,
    status="verified",
    source=N_("verified with real vessel data"),
)

SYSTEMS: tuple[Convention, ...] = (
    LISPAC_CONVENTION,
    Convention(
        key="applanix",
        name="Applanix POS MV, LVX, POSPac",
        axes=FORWARD_STARBOARD_DOWN,
        turns=_z_down_rotations(),
        order=HEADING_PITCH_ROLL,
        status="verified",
        source=N_("POS MV and LVX manuals (Tait-Bryan sequence, mounting angles with examples)"),
    ),
    Convention(
        key="qinsy",
        name="Qinsy",
        axes=STARBOARD_FORWARD_UP,
        turns=_z_up_rotations(),
        order=HEADING_PITCH_ROLL,
        status="partly",
        source=N_("Qinsy manual, sign conventions"),
        assumption=N_(
            "The signs are from the manual. The order of the rotations is not documented: "
            "heading, pitch, roll is assumed, and X starboard, Y forward, Z up for the offsets."
        ),
    ),
    Convention(
        key="kluster",
        name="Kluster",
        axes=FORWARD_STARBOARD_DOWN,
        turns=(
            AxisRotation(N_("roll"), 0, 1, N_("positive port side up")),
            AxisRotation(N_("pitch"), 1, 1, _BOW_UP),
            AxisRotation(N_("heading"), 2, 1, _CLOCKWISE),
        ),
        order=HEADING_PITCH_ROLL,
        status="verified",
        source=N_("Kluster's code (rotations, orientation)"),
    ),
    Convention(
        key="caris",
        name="CARIS HIPS",
        axes=STARBOARD_FORWARD_DOWN,
        turns=_left_handed_rotations(),
        order=HEADING_PITCH_ROLL,
        status="partly",
        source=N_("HIPS 7 help, Vessel Editor (axes; mounting pitch and roll)"),
        assumption=N_(
            "The axes (left-handed: X starboard, Y forward, Z down) and the signs of the mounting "
            "angles pitch and roll are from the help. Yaw positive clockwise and the order yaw, "
            "pitch, roll are assumed."
        ),
    ),
    Convention(
        key="novatel",
        name="NovAtel Inertial Explorer, SPAN",
        axes=STARBOARD_FORWARD_UP,
        turns=(
            AxisRotation(N_("X rotation"), 0, 1, N_("right-handed, positive bow up")),
            AxisRotation(N_("Y rotation"), 1, 1, N_("right-handed, positive starboard side down")),
            AxisRotation(
                N_("Z rotation"),
                2,
                1,
                N_("right-handed, positive counter-clockwise seen from above"),
            ),
        ),
        order=(2, 0, 1),
        status="partly",
        source=N_("NovAtel application notes on rotations (intrinsic Z, X, Y; right-handed)"),
        assumption=N_(
            "Axes, order and signs are from the application note, which gives them for the "
            "rotation from vehicle to IMU; here the scanner replaces the IMU. SPAN on OEM7 "
            "defines the vehicle rotation (RBV) in the opposite direction, from the IMU to the "
            "vehicle."
        ),
    ),
    Convention(
        key="opals",
        name="OPALS StripAdjust",
        axes=FORWARD_STARBOARD_DOWN,
        turns=_z_down_rotations(N_("yaw")),
        order=HEADING_PITCH_ROLL,
        status="partly",
        source=N_("StripAdjust documentation (body axes, mounting permutation, degrees)"),
        assumption=N_(
            "Assumed and not checked: order yaw, pitch, roll; right-handed signs; rotations "
            "applied after the mounting."
        ),
        scanner="mounted",
    ),
    Convention(
        key="pdal",
        name="PDAL filters.georeference (scan2imu)",
        axes=FORWARD_STARBOARD_DOWN,
        turns=(),
        order=(),
        status="verified",
        source=N_("PDAL's code (georeference filter, coordinate_system NED)"),
        scanner="kept",
    ),
    Convention(
        key="stripalign",
        name="StripAlign (NED attitude, *)",
        axes=FORWARD_STARBOARD_DOWN,
        turns=_z_down_rotations(N_("yaw")),
        order=HEADING_PITCH_ROLL,
        status="unverified",
        source=N_("StripAlign manual, for the columns of the trajectory only"),
        assumption=N_(
            "The definition of the boresight angles is not documented. They are assumed to follow "
            "the NED attitude of the trajectory: yaw, pitch, roll about Z down, Y starboard, X "
            "forward. The ENU default is not available here."
        ),
    ),
    Convention(
        key="terrascan",
        name="TerraScan, TerraMatch",
        axes=STARBOARD_FORWARD_UP,
        turns=_z_up_rotations(),
        order=HEADING_PITCH_ROLL,
        status="partly",
        source=N_("TerraScan user guide, scanner systems (lever arm axes)"),
        assumption=N_(
            "Only the axes of the lever arm are documented. The angles are assumed to be heading, "
            "pitch, roll: roll positive starboard side down, pitch positive bow up, heading "
            "positive clockwise."
        ),
    ),
    Convention(
        key="phoenix",
        name=N_("Phoenix SpatialExplorer 6 and later"),
        axes=FORWARD_PORT_UP,
        turns=_rotations_about_axes(),
        order=(2, 1, 0),
        status="partly",
        source=N_("Phoenix LiDAR user manual (rotations about fixed IMU X, Y, Z in that order)"),
        assumption=N_(
            "Order and signs are from the manual. The axes depend on the IMU: specify the "
            "directions of its X, Y and Z axes on the vessel."
        ),
        scanner="kept",
        open_axes=True,
    ),
    Convention(
        key="phoenix-1-5",
        name=N_("Phoenix SpatialExplorer 1 to 5"),
        axes=("starboard", "up", "aft"),
        turns=_rotations_about_axes(),
        order=(2, 1, 0),
        status="partly",
        source=N_("Phoenix LiDAR user manual (vehicle frame X right, Y up, Z rear)"),
        assumption=N_(
            "The axes are from the manual. The order of the rotations is not documented for these "
            "versions; that of version 6 is assumed."
        ),
        scanner="kept",
    ),
    Convention(
        key="hypack",
        name="Hypack",
        axes=STARBOARD_FORWARD_DOWN,
        turns=_left_handed_rotations(),
        order=HEADING_PITCH_ROLL,
        status="unverified",
        source=N_("third-party descriptions of the offsets"),
        assumption=N_(
            "Assumed, because not documented: roll positive starboard side down, pitch positive "
            "bow up, order yaw, pitch, roll. The axes X starboard, Y forward, Z down are "
            "left-handed."
        ),
    ),
    Convention(
        key="riprocess",
        name="RIEGL RiPROCESS",
        axes=FORWARD_PORT_UP,
        turns=(),
        order=(),
        status="unverified",
        source=N_("no public documentation was found"),
        assumption=N_(
            "No angles are given for RiPROCESS, because its axes and the order of its rotations "
            "are not documented. The matrix is in the frames of this program: scanner to body, X "
            "forward, Y port, Z up."
        ),
        scanner="kept",
    ),
)
OTHER_SYSTEMS = tuple(each for each in SYSTEMS if each.key != LISPAC_CONVENTION.key)
"""The conventions of other programs."""


def convention_of_key(key: str) -> Convention:
    """Convention with a key, in upper or lower case.

    Raises
    ------
    InputError
        If there is none with this key.
    """
    for each in SYSTEMS:
        if each.key == key.lower():
            return each
    known = tuple(each.key for each in SYSTEMS)
    raise InputError(error("survey.unknown_program", name=key, names=known))
