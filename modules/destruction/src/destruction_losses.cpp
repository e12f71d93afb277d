// SPDX-License-Identifier: MIT
//
// What somebody else destroyed: a body whose owner left, or a shape. The chunks are gone with it;
// all else goes on.
#include <algorithm>

#include "jostle/modules/destruction.h"
#include "modules/destruction/src/destruction_impact.h"

namespace jostle::modules {

using namespace physics;
using namespace destruction_detail;

// Pieces without a body go. Their chunks are then in no piece, and bonds to them hold nothing.
void Destruction::drop_lost_bodies(const World& world) {
    for (Destructible& destructible : destructibles_)
        if (std::erase_if(destructible.pieces,
                          [&](const Piece& piece) { return !world.contains(piece.body); }) > 0)
            derived_ = false;
}

// Before a piece is parted: of chunks whose shape is not the body's any more. What is left may hang
// together no longer.
void Destruction::drop_lost_chunks(const World& world, Destructible& destructible, Piece& piece) {
    const auto is_lost = [&](std::uint32_t c) {
        const Result<ShapeState> shape = world.shape(destructible.chunks[c].shape);
        return !shape.ok() || shape->body != piece.body;
    };
    std::vector<bool> lost(destructible.chunks.size());
    for (const std::uint32_t c : piece.chunks) lost[c] = is_lost(c);
    if (std::erase_if(piece.chunks, [&](std::uint32_t c) { return lost[c]; }) == 0) return;
    for (Bond& bond : destructible.bonds)
        bond.broken = bond.broken || lost[bond.face.a] || lost[bond.face.b];
    derived_ = false;
}

}  // namespace jostle::modules
