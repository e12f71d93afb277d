// SPDX-License-Identifier: MIT
#include "server/session/snapshot_sections.h"

#include <algorithm>
#include <utility>

#include "server/session/joints_section.h"
#include "server/session/optional_sections.h"

namespace jostle::server {

template <class Section, class... Arguments>
Section* SnapshotSections::add(Arguments&&... arguments) {
    auto section = std::make_unique<Section>(std::forward<Arguments>(arguments)...);
    Section* const added = section.get();
    optional_.push_back(std::move(section));
    return added;
}

SnapshotSections::SnapshotSections(const Sources& sources, const Hello& hello)
    : client_update_(sources.inputs, sources.schedule) {
    if (hello.interest || hello.max_kbps != 0)
        cells_ = add<CellsSection>(sources.broadcast, sources.poses, sources.entities,
                                   sources.codec, hello);
    const WorldHost& host = sources.broadcast.host();
    const std::uint64_t motion = motion_channel(host.properties().channel_kinds);
    std::uint64_t kinds = requested_channels(host.properties().channel_kinds, hello.channels);
    const bool predicts = (kinds & motion) != 0;
    // The motion channel covers all bodies, but a client with cells receives some of them only.
    if (cells_) kinds &= ~motion;
    if (kinds != 0) channels_ = add<ChannelsSection>(kinds, motion);
    // After the cells, which leave it a part of the budget.
    if (const std::uint64_t points = kinds & point_channels(host.properties().channel_kinds))
        points_ = add<PointsSection>(points, sources.broadcast, cells_ ? &cells_->view() : nullptr);
    add<StatsSection>(sources.context.config.stream, sources.context.sessions, sources.broadcast);
    if (hello.events) events_ = add<EventsSection>(sources.broadcast);
    // After the cells, which send the entities of the joints.
    if (hello.joints && cells_) add<KnownJointsSection>(*cells_);
    if (hello.joints && !cells_) add<JointsSection>(sources.broadcast);
    if (hello.players)
        players_ = add<PlayersSection>(sources.broadcast, sources.context.connected_clients);
    if (hello.attributes)
        attributes_ = add<AttributesSection>(sources.broadcast, sources.client,
                                             initial_role(hello.spectator));
    if (hello.room) add<RoomSection>(sources.broadcast, sources.client);
    if (!hello.topics.empty())
        messages_ = add<MessagesSection>(sources.broadcast, sources.client, hello.topics);
    if (predicts) add<ControlledEntitySection>(sources.client, host.hz());
    optional_.shrink_to_fit();
}

void SnapshotSections::on_enter(FrameListeners& listeners) {
    listeners.streams++;
    for (const auto& section : optional_) section->on_enter(listeners);
}

void SnapshotSections::on_leave(FrameListeners& listeners) {
    for (const auto& section : optional_) section->on_leave(listeners);
    listeners.streams--;
}

bool SnapshotSections::has_changes(const Frame& frame) const {
    return client_update_.has_changes(frame) ||
           std::ranges::any_of(optional_,
                               [&](const auto& section) { return section->has_changes(frame); });
}

void SnapshotSections::append_optional(const FramePtr& frame, Clock::time_point now,
                                       SnapshotParts& parts, TrafficBytes& traffic) {
    std::size_t before = parts.size();
    for (const auto& section : optional_) {
        section->append(frame, now, parts);
        const std::size_t after = parts.size();
        traffic[static_cast<std::size_t>(section->traffic_kind())] += after - before;
        before = after;
    }
}

void SnapshotSections::on_sent(const OutMessage& snapshot) {
    for (const auto& section : optional_) section->on_sent(snapshot);
}

}  // namespace jostle::server
