// SPDX-License-Identifier: MIT
#include "tests/system/play_state.h"

#include <algorithm>
#include <span>

#include "jostle/snapshot/baseline_frames.h"

namespace jostle::test {

namespace {

constexpr std::size_t ring_size = 32;

}  // namespace

double age_ms(std::uint64_t server_time_us) {
    const auto now = std::chrono::duration_cast<std::chrono::microseconds>(
                         std::chrono::steady_clock::now().time_since_epoch())
                         .count();
    return (static_cast<double>(now) - static_cast<double>(server_time_us)) / 1000;
}

void PlayState::expect(bool holds, const std::string& what) {
    if (holds) return;
    if (violations++ == 0) first_violation = what;
}

std::size_t PlayState::count(v1::InputCode code) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        results, [&](const auto& entry) { return entry.second.code() == code; }));
}

void PlayState::take(const v1::ServerMessage& message) {
    expect(welcomes == 1 || message.has_welcome() || message.has_notice(),
           "the first message is neither a Welcome nor a Notice");
    switch (message.message_case()) {
        case v1::ServerMessage::kWelcome:
            welcomes++;
            expect(welcomes == 1, "a second Welcome");
            welcome = message.welcome();
            client_id = welcome.client_id();
            break;
        case v1::ServerMessage::kGeometry:
            if (message.geometry().chunk() + 1 == message.geometry().chunk_count())
                geometry.insert(message.geometry().id());
            break;
        case v1::ServerMessage::kEntityUpdate:
            take(message.entity_update());
            break;
        case v1::ServerMessage::kSnapshot:
            take(message.snapshot());
            break;
        case v1::ServerMessage::kPong:
            pongs++;
            break;
        case v1::ServerMessage::kNotice:
            notices.push_back(message.notice());
            break;
        case v1::ServerMessage::MESSAGE_NOT_SET:
            expect(false, "an empty message");
            break;
    }
}

void PlayState::take(const v1::EntityUpdate& entity_update) {
    entity_updates++;
    for (const std::uint32_t id : entity_update.removed()) {
        removed.insert(id);
        expect(entities.erase(id) == 1,
               "an EntityUpdate removes entity " + std::to_string(id) + ", which does not exist");
    }
    for (const v1::Entity& entity : entity_update.added()) {
        for (const v1::Shape& shape : entity.shapes())
            expect(!shape.has_geometry() || geometry.contains(shape.geometry()),
                   "an EntityUpdate refers to a geometry that was not sent");
        expect(entities.emplace(entity.id(), entity).second,
               "an EntityUpdate adds entity " + std::to_string(entity.id()) + " twice");
    }
}

void PlayState::take(const v1::Events& happened) {
    const std::string name = "events of tick " + std::to_string(happened.tick());
    expect(wants_events, name + " without a subscription");
    expect(events.empty() || events.back().tick() < happened.tick(),
           name + " are not newer than the last events");
    expect(happened.tick() <= newest_frame, name + " precede the snapshot of that tick");
    v1::Events content = happened;
    content.clear_tick();
    content.clear_missed();
    expect(content.ByteSizeLong() > 0, name + " are empty");
    events.push_back(happened);
}

void PlayState::take_results(const v1::ClientUpdate& own) {
    for (const v1::InputResult& result : own.results()) {
        expect(results.emplace(result.sequence(), result).second,
               "input " + std::to_string(result.sequence()) + " has two results");
    }
}

const snapshot::QuantizedFrame* PlayState::find(std::uint32_t frame) const {
    const auto at = std::ranges::find(ring_, frame, &snapshot::QuantizedFrame::frame);
    return at == ring_.end() ? nullptr : &*at;
}

