"""Points as the 3D library draws them."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from lispac.gui.viewport.base import Array, Colour
from lispac.gui.viewport.camera import VIEW_ANGLE, Camera

EDGE: Colour = (62, 70, 78)
"""Of shaded points."""


def point_data(points: Array, shades: NDArray[np.uint8] | None = None) -> vtkPolyData:
    """Points as one cell.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, from an origin near them
    shades : uint8 ndarray of shape (n, 3), optional
        Their colours, for actors that are `shaded`.
    """
    count = len(points)
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=np.float32)))
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(np.array([0, count], dtype=np.int64), deep=True),
        numpy_to_vtkIdTypeArray(np.arange(count, dtype=np.int64), deep=True),
    )
    data = vtkPolyData()
    data.SetPoints(coordinates)
    data.SetVerts(cells)
    if shades is not None:
        data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(shades), deep=True))
    return data


def half_space() -> vtkPlane:
    """What lies on the side its normal points to; of everything else nothing is drawn."""
    return vtkPlane()


def place_half(half: vtkPlane, point: Array, normal: Array) -> None:
    """Put its plane through a point, shape (3,), across ``normal``."""
    half.SetOrigin(*point)
    half.SetNormal(*normal)


def confine(actors: Iterable[vtkActor], half: vtkPlane | None) -> None:
    """Draw only what lies in a half space, or all of the actors."""
    for actor in actors:
        mapper = actor.GetMapper()
        mapper.RemoveAllClippingPlanes()
        if half is not None:
            mapper.AddClippingPlane(half)


def point_actor(data: vtkPolyData, colour: Colour, *, shaded: bool = False) -> vtkActor:
    """Unlit points of one colour, or each of its own."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    if shaded:
        mapper.ScalarVisibilityOn()
        mapper.SetColorModeToDirectScalars()
    else:
        mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    paint(actor, colour)
    return actor


def paint(actor: vtkActor, colour: Colour) -> None:
    """Give all its points one colour."""
    actor.GetProperty().SetColor(*(c / 255.0 for c in colour))


def dark(colour: Colour) -> Colour:
    """A darker one, for edges."""
    red, green, blue = colour
    return red // 2, green // 2, blue // 2


def size_points(actors: Iterable[vtkActor], pixels: float) -> None:
    """Size of their points, in pixels of the screen."""
    for actor in actors:
        actor.GetProperty().SetPointSize(pixels)


def shift_depth(actor: vtkActor, camera: Camera, origin: Array, part: float) -> None:
    """Draw an actor deeper by a part of its distance, at the same pixels.

    Scaled about the eye nothing else moves; in a parallel projection it is pushed along the view.
    """
    if camera.parallel:
        actor.SetScale(1.0)
        actor.SetPosition(*(part * camera.distance * camera.axes[2]))
        return
    actor.SetScale(1.0 + part)
    actor.SetPosition(*(-part * (camera.position - origin)))


def aim(renderer: vtkRenderer, camera: Camera, origin: Array) -> None:
    """Let a renderer look as a camera does."""
    eye = renderer.GetActiveCamera()
    eye.SetViewAngle(np.degrees(VIEW_ANGLE))
    eye.SetParallelProjection(camera.parallel)
    eye.SetParallelScale(camera.distance * np.tan(0.5 * VIEW_ANGLE))
    eye.SetPosition(*(camera.position - origin))
    eye.SetFocalPoint(*(camera.focal - origin))
    eye.SetViewUp(*camera.axes[1])
    renderer.ResetCameraClippingRange()
