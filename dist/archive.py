"""Packs a folder as .tar.gz or .zip so that the same files give the same bytes: sorted, one owner, the time in SOURCE_DATE_EPOCH.

    archive.py tar|zip FOLDER NAME ARCHIVE       NAME is the folder inside the archive
"""

import gzip
import os
import sys
import tarfile
import time
import zipfile
from pathlib import Path

PROGRAM = 0o755
TEXT = 0o644


def entries(folder):
    """Every file with its name below the folder, in the order of the names' bytes."""
    files = [path for path in Path(folder).rglob("*") if path.is_file()]
    return sorted(((path.relative_to(folder).as_posix(), path) for path in files), key=lambda entry: entry[0].encode())


def mode(path):
    return PROGRAM if path.stat().st_mode & 0o100 else TEXT


def folders(names):
    """Every folder of these files, parents first."""
    found = {parent.as_posix() for name in names for parent in Path(name).parents}
    return sorted(found - {"."})


def tar(folder, name, archive, moment):
    # The header of gzip holds a name and a time of its own.
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


def zipped(folder, name, archive, moment):
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as out:
        for inside, path in entries(folder):
            info = zipfile.ZipInfo(f"{name}/{inside}", time.gmtime(moment)[:6])
            # As made on Unix, so that the mode counts where it is unpacked there.
            info.create_system, info.external_attr = 3, (0o100000 | mode(path)) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            out.writestr(info, path.read_bytes(), compresslevel=9)


def main():
    if len(sys.argv) != 5 or sys.argv[1] not in ("tar", "zip"):
        sys.exit(__doc__)
    kind, folder, name, archive = sys.argv[1:]
    if not entries(folder):
        sys.exit(f"archive.py: {folder} holds no file")
    (tar if kind == "tar" else zipped)(folder, name, archive, int(os.environ["SOURCE_DATE_EPOCH"]))


main()
