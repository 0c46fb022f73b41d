"""VTK actors for points."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

from lispac.gui.viewport.base import Array, Colour
from lispac.gui.viewport.camera import VIEW_ANGLE, Camera


def point_polydata(points: Array, shades: NDArray[np.uint8] | None = None) -> vtkPolyData:
    """VTK data of points as one cell.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, relative to an origin near them
    shades : uint8 ndarray of shape (n, 3), optional
        Colour of each point, for a `point_actor` with ``shaded=True``.
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


def create_renderer(window: vtkRenderWindow) -> vtkRenderer:
    """Renderer of a part of a window."""
    renderer = vtkRenderer()
    window.AddRenderer(renderer)
    return renderer


def place_renderer(renderer: vtkRenderer, part: tuple[float, float, float, float]) -> None:
    """Set the part of the window: left, top, width and height, shares of its size."""
    left, top, width, height = part
    renderer.SetViewport(left, 1.0 - top - height, left + width, 1.0 - top)


def half_space() -> vtkPlane:
    """Clipping plane that keeps the side to which its normal points."""
    return vtkPlane()


def set_half_space(half: vtkPlane, point: Array, normal: Array) -> None:
    """Set the clipping plane through a point, shape (3,), perpendicular to ``normal``."""
    half.SetOrigin(*point)
    half.SetNormal(*normal)


def clip_actors(actors: Iterable[vtkActor], half: vtkPlane | None) -> None:
    """Clip actors to a half space, or remove their clipping."""
    for actor in actors:
        mapper = actor.GetMapper()
        mapper.RemoveAllClippingPlanes()
        if half is not None:
            mapper.AddClippingPlane(half)


def point_actor(data: vtkPolyData, colour: Colour, *, shaded: bool = False) -> vtkActor:
    """Actor of unlit points in one colour, or with a colour for each point."""
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
    set_actor_colour(actor, colour)
    return actor


def set_actor_colour(actor: vtkActor, colour: Colour) -> None:
    """Set one colour for all points of an actor."""
    actor.GetProperty().SetColor(*(c / 255.0 for c in colour))


def darker_colour(colour: Colour) -> Colour:
    """Darker colour, for edges."""
    red, green, blue = colour
    return red // 2, green // 2, blue // 2


def set_point_pixels(actors: Iterable[vtkActor], pixels: float) -> None:
    """Set the size of the points of actors, in pixels of the screen."""
    for actor in actors:
        actor.GetProperty().SetPointSize(pixels)


def shift_depth(actor: vtkActor, camera: Camera, origin: Array, part: float) -> None:
    """Increase the depth of an actor by a share of its distance, without moving its pixels.

    A negative ``part`` moves it towards the eye. In perspective, the actor is scaled about the eye;
    in a parallel projection, it is shifted along the direction of view.
    """
    if camera.parallel:
        actor.SetScale(1.0)
        actor.SetPosition(*(part * camera.distance * camera.axes[2]))
        return
    actor.SetScale(1.0 + part)
    actor.SetPosition(*(-part * (camera.position - origin)))


def set_renderer_camera(renderer: vtkRenderer, camera: Camera, origin: Array) -> None:
    """Set the camera of a renderer."""
    eye = renderer.GetActiveCamera()
    eye.SetViewAngle(np.degrees(VIEW_ANGLE))
    eye.SetParallelProjection(camera.parallel)
    eye.SetParallelScale(camera.distance * np.tan(0.5 * VIEW_ANGLE))
    eye.SetPosition(*(camera.position - origin))
    eye.SetFocalPoint(*(camera.focal - origin))
    eye.SetViewUp(*camera.axes[1])
    renderer.ResetCameraClippingRange()
