"""Packs a folder as .tar.gz, .zip or .whl so that the same files give the same bytes: sorted, one owner, the time in SOURCE_DATE_EPOCH.

    archive.py tar|zip FOLDER NAME ARCHIVE       NAME is the folder inside the archive
    archive.py wheel FOLDER ARCHIVE              writes a new RECORD, the list of the wheel's files with their checksums
"""

import base64
import gzip
import hashlib
import os
import sys
import tarfile
import time
import zipfile
from pathlib import Path

PROGRAM = 0o755
TEXT = 0o644


def entries(folder):
    """Returns every file with its name below the folder, sorted by the bytes of the names."""
    files = [path for path in Path(folder).rglob("*") if path.is_file()]
    return sorted(((path.relative_to(folder).as_posix(), path) for path in files), key=lambda entry: entry[0].encode())


def mode(path):
    return PROGRAM if path.stat().st_mode & 0o100 else TEXT


def folders(names):
    """Returns every folder of these files, parents first."""
    found = {parent.as_posix() for name in names for parent in Path(name).parents}
    return sorted(found - {"."})


def tar(folder, name, archive, moment):
    # The header of gzip has its own name and time, which are set here.
    with open(archive, "wb") as raw, gzip.GzipFile("", "wb", 9, raw, mtime=moment) as packed:
        with tarfile.open(mode="w", fileobj=packed, format=tarfile.USTAR_FORMAT) as out:

            def entry(inside, kind, permissions):
                info = tarfile.TarInfo(inside)
                info.type, info.mode, info.mtime = kind, permissions, moment
                info.uid = info.gid = 0
                info.uname = info.gname = "root"
                return info

            files = [(f"{name}/{inside}", path) for inside, path in entries(folder)]
            for inside in folders(inside for inside, _ in files):
                out.addfile(entry(inside, tarfile.DIRTYPE, PROGRAM))
            for inside, path in files:
                info = entry(inside, tarfile.REGTYPE, mode(path))
                info.size = path.stat().st_size
                with open(path, "rb") as content:
                    out.addfile(info, content)


def write_zip(files, archive, moment):
    """Writes a zip archive. Each of `files` is a name in the archive, the content and the mode."""
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as out:
        for inside, content, permissions in files:
            info = zipfile.ZipInfo(inside, time.gmtime(moment)[:6])
            # Mark the archive as made on Unix, so that unpacking on Unix sets the mode.
            info.create_system, info.external_attr = 3, (0o100000 | permissions) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            out.writestr(info, content, compresslevel=9)


def zipped(folder, name, archive, moment):
    write_zip(((f"{name}/{inside}", path.read_bytes(), mode(path)) for inside, path in entries(folder)), archive, moment)


def wheel(folder, archive, moment):
    files = [(inside, path.read_bytes(), mode(path)) for inside, path in entries(folder)]
    metadata = [inside for inside, _, _ in files if inside.endswith(".dist-info/METADATA")]
    if len(metadata) != 1:
        sys.exit(f"archive.py: {folder} holds {len(metadata)} files *.dist-info/METADATA, and a wheel has one")
    record = metadata[0].removesuffix("METADATA") + "RECORD"
    # The wheel standard recommends the files of .dist-info at the end of the archive.
    files = sorted((file for file in files if file[0] != record), key=lambda file: ".dist-info/" in file[0])

    def row(inside, content):
        if any(sign in inside for sign in ',"\n'):
            sys.exit(f"archive.py: {inside} cannot stand in a list parted by commas")
        checksum = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
        return f"{inside},sha256={checksum},{len(content)}\n"

    rows = "".join(row(inside, content) for inside, content, _ in files) + f"{record},,\n"
    write_zip([*files, (record, rows.encode(), TEXT)], archive, moment)


def main():
    kind, folder, *rest = sys.argv[1:] if len(sys.argv) > 2 else ("", "")
    if (kind, len(rest)) not in (("tar", 2), ("zip", 2), ("wheel", 1)):
        sys.exit(__doc__)
    if not entries(folder):
        sys.exit(f"archive.py: {folder} holds no file")
    {"tar": tar, "zip": zipped, "wheel": wheel}[kind](folder, *rest, int(os.environ["SOURCE_DATE_EPOCH"]))


main()
