// SPDX-License-Identifier: MIT
#include "server/session/optional_sections.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "jostle/base/check.h"
#include "server/messages/event_message.h"
#include "server/world/module_channels.h"

namespace jostle::server {

std::uint64_t requested_channels(const std::vector<physics::ChannelKind>& kinds,
                                 const std::vector<std::string>& names) {
    ASSERT(kinds.size() <= 64);
    std::uint64_t requested = 0;
    for (std::size_t k = 0; k < kinds.size(); k++)
        for (const std::string& name : names)
            if (name == kinds[k].name || (name == "*" && kinds[k].name != motion_kind) ||
                (name == "points:*" && kinds[k].form == physics::ChannelForm::points))
                requested |= std::uint64_t{1} << k;
    return requested;
}

std::uint64_t motion_channel(const std::vector<physics::ChannelKind>& kinds) {
    return requested_channels(kinds, {motion_kind});
}

std::uint64_t point_channels(const std::vector<physics::ChannelKind>& kinds) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < kinds.size(); k++)
        if (kinds[k].form == physics::ChannelForm::points) bits |= std::uint64_t{1} << k;
    return bits;
}

ChannelsSection::ChannelsSection(std::uint64_t kinds, std::uint64_t motion)
    : kinds_(kinds), has_motion_((kinds & motion) != 0) {
    ASSERT(kinds_ != 0);
}

void ChannelsSection::on_enter(FrameListeners& listeners) {
    if (has_motion_) listeners.motion++;
}

void ChannelsSection::on_leave(FrameListeners& listeners) {
    if (!has_motion_) return;
    ASSERT(listeners.motion > 0);
    listeners.motion--;
}

void EventsSection::on_leave(FrameListeners& listeners) {
    ASSERT(listeners.events > 0);
    listeners.events--;
}

void EventsSection::append(const FramePtr& frame, Clock::time_point, SnapshotParts& parts) {
    const auto& [count, ticks] = *frame->events;
    ASSERT(ticks.size() <= count);
    const std::uint32_t dropped = count - static_cast<std::uint32_t>(ticks.size());
    if (cursor_ < dropped) {
        missed_ += dropped - cursor_;
        cursor_ = dropped;
    }
    std::string fields;
    for (; cursor_ < count; cursor_++) {
        const SharedBytes shared = broadcast_.events(ticks[cursor_ - dropped]);
        if (shared->size() > bytes_max) {
            missed_++;
            continue;
        }
        if (fields.size() + shared->size() > bytes_max) break;  // the next snapshot carries it
        fields += encode_events_header(std::exchange(missed_, 0), shared->size());
        fields += *shared;
    }
    parts.fields += fields;
}

namespace {

constexpr double updates_per_second = 16;

}  // namespace

ControlledEntitySection::ControlledEntitySection(ClientId client, double hz)
    : client_(client),
      period_(static_cast<std::uint32_t>(std::max(1.0, std::round(hz / updates_per_second)))) {
    ASSERT(client_ != 0);
}

void ControlledEntitySection::on_leave(FrameListeners& listeners) {
    ASSERT(listeners.controlled_entities > 0);
    listeners.controlled_entities--;
}

void ControlledEntitySection::append(const FramePtr& frame, Clock::time_point,
                                     SnapshotParts& parts) {
    if (!frame->controlled_entities) return;
    const auto mine =
        std::ranges::find(*frame->controlled_entities, client_, &ControlledEntityState::client);
    if (mine == frame->controlled_entities->end() || mine->entity == 0) return;
    const bool keyframe = sent_entity_ != mine->entity;
    if (!keyframe && frame->tick < sent_tick_ + period_) return;
    parts.fields += encode_controlled_entity_field(*mine, frame->tick, sent_words_, keyframe);
    sent_entity_ = mine->entity;
    sent_tick_ = frame->tick;
    sent_words_ = mine->words;
}

void ClientUpdateSection::append(const FramePtr&, Clock::time_point, SnapshotParts& parts) {
    std::uint32_t sequence = sent_sequence_;
    std::int64_t margin_us = 0;
    for (const InputResult& result : inputs_.results()) {
        sequence = std::max(sequence, result.sequence);
        margin_us = result.margin_us.value_or(margin_us);
    }
    ClientUpdate& update = parts.update;
    update.results = inputs_.results();
    update.echo_client_time_us = inputs_.take_client_time_us();
    update.input_margin_us = clamp_margin(margin_us);
    const std::uint32_t received = inputs_.confirmed(), skipped = schedule_.skipped();
    ASSERT(skipped >= sent_skipped_);
    if (reports_received_ && received != sent_received_)
        update.input_received = sent_received_ = received;
    if (sequence != sent_sequence_) update.input_sequence = sent_sequence_ = sequence;
    if (skipped != sent_skipped_) update.snapshots_skipped = sent_skipped_ = skipped;
}

}  // namespace jostle::server
