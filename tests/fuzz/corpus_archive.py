#!/usr/bin/env python3
"""Packs and unpacks the committed fuzz corpora, one archive per target: corpus/TARGET.tar.zst.

Usage: corpus_archive.py ARCHIVE FILE...
Adds files with descriptive names, which must have an extension, to an archive. An entry of the same
name is replaced. Exit status: 0 success, 1 a file cannot be read or written, 2 invalid arguments.

scripts/fuzz imports this module. An archive is a USTAR archive of regular files, without folders,
compressed by the zstd command. Packing is reproducible: entries are sorted by name, time and owner
are 0, the mode is 0644 and the compression level is fixed. The compressed bytes also depend on the
version of zstd, so pack() does not rewrite an archive that already holds the same entries.
"""

import hashlib
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile

COMPRESS = ["zstd", "-19", "--single-thread", "--check", "--quiet", "--stdout"]
DECOMPRESS = ["zstd", "--decompress", "--quiet", "--stdout"]


class ArchiveError(Exception):
    """An archive that cannot be read or written. The message names the file and the remedy."""


def read(archive):
    """Returns the entries of an archive: a dictionary from name to bytes."""
    archive = pathlib.Path(archive)
    result = run_zstd(DECOMPRESS, archive, read_file(archive))
    if result.returncode != 0:
        raise damaged(archive, zstd_message(result))
    entries = {}
    try:
        with tarfile.open(fileobj=io.BytesIO(result.stdout), mode="r:") as tar:
            for entry in tar:
                if not entry.isfile() or "/" in entry.name or entry.name in ("", ".", ".."):
                    raise damaged(archive, f"entry {entry.name!r} is not a file without a folder")
                if entry.name in entries:
                    raise damaged(archive, f"entry {entry.name!r} occurs twice")
                entries[entry.name] = tar.extractfile(entry).read()
    except tarfile.TarError as error:
        raise damaged(archive, f"not a tar archive after decompression: {error}") from error
    return entries


def pack(entries, archive):
    """Writes entries (name to bytes) to an archive. Returns False if it already holds them."""
    archive = pathlib.Path(archive)
    if archive.exists():
        try:
            if read(archive) == entries:
                return False
        except ArchiveError:
            pass  # replaced below
    buffer = io.BytesIO()
    with tarfile.open(fileobj=buffer, mode="w:", format=tarfile.USTAR_FORMAT) as tar:
        for name in sorted(entries):
            entry = tarfile.TarInfo(name)  # time, user and group are 0
            entry.mode = 0o644
            entry.size = len(entries[name])
            tar.addfile(entry, io.BytesIO(entries[name]))
    result = run_zstd(COMPRESS, archive, buffer.getvalue())
    if result.returncode != 0:
        raise ArchiveError(f"{shown(archive)}: cannot compress: {zstd_message(result)}")
    archive.parent.mkdir(parents=True, exist_ok=True)
    partial = archive.with_name(archive.name + ".partial")
    partial.write_bytes(result.stdout)
    os.replace(partial, archive)
    return True


def unpack(archive, folder):
    """Makes a folder hold the entries of an archive and nothing else. Returns False if it already
    did: FOLDER.sha256 is the hash of the archive that was unpacked last."""
    archive, folder = pathlib.Path(archive), pathlib.Path(folder)
    stamp = folder.with_name(folder.name + ".sha256")
    current = hashlib.sha256(read_file(archive)).hexdigest() + "\n"
    if folder.is_dir() and stamp.exists() and stamp.read_text() == current:
        return False
    entries = read(archive)
    folder.parent.mkdir(parents=True, exist_ok=True)
    # A failure leaves no folder that looks complete: the stamp comes last.
    stamp.unlink(missing_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f"{folder.name}.") as scratch:
        fresh = pathlib.Path(scratch) / folder.name
        fresh.mkdir()
        for name, content in entries.items():
            (fresh / name).write_bytes(content)
        shutil.rmtree(folder, ignore_errors=True)
        os.replace(fresh, folder)
    stamp.write_text(current)
    return True


def read_file(archive):
    try:
        return archive.read_bytes()
    except OSError as error:
        raise ArchiveError(f"{shown(archive)}: cannot read: {error.strerror}") from error


def run_zstd(command, archive, content):
    try:
        return subprocess.run(command, input=content, capture_output=True)
    except FileNotFoundError as error:
        raise ArchiveError(f"{shown(archive)}: the command zstd is not installed; install the "
                           "Debian package zstd or run scripts/setup --with-fuzz") from error


def zstd_message(result):
    """The message of zstd without its name for standard input: the caller names the file."""
    text = result.stderr.decode(errors="replace").strip()
    return (text.removeprefix("zstd: ").removeprefix("/*stdin*\\").lstrip(" :") or
            f"zstd exited with {result.returncode}")


def damaged(archive, reason):
    return ArchiveError(f"{shown(archive)}: cannot unpack: {reason}; restore the file: "
                        f"git checkout -- {shown(archive)}")


def shown(path):
    """As a path to type: relative to the working directory."""
    return os.path.relpath(path)


def main(arguments):
    if len(arguments) < 2 or "--help" in arguments:
        print("\n".join(__doc__.splitlines()[2:5]), file=sys.stdout if "--help" in arguments else sys.stderr)
        return 0 if "--help" in arguments else 2
    archive, files = arguments[0], [pathlib.Path(name) for name in arguments[1:]]
    for file in files:
        if not file.suffix:
            print(f"corpus_archive.py: {file}: the name needs an extension, which marks inputs with "
                  "descriptive names", file=sys.stderr)
            return 2
    try:
        entries = read(archive)
        entries.update((file.name, read_file(file)) for file in files)
        changed = pack(entries, archive)
    except ArchiveError as error:
        print(f"corpus_archive.py: {error}", file=sys.stderr)
        return 1
    print(f"{shown(archive)}: {'wrote' if changed else 'unchanged:'} {len(entries)} inputs")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
