"""Options for parallel processes and a cluster, shared by the commands that simulate or search."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import whole_number_from
from lispac.cli.console import UsageError
from lispac.cli.messages import print_messages
from lispac.messages import Level, Message

if TYPE_CHECKING:
    from lispac.workflow.planning.cluster_access import ClusterAccess


def add_worker_options(parser: ArgumentParser) -> None:
    """Add the options for the processes or the cluster that compute."""
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--workers",
        type=whole_number_from(1),
        metavar="N",
        help="number of parallel processes (default: all cores)",
    )
    where.add_argument(
        "--cluster", metavar="ADDRESS",
        help="run on the workers of this Dask scheduler instead of this computer: tls://HOST:PORT",
    )  # fmt: skip
    parser.add_argument(
        "--cluster-tls", nargs=3, type=Path, metavar=("CA", "CERTIFICATE", "KEY"),
        help="PEM files: certificate of the authority, certificate of this computer and its key "
             "(default: from the dask configuration)",
    )  # fmt: skip
    parser.add_argument(
        "--plain-tcp", action="store_true",
        help="allow unencrypted tcp:// connections to another computer; others in the network can "
             "then run programs on this computer and on the workers",
    )  # fmt: skip


def cluster_access(arguments: Namespace) -> ClusterAccess | None:
    """Access to the scheduler from the options; None without ``--cluster``.

    Raises
    ------
    UsageError
        If an option that requires ``--cluster`` is given without it.
    LispacError
        If the address of the scheduler cannot be used.
    """
    from lispac.workflow.planning.cluster_access import ClusterAccess

    if arguments.cluster is None:
        for option in ("cluster_tls", "plain_tcp"):
            if getattr(arguments, option):
                name = option.replace("_", "-")
                raise UsageError(f"{arguments.command}: --{name} requires --cluster.")
        return None
    tls = tuple(arguments.cluster_tls) if arguments.cluster_tls else None
    access = ClusterAccess(arguments.cluster, tls, arguments.plain_tcp)
    if access.is_open:
        print_messages([Message("cluster.plain_tcp", Level.WARNING, {"address": access.url})])
    return access
