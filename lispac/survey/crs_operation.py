"""Coordinate operation of PROJ between two systems, or the reason why there is none."""

import re
import warnings

from pyproj import CRS
from pyproj.database import query_crs_info
from pyproj.datadir import get_user_data_dir  # type: ignore[attr-defined]
from pyproj.enums import PJType
from pyproj.network import set_network_enabled  # type: ignore[attr-defined]
from pyproj.transformer import Transformer, TransformerGroup

from lispac.errors import InputError
from lispac.messages import Message, error

MAX_NAMED_SYSTEMS = 2
"""Largest number of systems named in a message; those on the latest realizations are named."""


def best_operation(source: CRS, target: CRS, epoch: float | None) -> Transformer:
    """Most accurate operation between two systems.

    Parameters
    ----------
    epoch : float or None, decimal year

    Raises
    ------
    InputError
        If PROJ has no operation, a grid is missing, or an epoch is required.
    """
    group = _transformer_group(source, target)
    known = bool(group.transformers or group.unavailable_operations)
    if not known and _are_datums_unrelated(source, target):
        raise InputError(_no_operation_error(source, target))
    if not group.transformers or not group.best_available:
        grids = [
            grid.short_name
            for operation in group.unavailable_operations[:1]
            for grid in operation.grids
            if not grid.available
        ]
        raise InputError(_missing_grids_error(source, target, grids))
    transformer = group.transformers[0]
    if "t_epoch=" in transformer.definition and epoch is None:
        raise InputError(error("crs.epoch_missing", source=source.name, target=target.name))
    return transformer


def realizations(system: CRS, target: CRS) -> list[tuple[str, str]]:
    """Codes and names of similar systems on the latest realizations of the same datum.

    Only systems with an operation to ``target`` are included. A datum such as NAD83(CSRS) stands
    for all its realizations and has no relation to the frames of satellite positioning, whereas a
    realization such as NAD83(CSRS)v7 has.

    Parameters
    ----------
    system : pyproj.CRS
        A projected or a geographic system.
    """
    known = system.to_epsg()
    # A system that is part of a compound system lacks the code of its projection.
    system = system if known is None else CRS.from_epsg(known)
    geodetic, operation = system.geodetic_crs, system.coordinate_operation
    if geodetic is None:
        return []
    version = re.compile(re.escape(geodetic.name) + r" ?v(\d+)\w*")
    bases = [
        (int(match[1]), info.code, info.name)
        for info in query_crs_info("EPSG", PJType.GEOGRAPHIC_2D_CRS)
        if (match := version.fullmatch(info.name)) and not info.deprecated
    ]
    projected = {
        info.name: f"EPSG:{info.code}"
        for info in query_crs_info("EPSG", PJType.PROJECTED_CRS)
        if system.is_projected and bases and not info.deprecated
    }
    found: list[tuple[str, str]] = []
    for _, base, name in sorted(bases, reverse=True):
        code = f"EPSG:{base}"
        if system.is_projected and operation is not None:
            name = f"{name} / {operation.name}"
            code = projected.get(name) or _projection_on_base(system, base)
        if code and not _has_no_operation(CRS.from_user_input(code).to_3d(), target):
            found.append((code, name))
        if len(found) == MAX_NAMED_SYSTEMS:
            break
    return found


def _transformer_group(source: CRS, target: CRS) -> TransformerGroup:
    set_network_enabled(active=False)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # grids are missing, which the caller reports
        return TransformerGroup(source, target, always_xy=True, allow_ballpark=False)


def _are_datums_unrelated(source: CRS, target: CRS) -> bool:
    """Whether the datums, not the heights, prevent an operation."""
    return not source.is_compound or _has_no_operation(source.sub_crs_list[0].to_3d(), target)


def _has_no_operation(source: CRS, target: CRS) -> bool:
    return not _transformer_group(source, target).transformers


def _projection_on_base(system: CRS, base: str) -> str:
    """Text for PROJ of the projection of ``system`` on another base; empty if there is none.

    EPSG has codes of a projection only for some of the realizations.
    """
    operation = system.coordinate_operation
    known = {} if operation is None else operation.to_json_dict().get("id", {})
    if known.get("authority") != "EPSG" or system.axis_info[0].unit_name != "metre":
        return ""
    # 4400 is easting and northing in metres.
    return (
        f"urn:ogc:def:crs,crs:EPSG::{base},cs:EPSG::4400,coordinateOperation:EPSG::{known['code']}"
    )


def _missing_grids_error(source: CRS, target: CRS, grids: list[str]) -> Message:
    """Error that PROJ lacks grid files; for some operations the files are unknown."""
    folder = str(get_user_data_dir())
    if not grids:
        code = "crs.grid_missing_geoid" if source.is_compound else "crs.grid_missing"
        return error(code, source=source.name, target=target.name, folder=folder)
    code = "crs.grids_missing_geoid" if source.is_compound else "crs.grids_missing"
    return error(
        code, source=source.name, target=target.name, folder=folder, grids=grids, count=len(grids)
    )


def _no_operation_error(source: CRS, target: CRS) -> Message:
    """Error that PROJ has no operation between two systems."""
    horizontal = source.sub_crs_list[0] if source.is_compound else source
    found = realizations(horizontal.to_2d(), target)
    if not found:
        return error("crs.no_operation", source=source.name, target=target.name)
    geodetic = horizontal.geodetic_crs
    assert geodetic is not None
    return error(
        "crs.datum_ensemble_heights" if source.is_compound else "crs.datum_ensemble",
        source=source.name,
        target=target.name,
        datum=geodetic.name,
        systems=tuple(f"{code} ({name})" for code, name in found),
    )
