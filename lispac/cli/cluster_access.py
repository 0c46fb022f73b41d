"""The cluster that a command is to use, from its options."""

import sys
from argparse import Namespace

from lispac.cli.console import UsageError
from lispac.message_texts import message_text
from lispac.messages import Level, Message
from lispac.workflow.planning.cluster_access import ClusterAccess


def cluster_access(arguments: Namespace) -> ClusterAccess | None:
    """Access to the scheduler from the options; None without ``--cluster``.

    Raises
    ------
    UsageError
        Where an option goes with ``--cluster`` and that is missing.
    LispacError
        Where its address cannot be used.
    """
    if arguments.cluster is None:
        for option in ("cluster_tls", "plain_tcp"):
            if getattr(arguments, option):
                name = option.replace("_", "-")
                raise UsageError(f"{arguments.command}: --{name} requires --cluster.")
        return None
    tls = tuple(arguments.cluster_tls) if arguments.cluster_tls else None
    access = ClusterAccess(arguments.cluster, tls, arguments.plain_tcp)
    if access.is_open:
        warning = Message("cluster.plain_tcp", Level.WARNING, {"address": access.url})
        print(f"warning: {message_text(warning)}", file=sys.stderr)
    return access
