// SPDX-License-Identifier: MIT
#include "server/world/timeline.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// Memory of a restore point and of the host state; timeline_memory_test.cpp compares them with the
// allocator, and docs/guides/operator/rooms.md states them.
constexpr std::size_t bytes_per_state = 512 << 10;  // also of a world with few bodies
constexpr std::size_t bytes_per_body = 1280, bytes_per_contact = 1280, bytes_per_joint = 1536;
constexpr std::size_t bytes_per_record = 256;  // of an undo step, an attribute or a player

std::size_t bytes_of(const SavedHostState& host_state) {
    std::size_t bytes = bytes_per_record * (host_state.players.size() + 1);
    for (const SavedHostState::SavedAttribute& one : host_state.attributes) {
        const auto* const text = std::get_if<std::string>(&one.attribute.value);
        bytes += bytes_per_record + (text ? text->size() : 0);
    }
    for (const SavedHostState::ClientUndo& client : host_state.undo)
        for (const UndoStep& step : client.steps) {
            bytes += bytes_per_record + step.record.size();
            for (const UndoStep::Joint& joint : step.joints)
                bytes += bytes_per_record + joint.record.size();
        }
    return bytes;
}

std::size_t bytes_of(const HostedWorld& world, const physics::RestorePoint& bodies,
                     const SavedHostState& host_state) {
    const physics::WorldSummary summary = world.world().summary();
    const auto count = [](int number) { return static_cast<std::size_t>(number); };
    return bytes_per_state + bytes_per_body * world.entities() +
           bytes_per_contact * count(summary.contacts) + bytes_per_joint * count(summary.joints) +
           bodies.module_bytes() + bytes_of(host_state);
}

}  // namespace

void Timeline::on_tick(std::uint32_t tick, bool stepped, const HostedWorld& world,
                       std::uint32_t seconds, std::uint32_t oldest_tick) {
    const std::size_t before = states_.size();
    const std::uint32_t last = states_.empty() ? 0 : states_.back().tick;
    const std::size_t states_max = seconds == 0 ? 0 : seconds + 1;
    while (states_.size() > states_max ||
           (!stores_states_ && !states_.empty() && states_.front().tick < oldest_tick))
        drop_oldest();
    if (stepped) steps_since_++;
    if (seconds > 0 && (states_.empty() || steps_since_ >= hz_)) {
        steps_since_ = 0;
        if (states_.size() == states_max) drop_oldest();
        State state{.tick = tick};
        if (stores_states_) {
            state.bodies = std::move(spare_);
            state.bodies.capture(world.world());
            state.host_state = world.host_state(tick);
            state.bytes = bytes_of(world, state.bodies, state.host_state);
        }
        while (!states_.empty() && bytes_ + state.bytes > bytes_max) drop_oldest();
        if (state.bytes <= bytes_max) {
            bytes_ += state.bytes;
            states_.push_back(std::move(state));
        } else {
            spare_ = std::move(state.bodies);
        }
    }
    if (states_.size() != before || (!states_.empty() && states_.back().tick != last)) publish();
    if (seconds == 0) spare_ = {};
}

void Timeline::drop_oldest() {
    bytes_ -= states_.front().bytes;
    if (stores_states_) spare_ = std::move(states_.front().bodies);
    states_.pop_front();
}

void Timeline::publish() {
    auto ticks = std::make_shared<std::vector<std::uint32_t>>();
    for (const State& state : states_) ticks->push_back(state.tick);
    ASSERT(std::ranges::is_sorted(*ticks));
    ticks_ = std::move(ticks);
}

bool Timeline::contains(std::uint32_t tick) const {
    return std::ranges::binary_search(*ticks_, tick);
}

Result<HostedWorld> Timeline::world_at(std::uint32_t tick, const HostLimits& limits, int threads,
                                       double work_per_second) const {
    const auto at = std::ranges::find(states_, tick, &State::tick);
    if (at == states_.end() || at->bodies.empty())
        return Error{ErrorCode::not_found,
                     "the timeline of the room does not contain tick " + std::to_string(tick)};
    physics::World world;
    if (Status s = at->bodies.restore(world); !s.ok()) return s.error();
    if (Status s = world.set_threads(threads); !s.ok()) return s.error();
    return HostedWorld::restore(std::move(world), at->host_state, limits, hz_, work_per_second);
}

}  // namespace jostle::server
