// SPDX-License-Identifier: MIT
//
// Handles bodies and shapes that other callers destroyed, such as the owner of a body that left.
// The affected chunks are lost; the rest continues.
#include <algorithm>

#include "modules/destruction/src/destruction_data.h"
#include "modules/destruction/src/destruction_steps.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

// Removes pieces without a body. Their chunks then belong to no piece, and bonds to them are
// inactive.
void drop_lost_bodies(DestructionState& state, const World& world) {
    for (Destructible& destructible : state.destructibles)
        if (std::erase_if(destructible.pieces,
                          [&](const Piece& piece) { return !world.contains(piece.body); }) > 0)
            state.derived = false;
}

// Removes chunks whose shape no longer belongs to the body, before the piece is split. The
// remaining chunks may be disconnected.
void drop_lost_chunks(DestructionState& state, const World& world, Destructible& destructible,
                      Piece& piece) {
    const auto is_lost = [&](std::uint32_t c) {
        const Result<ShapeState> shape = world.shape(destructible.chunks[c].shape);
        return !shape.ok() || shape->body != piece.body;
    };
    std::vector<bool> lost(destructible.chunks.size());
    for (const std::uint32_t c : piece.chunks) lost[c] = is_lost(c);
    if (std::erase_if(piece.chunks, [&](std::uint32_t c) { return lost[c]; }) == 0) return;
    for (Bond& bond : destructible.bonds)
        bond.broken = bond.broken || lost[bond.face.a] || lost[bond.face.b];
    state.derived = false;
}

}  // namespace jostle::modules::destruction_detail
