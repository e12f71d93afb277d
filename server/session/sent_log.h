// SPDX-License-Identifier: MIT
//
// What one client was sent and may not have got, because it has not acknowledged it: when its
// connection breaks and it comes back, it says which snapshot it has, and the stream goes on from
// there. A link's own; one thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "server/util/fifo.h"
#include "server/world/command.h"
#include "server/world/frame.h"

namespace jostle::server {

class SentLog {
public:
    // Entities, or a large shape, that were told after the snapshot of that tick (0: the first).
    void on_list(std::shared_ptr<const EntityList> list, std::uint32_t after_frame);
    void on_geometry(std::uint64_t id, std::uint32_t after_frame);
    // A snapshot, the results in it, and how many events had been told with it (RecentEvents).
    void on_snapshot(std::uint32_t frame, std::span<const InputResult> results,
                     std::uint32_t events);
    // The client has it, and all that was told before it.
    void on_ack(std::uint32_t frame);

    // The client forgot the snapshots that were sent after that one.
    void roll_back_to(std::uint32_t frame);

    // Of a client that has that snapshot and may have some of what came after it.
    struct Known {
        std::shared_ptr<const EntityList> list;  // it has this
        std::vector<EntityId> removed;           // it may have these, which are no more
        std::vector<InputResult> results;        // to be told again, in order
        std::vector<std::uint64_t> geometry;     // likewise
        std::uint32_t events = 0;
    };
    // `now`: the list of today. Results alone when the frame was not sent or is older than an
    // acknowledged one: then the list is null.
    Known known_at(std::uint32_t frame, const EntityList& now) const;

private:
    struct Sent {
        std::uint32_t frame;
        std::vector<InputResult> results;
        std::uint32_t events;
    };
    struct SentList {
        std::shared_ptr<const EntityList> list;
        std::uint32_t after_frame;
    };
    struct Shape {
        std::uint64_t id;
        std::uint32_t after_frame;
    };

    std::uint32_t acked_ = 0;
    Fifo<Sent> sent_;       // rising, from the acknowledged one on
    Fifo<SentList> lists_;  // in order; the first one is what the client has for certain
    Fifo<Shape> shapes_;    // in order
};

}  // namespace jostle::server
