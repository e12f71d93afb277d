# SPDX-License-Identifier: MIT
"""The players, attributes and user messages of a stream, written from proto/WIRE.md ("Players, attributes and messages")."""

from jostle.v1 import play_pb2


class WorldData:
    """Apply every Snapshot in the order in which they arrive, also one whose poses cannot be decoded."""

    def __init__(self):
        self.players = {}     # Player by client id
        self.attributes = {}  # {key: Attribute} by ("world", 0), ("player", client id) or ("entity", id)
        self.messages, self.messages_missed = [], 0

    def apply(self, snapshot):
        for update in snapshot.players:
            self.apply_players(update)
        for update in snapshot.attributes:
            self.apply_attributes(update)
        self.messages.extend(snapshot.messages)
        self.messages_missed += snapshot.messages_missed

    def apply_players(self, update):
        if update.complete:
            self.players.clear()
        self.players.update((player.client, player) for player in update.players)
        for event in update.events:
            known = self.players.pop(event.player.client, None)
            if event.kind == play_pb2.PLAYER_EVENT_KIND_LEFT:
                continue
            self.players[event.player.client] = event.player
            event.player.ping_ms = known.ping_ms if known else 0
        for ping in update.pings:
            if ping.client in self.players:
                self.players[ping.client].ping_ms = ping.ping_ms

    def apply_attributes(self, update):
        if update.complete:
            self.attributes.clear()
        for changed in update.sets:
            kind = changed.WhichOneof("target")
            target = (kind, 0 if kind == "world" else getattr(changed, kind))
            attributes = self.attributes.setdefault(target, {})
            for attribute in changed.attributes:
                if attribute.WhichOneof("value"):
                    attributes[attribute.key] = attribute
                else:
                    attributes.pop(attribute.key, None)
            if not attributes:
                del self.attributes[target]
        for entity in update.entities_ended:
            self.attributes.pop(("entity", entity), None)
        for client in update.players_ended:
            self.attributes.pop(("player", client), None)
