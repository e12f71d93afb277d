#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Login service on the command line: creates a signing key, its JWKS file, and tokens for a Jostle server.

Shows: the JSON Web Tokens that jostle-server accepts (ES256; claims iss, aud, sub, role, exp, world).
Run:   python3 examples/tokens/token_tool.py new-key login.pem keys.json
       python3 examples/tokens/token_tool.py sign login.pem --subject anna --role admin > anna.jwt
Needs openssl. Keep login.pem secret: its holder can issue tokens for everybody. A real login service signs the same claims after it
has authenticated the user.
"""

import argparse
import base64
import hashlib
import json
import os
import subprocess
import sys
import time


def openssl(*arguments, data=None):
    run = subprocess.run(["openssl", *arguments], input=data, capture_output=True)
    if run.returncode != 0:
        raise SystemExit(f"token_tool.py: openssl {arguments[0]}: {run.stderr.decode().strip()}")
    return run.stdout


def encode(data):
    """Base64url without padding."""
    return base64.urlsafe_b64encode(data).rstrip(b"=").decode()


def public_key(key_file):
    """x and y of the public key, 32 bytes each, and the key id: a hash of both."""
    point = openssl("ec", "-in", key_file, "-pubout", "-outform", "DER")[-64:]
    return point[:32], point[32:], encode(hashlib.sha256(point).digest()[:12])


def new_key(options):
    os.umask(0o077)  # the key is readable by its owner only
    openssl("ecparam", "-name", "prime256v1", "-genkey", "-noout", "-out", options.key)
    x, y, kid = public_key(options.key)
    key = {"kty": "EC", "crv": "P-256", "alg": "ES256", "kid": kid, "x": encode(x), "y": encode(y)}
    with open(options.jwks, "w", encoding="utf-8") as file:
        json.dump({"keys": [key]}, file, indent=1)
    print(f"wrote {options.key} (secret) and {options.jwks} (for auth.keys)")


def raw_signature(der):
    """r and s, 32 bytes each, from a DER sequence of two integers."""
    numbers, at = b"", 2
    for _ in range(2):
        size = der[at + 1]
        numbers += der[at + 2:at + 2 + size].lstrip(b"\0").rjust(32, b"\0")
        at += 2 + size
    return numbers


def sign(options):
    now = int(time.time())
    claims = {"iss": options.issuer, "aud": options.audience, "sub": options.subject, "role": options.role, "iat": now,
              "exp": now + round(3600 * options.hours)}
    if options.world:
        claims["world"] = options.world[0] if len(options.world) == 1 else options.world
    header = {"alg": "ES256", "kid": public_key(options.key)[2]}
    signed = ".".join(encode(json.dumps(part, separators=(",", ":")).encode()) for part in (header, claims))
    print(f"{signed}.{encode(raw_signature(openssl('dgst', '-sha256', '-sign', options.key, data=signed.encode())))}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    command = commands.add_parser("new-key", help="create a signing key and its JWKS file")
    command.add_argument("key", metavar="KEY.pem")
    command.add_argument("jwks", metavar="KEYS.json")
    command.set_defaults(run=new_key)
    command = commands.add_parser("sign", help="print a token")
    command.add_argument("key", metavar="KEY.pem")
    command.add_argument("--subject", required=True, help="who the token is for")
    command.add_argument("--role", required=True, choices=["viewer", "player", "director", "admin"])
    command.add_argument("--world", action="append",
                         help="id or name of a world that the token opens; repeat it for several [any world]")
    command.add_argument("--hours", type=float, default=8, help="lifetime, at most 24 [default: 8]")
    command.add_argument("--issuer", default="https://login.example.org", help="auth.issuer [default: %(default)s]")
    command.add_argument("--audience", default="jostle", help="auth.audience [default: %(default)s]")
    command.set_defaults(run=sign)
    options = parser.parse_args()
    options.run(options)
    return 0


if __name__ == "__main__":
    sys.exit(main())
