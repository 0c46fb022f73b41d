"""Archives and compressed files, recognised by their first bytes."""

import zlib
from pathlib import Path

from lispac.errors import InputError
from lispac.messages import error

HEAD_BYTES = 4096
GZIP_SIGNATURE = b"\x1f\x8b\x08"
FORMATS_BY_SIGNATURE = {
    b"PK\x03\x04": "ZIP", b"PK\x05\x06": "ZIP", b"7z\xbc\xaf\x27\x1c": "7z",
    b"Rar!\x1a\x07": "RAR", b"\xfd7zXZ\x00": "xz", b"\x28\xb5\x2f\xfd": "Zstandard",
    b"\x04\x22\x4d\x18": "LZ4",
}  # fmt: skip
ARCHIVE_FORMATS = ("ZIP", "7z", "RAR", "TAR")
"""Formats that hold several files."""
BZIP2_SIGNATURE = b"1AY&SY"
"""Bytes that follow ``BZh`` and the block size in a bzip2 file."""
TAR_SIGNATURE, TAR_SIGNATURE_OFFSET = b"ustar", 257
OFFICE_DOCUMENT_MARKS = (b"[Content_Types].xml", b"mimetypeapplication/vnd.")
"""Beginnings of documents of Microsoft Office and LibreOffice, which are ZIP archives: name of the
first file, for LibreOffice with its content."""


def require_uncompressed(path: Path, *, text: bool = False) -> None:
    """Refuse an archive or a compressed file.

    Parameters
    ----------
    text : bool
        Whether text compressed with gzip is accepted.

    Raises
    ------
    InputError
        If it is an archive, an office document or a compressed file.
    """
    with path.open("rb") as file:
        head = file.read(HEAD_BYTES)
    if any(head.startswith(b"PK") and mark in head[:512] for mark in OFFICE_DOCUMENT_MARKS):
        raise InputError(error("file.office_document", file=str(path)))
    packing = _compression_format(head)
    if not packing or (
        text and head.startswith(GZIP_SIGNATURE) and b"\0" not in (_decompress_head(head) or b"\0")
    ):
        return
    if packing in ARCHIVE_FORMATS:
        raise InputError(error("file.archive", file=str(path), format=packing))
    raise InputError(error("file.compressed", file=str(path), format=packing))


def _compression_format(head: bytes) -> str:
    """Format of an archive or a compressed file by its first bytes; empty for other files."""
    for magic, name in FORMATS_BY_SIGNATURE.items():
        if head.startswith(magic):
            return name
    # Two or three bytes also occur by chance at the beginning of binary records.
    if head.startswith(GZIP_SIGNATURE) and _decompress_head(head) is not None:
        return "gzip"
    if head[:3] == b"BZh" and head[4:10] == BZIP2_SIGNATURE:
        return "bzip2"
    return "TAR" if head[TAR_SIGNATURE_OFFSET:].startswith(TAR_SIGNATURE) else ""


def _decompress_head(head: bytes) -> bytes | None:
    """Decompress the first bytes of a gzip file; None if it is not gzip."""
    try:
        return zlib.decompressobj(zlib.MAX_WBITS | 16).decompress(head, HEAD_BYTES)
    except zlib.error:
        return None
