"""Source addresses and sockets. Each role has its own loopback address, so that a limit per address affects only the attacker.
Client pools with distinct addresses use `anywhere(number)`."""

import random
import socket

SERVER = "127.0.0.1"
HONEST = "127.0.1.1"  # the players whose messages the test counts
PROBE = "127.0.2.1"  # health checks and the new player after an attack
ATTACKER = "127.0.3.1"


# each connection of an attack has a different address unless the attack specifies one
from_everywhere = False


def anywhere(number):
    """One of 60,000 loopback addresses."""
    number %= 60000
    return f"127.16.{number // 250}.{number % 250 + 1}"


def attacker():
    return anywhere(random.randrange(60000)) if from_everywhere else ATTACKER


def connect(port, source=None, timeout=5.0, receive_buffer=None):
    sock = socket.socket()
    try:
        if receive_buffer:
            sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        sock.settimeout(timeout)
        # Choose the port in connect(), when the destination is known. Otherwise thousands of
        # connections exhaust the ports.
        sock.setsockopt(socket.IPPROTO_IP, getattr(socket, "IP_BIND_ADDRESS_NO_PORT", 24), 1)
        sock.bind((source or attacker(), 0))
        sock.connect((SERVER, port))
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    except OSError:
        sock.close()
        raise
    return sock


class Closed(Exception):
    """The peer closed the stream, with the `code` and `reason` of its protocol."""

    def __init__(self, code, reason=b""):
        super().__init__(f"{code} {reason!r}" if reason else str(code))
        self.code, self.reason = code, reason
