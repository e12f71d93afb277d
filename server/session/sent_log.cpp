// SPDX-License-Identifier: MIT
#include "server/session/sent_log.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// Flow control stops a client without acknowledgements long before this number of snapshots.
constexpr std::size_t sent_max = 2048;

bool holds(const EntityList& list, EntityId entity) {
    const auto at =
        std::ranges::lower_bound(list, entity, {}, [](const auto& known) { return known->id; });
    return at != list.end() && (*at)->id == entity;
}

}  // namespace

void SentLog::on_list(std::shared_ptr<const EntityList> list, std::uint32_t after_frame) {
    ASSERT(list != nullptr);
    lists_.push_back({std::move(list), after_frame});
}

void SentLog::on_geometry(std::uint64_t id, std::uint32_t after_frame) {
    shapes_.push_back({id, after_frame});
}

void SentLog::on_snapshot(std::uint32_t frame, std::span<const InputResult> results,
                          std::uint32_t events) {
    ASSERT(sent_.empty() || frame >= sent_.back().frame);
    sent_.push_back({frame, {results.begin(), results.end()}, events});
    if (sent_.size() > sent_max) sent_.pop_front();
}

void SentLog::on_ack(std::uint32_t frame) {
    const auto is_frame = [&](const Sent& sent) { return sent.frame == frame; };
    if (frame <= acked_ || std::ranges::none_of(sent_, is_frame)) return;
    acked_ = frame;
    while (sent_.front().frame < frame) sent_.pop_front();
    while (lists_.size() > 1 && lists_[1].after_frame < frame) lists_.pop_front();
    while (!shapes_.empty() && shapes_.front().after_frame < frame) shapes_.pop_front();
}

void SentLog::roll_back_to(std::uint32_t frame) {
    while (!sent_.empty() && sent_.back().frame > frame) sent_.pop_back();
}

SentLog::Known SentLog::known_at(std::uint32_t frame, const EntityList& now) const {
    Known known;
    bool was_sent = false;
    for (const Sent& sent : sent_) {
        was_sent = was_sent || sent.frame == frame;
        if (sent.frame <= frame)
            known.events = sent.events;
        else
            known.results.insert(known.results.end(), sent.results.begin(), sent.results.end());
    }
    if (!was_sent || frame < acked_) return known;
    for (const SentList& sent : lists_)
        if (sent.after_frame < frame) known.list = sent.list;
    if (!known.list) return known;
    // The client may have received later lists before the connection broke. Their removed entities
    // are not part of the change from its list to the current one.
    for (const SentList& sent : lists_) {
        if (sent.after_frame < frame) continue;
        for (const auto& entity : *sent.list)
            if (!holds(now, entity->id)) known.removed.push_back(entity->id);
    }
    std::ranges::sort(known.removed);
    const auto repeated = std::ranges::unique(known.removed);
    known.removed.erase(repeated.begin(), repeated.end());
    for (const Shape& shape : shapes_)
        if (shape.after_frame >= frame) known.geometry.push_back(shape.id);
    return known;
}

}  // namespace jostle::server
