"""The way from one coordinate system to another, by PROJ, or why there is none."""

import re
import warnings

from pyproj import CRS
from pyproj.database import query_crs_info
from pyproj.datadir import get_user_data_dir  # type: ignore[attr-defined]
from pyproj.enums import PJType
from pyproj.network import set_network_enabled  # type: ignore[attr-defined]
from pyproj.transformer import Transformer, TransformerGroup

from lispac.errors import InputError

MOST_NAMED = 2
"""Systems that a sentence names, those on the latest realizations."""


def best_operation(source: CRS, target: CRS, epoch: float | None) -> Transformer:
    """The most accurate operation; refused where PROJ knows none or lacks a grid for it.

    Parameters
    ----------
    epoch : float or None, decimal year

    Raises
    ------
    InputError
    """
    group = _group(source, target)
    known = bool(group.transformers or group.unavailable_operations)
    if not known and _datums_apart(source, target):
        raise InputError(_no_way(source, target))
    if not group.transformers or not group.best_available:
        grids = [
            grid.short_name
            for operation in group.unavailable_operations[:1]
            for grid in operation.grids
            if not grid.available
        ]
        several = len(grids) > 1
        which = f", which {'are' if several else 'is'}"
        needed = f"{', '.join(grids)}{which}" if grids else "a grid file that is"
        geoid = "give the geoid as a file (.gtx, .tif), " if source.is_compound else ""
        raise InputError(
            f"From {source.name} to {target.name} PROJ needs {needed} not on this machine "
            f"and not fetched from the network: {geoid}put {'them' if several else 'it'} into "
            f"{get_user_data_dir()}, or export the points with ellipsoidal heights in the datum "
            "of the trajectory."
        )
    transformer = group.transformers[0]
    if "t_epoch=" in transformer.definition and epoch is None:
        raise InputError(
            f"The shift from {source.name} to {target.name} changes with time: state the date of "
            "the survey as a decimal year (its epoch; at the command line --epoch 2024.5, or "
            "epoch=2024.5 among the options of a line)."
        )
    return transformer


def realizations(system: CRS, target: CRS) -> list[tuple[str, str]]:
    """Code and name of systems alike on the latest realizations of its datum with a way there.

    A datum such as NAD83(CSRS) stands for all its realizations and is tied to none of the frames
    that satellite positioning works in; NAD83(CSRS)v7 is.

    Parameters
    ----------
    system : pyproj.CRS
        A projected or a geographic one.
    """
    known = system.to_epsg()
    # As part of a compound system it has lost the code of its projection.
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
            code = projected.get(name) or _composed(system, base)
        if code and not _is_dead_end(CRS.from_user_input(code).to_3d(), target):
            found.append((code, name))
        if len(found) == MOST_NAMED:
            break
    return found


def _group(source: CRS, target: CRS) -> TransformerGroup:
    set_network_enabled(active=False)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # of missing grids, which the caller says
        return TransformerGroup(source, target, always_xy=True, allow_ballpark=False)


def _datums_apart(source: CRS, target: CRS) -> bool:
    """Whether it is the datums between which there is no way, not the heights."""
    return not source.is_compound or _is_dead_end(source.sub_crs_list[0].to_3d(), target)


def _is_dead_end(source: CRS, target: CRS) -> bool:
    return not _group(source, target).transformers


def _composed(system: CRS, base: str) -> str:
    """What PROJ reads as the projection of ``system`` on another base; empty where it cannot.

    EPSG has a code for a projection on each realization only where somebody asked for one.
    """
    operation = system.coordinate_operation
    known = {} if operation is None else operation.to_json_dict().get("id", {})
    if known.get("authority") != "EPSG" or system.axis_info[0].unit_name != "metre":
        return ""
    # 4400 is easting and northing in metres.
    return (
        f"urn:ogc:def:crs,crs:EPSG::{base},cs:EPSG::4400,coordinateOperation:EPSG::{known['code']}"
    )


def _no_way(source: CRS, target: CRS) -> str:
    horizontal = source.sub_crs_list[0] if source.is_compound else source
    told = f"From {source.name} to {target.name} PROJ knows no way, and no grid file would help"
    found = realizations(horizontal.to_2d(), target)
    if not found:
        return (
            f"{told}: give the code of a system whose datum is tied to {target.name} (epsg.org "
            "lists them), or state another datum of the trajectory, or none where both are in one."
        )
    named = " or ".join(f"{code} ({name})" for code, name in found)
    geodetic = horizontal.geodetic_crs
    assert geodetic is not None
    apart = ", and what its heights are counted from apart from it" if source.is_compound else ""
    return (
        f"{told}: {geodetic.name} stands for all its realizations, and only each of these is "
        f"tied to {target.name}. Give the system on the realization that the survey is in "
        f"(the latest are {named}) with the date of the survey as a decimal year{apart}."
    )
