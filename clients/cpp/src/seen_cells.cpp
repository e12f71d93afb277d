// SPDX-License-Identifier: MIT
#include "seen_cells.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "wire/base_frames.h"

namespace jostle::client {

Result<wire::QuantizedFrame> SeenCells::decode(const v1::CellPart& part,
                                               const wire::QuantSpec& spec,
                                               wire::Codec codec) const {
    const std::string name =
        "cell " + std::to_string(part.cell()) + " of tick " + std::to_string(part.number());
    const Result<wire::BaseFrames> told = wire::decode_base_frames(part.number(), part.bases());
    if (!told.ok()) return Error{told.error().code, name + ": " + told.error().message};
    const auto known = cells_.find(part.cell());
    if (known != cells_.end() && part.bases() != 0 && part.number() <= known->second.back().frame)
        return Error{ErrorCode::failed_precondition, name + " is not newer than the last one"};
    wire::Bases bases;
    const wire::QuantizedFrame** slots[] = {&bases.base, &bases.base2, &bases.base3};
    const std::uint32_t numbers[] = {told->base, told->base2, told->base3};
    for (int k = 0; k < 3 && numbers[k] != 0; k++) {
        if (known != cells_.end())
            for (const wire::QuantizedFrame& state : known->second)
                if (state.frame == numbers[k]) *slots[k] = &state;
        if (*slots[k] == nullptr)
            return Error{ErrorCode::failed_precondition,
                         name + ": its state " + std::to_string(numbers[k]) + " is not known"};
    }
    const auto* bytes = reinterpret_cast<const std::byte*>(part.packed().data());
    auto state = wire::decode_frame(part.number(), {bytes, part.packed().size()}, bases, spec,
                                    wire::default_entities_max, codec);
    if (!state.ok()) return Error{state.error().code, name + ": " + state.error().message};
    if (wire::frame_crc(*state) != part.crc())
        return Error{ErrorCode::corrupt_data, name + ": the CRC does not match"};
    return state;
}

Status SeenCells::apply(const v1::Snapshot& snapshot, const wire::QuantSpec& spec,
                        wire::Codec codec) {
    std::vector<std::pair<std::uint32_t, wire::QuantizedFrame>> fresh;
    for (const v1::CellPart& part : snapshot.cells()) {
        auto state = decode(part, spec, codec);
        if (!state.ok()) return state.error();
        fresh.emplace_back(part.cell(), *std::move(state));
    }
    for (const std::uint32_t cell : snapshot.cells_left()) cells_.erase(cell);
    for (auto& [cell, state] : fresh) {
        States& states = cells_[cell];
        // One that is told whole begins anew.
        if (!states.empty() && state.frame <= states.back().frame) states.clear();
        states.push_back(std::move(state));
        if (states.size() > kept) states.pop_front();
    }
    return {};
}

wire::QuantizedFrame SeenCells::frame(std::uint32_t number) const {
    struct Seen {
        const wire::EntityState* entity;
        std::uint32_t number;
    };
    std::vector<Seen> all;
    for (const auto& [cell, states] : cells_)
        for (const wire::EntityState& entity : states.back().entities)
            all.push_back({&entity, states.back().frame});
    std::ranges::sort(all, [](const Seen& a, const Seen& b) {
        return a.entity->id != b.entity->id ? a.entity->id < b.entity->id : a.number > b.number;
    });
    wire::QuantizedFrame frame{.frame = number, .entities = {}};
    frame.entities.reserve(all.size());
    for (const Seen& seen : all)
        if (frame.entities.empty() || frame.entities.back().id != seen.entity->id)
            frame.entities.push_back(*seen.entity);
    return frame;
}

}  // namespace jostle::client
