"""Players: one over either transport, pools of them, and the honest player whose messages decide the verdict of an attack."""

import multiprocessing
import selectors
import time

from . import messages
from .http2 import Connection, grpc_message
from .net import HONEST, Closed
from .protobuf import all_of, field, fields
from .websocket import WebSocket


class GrpcStream:
    """A Play stream with the interface of WebSocket. A connection may carry several."""

    def __init__(self, port, source=None, timeout=5.0, connection=None, **options):
        self.connection = connection or Connection(port, source, timeout, **options)
        self.number = self.connection.open(messages.PLAY)
        self.stream = self.connection.streams[self.number]
        self.sock = self.connection.sock

    def send(self, message):
        self.connection.send_data(self.number, grpc_message(message), patience=1.0)

    def buffered(self):
        return self.stream.next_message()

    def receive(self, until):
        while True:
            message = self.stream.next_message()
            if message is not None:
                return message
            if self.stream.ended is not None:
                raise Closed(self.stream.status, self.stream.headers.get("grpc-message", "").encode())
            if not self.connection.pump(until):
                return None

    def close(self):
        self.connection.close()


TRANSPORTS = ("websocket", "grpc")


def open_stream(ports, transport, source=None, **options):
    if transport == "grpc":
        return GrpcStream(ports.grpc, source, **options)
    return WebSocket(ports.http, source, **options)


class Player:
    """Sends a Hello, acknowledges snapshots and counts messages by kind. Raises Closed or OSError when it is disconnected."""

    def __init__(self, ports, transport="websocket", source=None, world="target", link=None, keyframes=False,
                 receive_buffer=None, **hello):
        self.link = link or open_stream(ports, transport, source, receive_buffer=receive_buffer)
        self.keyframes, self.counts, self.bytes, self.largest = keyframes, {}, 0, 0
        self.frame, self.sequence, self.codes, self.notice = 0, 1, {}, ""
        self.link.send(messages.hello(world, **hello))

    @property
    def sock(self):
        return self.link.sock

    def receive(self, until):
        """The kind of the next message, or None if none arrived until then."""
        message = self.link.receive(until)
        return None if message is None else self._take(message)

    def drain(self):
        """Read all available messages of a readable socket."""
        self.receive(time.monotonic() + 0.005)
        while (message := self.link.buffered()) is not None:
            self._take(message)

    def _take(self, message):
        parts = list(fields(message))
        kind, body = parts[0][0], b"".join(part for _, part in parts)  # the server sends some messages in parts
        self.counts[kind] = self.counts.get(kind, 0) + 1
        self.bytes += len(message)
        self.largest = max(self.largest, len(message))
        if kind == messages.SNAPSHOT:
            self.frame = field(body, messages.FRAME, self.frame)
            self.link.send(messages.ack(self.frame, self.keyframes))
            for result in all_of(b"".join(all_of(body, messages.CLIENT_UPDATE)), messages.RESULTS):
                code = field(result, 2, 0)
                self.codes[code] = self.codes.get(code, 0) + 1
        elif kind == messages.NOTICE:
            self.notice = field(body, 2, b"").decode("utf-8", "replace")
        return kind

    def act(self, *inputs):
        self.link.send(messages.batch(self.sequence, inputs))
        self.sequence += len(inputs)

    def until(self, kind, seconds):
        """Play until a message of that kind arrives. Return whether it did."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.receive(end) == kind:
                return True
        return False

    def close(self):
        self.link.close()


class ClientPool:
    """Many players in one process. Counts the disconnected ones by reason."""

    def __init__(self):
        self.players, self.ends = [], {}
        self.selector = selectors.DefaultSelector()

    def add(self, count, make):
        for i in range(count):
            try:
                player = make(i)
                self.players.append(player)
                self.selector.register(player.sock, selectors.EVENT_READ, player)
            except (OSError, Closed) as ended:
                self._count(ended)
        return self

    def _count(self, ended):
        self.ends[str(ended)] = self.ends.get(str(ended), 0) + 1

    def _drop(self, player, ended):
        self._count(ended)
        self.players.remove(player)
        self.selector.unregister(player.sock)
        player.close()

    def play(self, seconds, act=None, every=0.1):
        """Read and acknowledge for `seconds`. Call `act(player)` for each player every `every` seconds."""
        now = time.monotonic()
        end, due = now + seconds, now
        while now < end and self.players:
            if act and now >= due:
                due = max(due + every, now)
                self._each(act)
            for key, _ in self.selector.select(min(end, due if act else end) - time.monotonic()):
                self._guard(key.data, Player.drain)
            now = time.monotonic()
        return self

    def _each(self, act):
        for player in list(self.players):
            self._guard(player, act)

    def _guard(self, player, act):
        try:
            act(player)
        except (OSError, Closed) as ended:
            self._drop(player, ended)

    def total(self, kind):
        return sum(player.counts.get(kind, 0) for player in self.players)

    def close(self):
        for player in self.players:
            player.close()


class HonestPlayer:
    """Plays in its own process. Its report holds the arrival time of each message and the reason of a disconnection."""

    def __init__(self, ports, transport, world):
        context = multiprocessing.get_context("fork")
        self.pipe, theirs = context.Pipe()
        self.transport = transport
        self.process = context.Process(target=_play_honestly, args=(ports, transport, world, theirs), daemon=True)
        self.process.start()
        theirs.close()
        if not self.pipe.poll(10) or self.pipe.recv() != "in":
            raise RuntimeError(f"the honest player ({transport}) could not join the world")

    def report(self):
        """Get the report. The player stays connected, because the shutdown must notify connected clients."""
        try:
            self.pipe.send("report")
            return self.pipe.recv() if self.pipe.poll(10) else None
        except (OSError, EOFError):
            return None

    def stop(self):
        self.process.terminate()
        self.process.join(5)


def _play_honestly(ports, transport, world, pipe):
    times, ended, sent = [], None, 0
    player = Player(ports, transport, HONEST, world, name=f"honest {transport}")
    next_input = time.monotonic()
    joined = False
    while True:
        if pipe.poll():
            pipe.recv()
            pipe.send({"times": times, "ended": ended, "sent": sent, "applied": player.codes.get(1, 0)})
        if ended is not None:
            time.sleep(0.02)
            continue
        try:
            if player.receive(time.monotonic() + 0.05) is not None:
                times.append(time.monotonic())
            if not joined and player.frame:
                joined = True
                pipe.send("in")
            if time.monotonic() >= next_input:
                next_input += 0.5
                sent += 1
                player.act(messages.explode((0, 0.5, 0), 1.5, 2))
        except (OSError, Closed) as reason:
            ended = f"{type(reason).__name__}: {reason}"
