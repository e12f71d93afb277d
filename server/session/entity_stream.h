// SPDX-License-Identifier: MIT
//
// Sends a client the changes of the entity list and the large shapes that its entities refer to,
// each shape once per stream and before the first entity that has it. Used on the session's thread.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <utility>

#include "server/messages/entity_update_message.h"
#include "server/replication/baseline_tracker.h"
#include "server/session/broadcast_cache.h"
#include "server/session/outbox.h"
#include "server/session/sent_log.h"

namespace jostle::server {

class EntityStream {
public:
    // `baselines`: the snapshots that the stream has carried.
    EntityStream(BroadcastCache& broadcast, const BaselineTracker& baselines, Outbox& outbox,
                 EntityForm form = EntityForm::complete)
        : broadcast_(broadcast), baselines_(baselines), outbox_(outbox), form_(form) {}

    EntityForm form() const { return form_; }
    // The list that the client has; null: none.
    const std::shared_ptr<const EntityList>& list() const { return list_; }
    void set_list(std::shared_ptr<const EntityList> list) { list_ = std::move(list); }
    // Sends the changes from list() to `list`.
    void send_list(const std::shared_ptr<const EntityList>& list);
    void send(const EntityUpdateMessages& messages);
    void send_removed(std::span<const EntityId> entities);

    // Records what is sent, for a stream that can be resumed; null: records nothing.
    void record_in(SentLog* log) { log_ = log; }
    // Restores the state of a suspended stream.
    void resume(std::shared_ptr<const EntityList> list, std::set<std::uint64_t> geometry);
    std::set<std::uint64_t> take_geometry() { return std::exchange(geometry_, {}); }

private:
    BroadcastCache& broadcast_;
    const BaselineTracker& baselines_;
    Outbox& outbox_;
    const EntityForm form_;
    SentLog* log_ = nullptr;
    std::shared_ptr<const EntityList> list_;
    std::set<std::uint64_t> geometry_;  // ids of the large shapes that were sent
};

}  // namespace jostle::server