void PlayState::take(const v1::Snapshot& snapshot) {
    const std::string name = "snapshot " + std::to_string(snapshot.frame());
    snapshots++;
    snapshot_bytes += snapshot.packed().size();
    keyframes += snapshot.baselines() == 0;
    stats += snapshot.has_stats();
    if (snapshot.has_stats())
        restorable_ticks = {snapshot.stats().restorable_ticks().begin(),
                            snapshot.stats().restorable_ticks().end()};
    if (const std::uint32_t value = snapshot.client_update().snapshots_skipped(); value != 0)
        skipped = value;
    if (const std::int32_t value = snapshot.client_update().input_margin_us(); value != 0)
        input_margin_us = value;
    take_results(snapshot.client_update());
    expect(snapshot.frame() > newest_frame, name + " is not newer than the last one");
    for (const v1::UserMessage& message : snapshot.messages()) {
        expect(message.number() > newest_message_, name + " repeats a user message");
        newest_message_ = message.number();
        newest_message = message.data();
    }
    for (const v1::PlayerUpdate& update : snapshot.players()) {
        expect(has_players_ || update.complete() || update.events().empty(),
               name + " has player events before the player list");
        has_players_ = has_players_ || update.complete();
    }

    const auto baseline_of = [&](std::uint32_t frame) {
        const snapshot::QuantizedFrame* baseline = frame == 0 ? nullptr : find(frame);
        expect(frame == 0 || baseline != nullptr,
               name + " refers to frame " + std::to_string(frame) + ", which was never sent");
        return baseline;
    };
    const auto baseline_ids =
        snapshot::decode_baseline_frames(snapshot.frame(), snapshot.baselines());
    expect(baseline_ids.ok(), name + " has invalid baselines");
    if (!baseline_ids.ok()) return;
    const snapshot::Baselines baselines{baseline_of(baseline_ids->baseline),
                                        baseline_of(baseline_ids->baseline2),
                                        baseline_of(baseline_ids->baseline3)};
    const auto frame = welcome.cells() ? assemble_cells(snapshot, name)
                                       : decoded(name, snapshot.frame(), snapshot.packed(),
                                                 baselines, snapshot.crc());
    if (!frame) return;
    expect(std::ranges::all_of(frame->entities,
                               [&](const auto& entity) { return entities.contains(entity.id); }),
           name + " contains an entity that was not added");

    ages_ms.push_back(age_ms(due_us(snapshot)));
    crc_of[snapshot.frame()] = snapshot.crc();
    newest_frame = snapshot.frame();
    ring_.push_back(*frame);
    if (ring_.size() > ring_size) ring_.pop_front();
    for (const v1::Events& tick : snapshot.events()) take(tick);
}

std::optional<snapshot::QuantizedFrame> PlayState::decoded(const std::string& name,
                                                           std::uint32_t number,
                                                           const std::string& packed,
                                                           const snapshot::Baselines& baselines,
                                                           std::uint32_t crc) {
    const snapshot::QuantSpec spec{static_cast<std::int32_t>(welcome.quant().units_per_meter()),
                                   static_cast<std::int32_t>(welcome.quant().rotation_component())};
    auto frame = snapshot::decode_frame(
        number, std::as_bytes(std::span(packed)), baselines, spec, snapshot::default_entities_max,
        static_cast<snapshot::Codec>(std::max(1u, welcome.codec())));
    expect(frame.ok(), name + " cannot be decoded: " + (frame.ok() ? "" : frame.error().message));
    if (!frame.ok()) return std::nullopt;
    expect(snapshot::frame_crc(*frame) == crc, name + " has a wrong CRC");
    return *std::move(frame);
}

// Combines all cells as defined in WIRE.md, each entity once.
std::optional<snapshot::QuantizedFrame> PlayState::assemble_cells(const v1::Snapshot& snapshot,
                                                                  const std::string& name) {
    expect(snapshot.packed().empty(), name + " has both cells and a frame");
    for (const std::uint32_t cell : snapshot.cells_left())
        expect(cells.erase(cell) == 1, name + " removes an unknown cell");
    for (const v1::CellUpdate& part : snapshot.cells()) {
        auto& states = cells[part.cell()];
        const std::string cell = name + ", cell " + std::to_string(part.cell());
        const auto baseline_of = [&](std::uint32_t number) -> const snapshot::QuantizedFrame* {
            expect(number == 0 || states.contains(number),
                   cell + " refers to a state that was not sent");
            return number != 0 && states.contains(number) ? &states[number] : nullptr;
        };
        const auto ids = snapshot::decode_baseline_frames(part.number(), part.baselines());
        expect(ids.ok(), cell + " has invalid baselines");
        if (!ids.ok()) return std::nullopt;
        auto state = decoded(
            cell, part.number(), part.packed(),
            {baseline_of(ids->baseline), baseline_of(ids->baseline2), baseline_of(ids->baseline3)},
            part.crc());
        if (!state) return std::nullopt;
        if (part.baselines() == 0) states.clear();
        states[part.number()] = *std::move(state);
    }
    std::map<std::uint32_t, std::pair<std::uint32_t, snapshot::EntityState>> newest;
    for (const auto& [cell, states] : cells)
        for (const snapshot::EntityState& entity : states.rbegin()->second.entities)
            if (const auto known = newest.find(entity.id);
                known == newest.end() || known->second.first < states.rbegin()->first)
                newest[entity.id] = {states.rbegin()->first, entity};
    snapshot::QuantizedFrame frame{.frame = snapshot.frame(), .entities = {}};
    for (const auto& [id, entry] : newest)
        if (!removed.contains(id)) frame.entities.push_back(entry.second);
    return frame;
}

std::uint64_t PlayState::due_us(const v1::Snapshot& snapshot) const {
    const double since = snapshot.frame() * 1e6 / welcome.tick_hz();
    return static_cast<std::uint64_t>(static_cast<double>(welcome.epoch_us()) + since +
                                      static_cast<double>(snapshot.late_us()));
}

}  // namespace jostle::test
