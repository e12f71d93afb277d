# SPDX-License-Identifier: MIT
"""Generates the Python modules of proto/ in a temporary folder and makes them importable: import it before jostle.v1.

A program of your own generates them once, with the command that generate() runs. It needs the Debian packages protobuf-compiler and
protobuf-compiler-grpc. With grpcio-tools from PyPI, "python3 -m grpc_tools.protoc" takes the place of "protoc" and its plugin.
"""

import atexit
import pathlib
import shutil
import subprocess
import sys
import tempfile

PROTO = pathlib.Path(__file__).resolve().parents[2] / "proto"


def generate(folder):
    files = sorted(str(path) for path in (PROTO / "jostle" / "v1").glob("*.proto"))
    plugin = shutil.which("grpc_python_plugin")
    if shutil.which("protoc") is None or plugin is None:
        raise SystemExit("protoc or grpc_python_plugin is missing; install protobuf-compiler and protobuf-compiler-grpc")
    subprocess.run(["protoc", f"-I{PROTO}", f"--plugin=protoc-gen-grpc_python={plugin}", f"--python_out={folder}",
                    f"--grpc_python_out={folder}", *files], check=True)


directory = tempfile.mkdtemp(prefix="jostle-stubs-")
atexit.register(shutil.rmtree, directory, ignore_errors=True)
generate(directory)
sys.path.insert(0, directory)
