"""What a feature adds to the window: actions, dialogues, panels and controllers."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar, runtime_checkable

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtWidgets import QWidget

from lispac.gui.app.actions import ActionRecord, Actions
from lispac.gui.app.mouse_tool import MouseTool
from lispac.gui.app.questions import Questions
from lispac.gui.app.settings import AppSettings
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.project.computations import Computations
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.project.status import ProjectState
from lispac.gui.viewport.base import Viewport
from lispac.gui.viewport.clipping import Box

DialogsT = TypeVar("DialogsT", bound=Questions)


@dataclass(frozen=True)
class DockPlace:
    """Dock of a panel at a side of the window; the docks of one side are tabs.

    Attributes
    ----------
    title : English title
    has_content : whether the panel has something to show
    opens : whether the dock opens by itself when the panel has something to show
    accompanies : whether a dock that opens by itself waits until another one opens
    """

    title: str
    area: Qt.DockWidgetArea
    has_content: Callable[[ProjectState], bool]
    opens: bool = False
    accompanies: bool = False


@dataclass(frozen=True)
class WindowPlace:
    """Window of its own for a panel, which an action opens.

    Attributes
    ----------
    title : English title
    width, height : first size, pixels
    action : name of the action
    spares_view : whether it covers as little as possible of the 3D view when it first opens
    narrow_width : width with which it first opens over the workflow panel if it would cover the 3D
        view otherwise, pixels; 0 for none
    """

    title: str
    width: int
    height: int
    action: str
    spares_view: bool = False
    narrow_width: int = 0

    @property
    def size(self) -> QSize:
        """First size, pixels."""
        return QSize(self.width, self.height)


Place = DockPlace | WindowPlace


@dataclass(frozen=True)
class WindowParts(Generic[DialogsT]):
    """Parts of a window that controllers of features use.

    Only the `connect` functions get it, and pass to a controller the parts that this one needs.

    Attributes
    ----------
    dialogs : dialogues of all features; a feature uses those of its own class
    clip_box : function that returns the clip box, or None while there is none
    """

    document: Document
    runner: TaskRunner
    scene: Scene
    viewport: Viewport
    controller: Controller
    computations: Computations
    dialogs: DialogsT
    settings: AppSettings
    actions: Actions
    mouse_tool: MouseTool
    clip_box: Callable[[], Box | None]


@runtime_checkable
class StateCopier(Protocol):
    """A controller that copies its state when the window is rebuilt."""

    def copy_state_from(self, former: Any) -> None:
        """Copy the state of the controller of the former window."""


@dataclass(frozen=True)
class PanelRecord:
    """Description of a panel that is not connected with the panels of other features.

    A panel with a method `show_state` shows the project after every change. When the window is
    rebuilt, ``copy_state_from`` of the controller is called if there is one; else the fields of the
    panel are copied.

    Attributes
    ----------
    name : name of the panel, by which `Panels` finds it
    create : function that creates the panel, without arguments
    connect : function that creates the controller of the panel; None if it needs none
    """

    name: str
    place: Place
    create: Callable[[], QWidget]
    connect: Callable[[Any, WindowParts[Any]], QObject] | None = None


@dataclass(frozen=True)
class Feature:
    """Description of a feature, from which the window is assembled.

    Attributes
    ----------
    actions : actions by name, whose functions the controllers connect
    dialogs : class with the dialogues of the feature; None if it has none
    panels : panels that the window does not connect with those of other features
    connect : function that creates the controllers that belong to no panel, and returns the one
        whose state is copied when the window is rebuilt; None if there are none, or if the window
        connects them with other features
    """

    actions: Mapping[str, ActionRecord]
    dialogs: type[Questions] | None = None
    panels: tuple[PanelRecord, ...] = ()
    connect: Callable[[WindowParts[Any]], object] | None = None
