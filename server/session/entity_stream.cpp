// SPDX-License-Identifier: MIT
#include "server/session/entity_stream.h"

#include "jostle/base/check.h"

namespace jostle::server {

void EntityStream::send_list(const std::shared_ptr<const EntityList>& list) {
    ASSERT(list != nullptr);
    send(*broadcast_.entity_list_change(list_, list, form_));
    list_ = list;
    if (log_) log_->on_list(list, baselines_.last());
}

void EntityStream::send(const EntityUpdateMessages& messages) {
    for (const auto& geometry : messages.geometry) {
        if (!geometry_.insert(geometry->id).second) continue;
        if (log_) log_->on_geometry(geometry->id, baselines_.last());
        for (const SharedBytes& part : geometry->messages) outbox_.push_shared(part);
    }
    for (const SharedBytes& update : messages.entity_updates) outbox_.push_shared(update);
}

void EntityStream::send_removed(std::span<const EntityId> entities) {
    if (entities.empty()) return;
    outbox_.push_shared(std::make_shared<const std::string>(encode_removed(entities)));
}

void EntityStream::resume(std::shared_ptr<const EntityList> list,
                          std::set<std::uint64_t> geometry) {
    ASSERT(!list_ && geometry_.empty());
    list_ = std::move(list);
    geometry_ = std::move(geometry);
}

}  // namespace jostle::server
