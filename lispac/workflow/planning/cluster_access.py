"""Connection to a dask scheduler with TLS, or with TCP if the user accepts its risk.

Source: dask, distributed, "TLS/SSL".
"""

import ipaddress
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lispac.errors import LispacError
from lispac.io.files import require_file
from lispac.io.value_conversion import failure_summary
from lispac.messages import error

ADDRESS_PATTERN = re.compile(
    r"((?P<protocol>tcp|tls)://)?(?P<host>\[[0-9a-fA-F:]+\]|[^\s:/\[\]]+):\d{1,5}"
)
"""Address of a scheduler: optional protocol, host and port."""


@dataclass(frozen=True)
class ClusterAccess:
    """Address and encryption of the connection to a scheduler.

    dask unpickles the data that a scheduler sends. Anyone who replies at its address can therefore
    run programs on this computer, and anyone who can reach the scheduler can run programs on the
    workers. TLS with certificates prevents both.

    Attributes
    ----------
    address : str
        ``tls://HOST:PORT``, ``tcp://HOST:PORT`` or ``HOST:PORT``, which is TLS unless the host is
        this computer.
    certificates : tuple of 3 Path, optional
        PEM files with the certificate of the authority, the certificate of this client, and its
        key; by default those of dask's configuration.
    plain_tcp : bool
        Whether TCP to another computer is accepted.
    """

    address: str
    certificates: tuple[Path, Path, Path] | None = None
    plain_tcp: bool = False

    @property
    def url(self) -> str:
        """Address with its protocol.

        Raises
        ------
        LispacError
            If the address is not valid, or means plain TCP to another computer without consent.
        """
        found = ADDRESS_PATTERN.fullmatch(self.address)
        if found is None:
            raise LispacError(error("cluster.bad_address", address=self.address))
        here = is_this_computer(found["host"].strip("[]"))
        protocol = found["protocol"] or ("tcp" if here else "tls")
        url = self.address if found["protocol"] else f"{protocol}://{self.address}"
        if protocol == "tcp" and not here and not self.plain_tcp:
            raise LispacError(error("cluster.plain_tcp_refused", address=url))
        return url

    @property
    def is_open(self) -> bool:
        """True if others in the network could read or answer the communication."""
        host = ADDRESS_PATTERN.fullmatch(self.url)
        assert host is not None
        return self.url.startswith("tcp://") and not is_this_computer(host["host"].strip("[]"))

    def security(self) -> Any:
        """Dask's settings of the connection.

        Raises
        ------
        LispacError
            If there are no certificates for TLS, or one of the files cannot be used.
        """
        from distributed.security import Security

        if not self.url.startswith("tls://"):
            return Security()
        if self.certificates is None:
            settings = Security(require_encryption=True)
        else:
            authority, certificate, key = (
                str(require_file(path, "certificate")) for path in self.certificates
            )
            settings = Security(
                require_encryption=True, tls_ca_file=authority, tls_client_cert=certificate,
                tls_client_key=key,
            )  # fmt: skip
        if not settings.tls_ca_file or not settings.tls_client_cert:
            raise LispacError(error("cluster.no_certificates", address=self.url))
        try:
            settings.get_connection_args("client")
        except (OSError, ValueError) as failure:  # ssl.SSLError is an OSError
            raise LispacError(
                error(
                    "cluster.unusable_certificates",
                    address=self.url,
                    reason=failure_summary(failure),
                )
            ) from failure
        return settings


def is_this_computer(host: str) -> bool:
    """True if a host is a loopback address or ``localhost``; other names are not resolved."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"
