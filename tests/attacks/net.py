"""Where everybody comes from, and sockets. Each side has a loopback address of its own, so that a limit by address meets the
attacker alone; crowds that come from everywhere take `anywhere(number)`."""

import random
import socket

SERVER = "127.0.0.1"
HONEST = "127.0.1.1"      # the players whose messages are counted
PROBE = "127.0.2.1"       # health checks and the newcomer after an attack
ATTACKER = "127.0.3.1"


from_everywhere = False   # whether each connection of an attack has an address of its own, unless the attack says otherwise


def anywhere(number):
    """One of 60,000 addresses."""
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
        # The port is chosen when it is known to whom: otherwise thousands of connections would run out of ports.
        sock.setsockopt(socket.IPPROTO_IP, getattr(socket, "IP_BIND_ADDRESS_NO_PORT", 24), 1)
        sock.bind((source or attacker(), 0))
        sock.connect((SERVER, port))
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    except OSError:
        sock.close()
        raise
    return sock


class Closed(Exception):
    """The other side ended the conversation; `code` and `reason` as its protocol says them."""

    def __init__(self, code, reason=b""):
        super().__init__(f"{code} {reason!r}" if reason else str(code))
        self.code, self.reason = code, reason
