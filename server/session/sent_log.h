// SPDX-License-Identifier: MIT
//
// The data that one client was sent and has not acknowledged. A client that resumes names the
// newest snapshot that it has, and the stream continues from there. Used on the session's thread.
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
    // An entity list, or a large shape, that was sent after the snapshot of tick `after_frame`; 0:
    // before the first snapshot.
    void on_list(std::shared_ptr<const EntityList> list, std::uint32_t after_frame);
    void on_geometry(std::uint64_t id, std::uint32_t after_frame);
    // A snapshot, its results, and the number of ticks with events (RecentEvents) sent by then.
    void on_snapshot(std::uint32_t frame, std::span<const InputResult> results,
                     std::uint32_t events);
    // The client has the snapshot and everything sent before it. Ignores unknown frames.
    void on_ack(std::uint32_t frame);

    // The client lost the snapshots sent after `frame`.
    void roll_back_to(std::uint32_t frame);

    // State of a client that has a snapshot, and may have some of the data sent after it.
    struct Known {
        std::shared_ptr<const EntityList> list;  // the client has these entities
        std::vector<EntityId> removed;           // removed entities that it may have in addition
        std::vector<InputResult> results;        // to be sent again, in order
        std::vector<std::uint64_t> geometry;     // ids of shapes to be sent again
        std::uint32_t events = 0;                // number of ticks with events that it has
    };
    // `now`: the current entity list. If the frame was not sent, or is older than an acknowledged
    // one, the list is null and only the results are valid.
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
    Fifo<Sent> sent_;       // ascending, from the acknowledged snapshot
    Fifo<SentList> lists_;  // in order; the client has the first one
    Fifo<Shape> shapes_;    // in order
};

}  // namespace jostle::server
