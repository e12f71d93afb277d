// SPDX-License-Identifier: MIT
//
// Turns disconnected groups into bodies of their own. Each continues with the velocity of its
// points in the original body, so mass and momentum are conserved.
#include <algorithm>

#include "modules/destruction/src/bond_network.h"
#include "modules/destruction/src/destruction_data.h"
#include "modules/destruction/src/destruction_steps.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

// Up to this number, shapes are removed one by one, so the contacts of the others persist.
constexpr std::size_t removed_one_by_one_max = 4;

// Collision group of passing debris: shapes in the same negative group do not collide.
constexpr std::int32_t passing_group = -0x6a6f7374;

ShapeDef shifted(const ShapeState& shape, Vec3 by, bool bonded) {
    ShapeDef def = def_of(shape);
    def.report_stays = bonded;
    def.pose.position += by;
    return def;
}

bool is_anchored(const Destructible& destructible, const Group& group) {
    return std::any_of(group.chunks.begin(), group.chunks.end(),
                       [&](std::uint32_t c) { return destructible.chunks[c].anchored; });
}

Vec3 center_of(const Destructible& destructible, const Group& group) {
    double mass = 0;
    Vec3 sum;
    for (const std::uint32_t c : group.chunks) {
        mass += destructible.chunks[c].mass;
        sum += destructible.chunks[c].center * destructible.chunks[c].mass;
    }
    return sum / mass;
}

bool is_passing_debris(const DestructionState& state, const Destructible& destructible,
                       const Group& group) {
    return group.chunks.size() == 1 && !is_anchored(destructible, group) &&
           destructible.chunks[group.chunks[0]].mass <
               destructible.density * state.limits.passing_volume;
}

// Removes the shapes of the leaving groups from the original body.
void remove_detached_shapes(World& world, Destructible& destructible, Piece& piece,
                            std::span<const Group> leaving) {
    std::size_t removed = 0;
    for (const Group& group : leaving) removed += group.chunks.size();
    std::vector<ShapeDef> defs;
    std::vector<std::uint32_t> owners;
    std::vector<ShapeId> remaining;
    for (const std::uint32_t c : piece.chunks) remaining.push_back(destructible.chunks[c].shape);
    std::sort(remaining.begin(), remaining.end());
    if (removed <= removed_one_by_one_max) {
        for (const ShapeId shape : world.shapes_of(piece.body))
            if (!std::binary_search(remaining.begin(), remaining.end(), shape))
                static_cast<void>(world.destroy_shape(shape).ok());
        return;
    }
    for (const std::uint32_t c : piece.chunks) {
        const Result<ShapeState> shape = world.shape(destructible.chunks[c].shape);
        if (!shape.ok() || shape->body != piece.body) continue;
        defs.push_back(shifted(*shape, {}, piece.chunks.size() > 1));
        owners.push_back(c);
    }
    const Result<std::vector<ShapeId>> shapes = world.set_shapes(piece.body, defs);
    if (!shapes.ok()) return;
    for (std::size_t k = 0; k < owners.size(); k++)
        destructible.chunks[owners[k]].shape = (*shapes)[k];
}

// Creates bodies for the leaving groups, then removes their shapes from the original body. On
// failure, nothing changes.
Status detach_groups(DestructionState& state, World& world, Destructible& destructible,
                     std::size_t p, std::span<const Group> leaving, const Group& staying) {
    const BodyId old = destructible.pieces[p].body;
    const Result<BodyState> body = world.body(old);
    if (!body.ok()) return body.error();
    const Vec3 origin = destructible.pieces[p].origin;
    std::vector<BodyAndShapes> defs;
    std::vector<Piece> made;
    for (const Group& group : leaving) {
        Piece piece{.origin = center_of(destructible, group),
                    .chunks = group.chunks,
                    .anchored = is_anchored(destructible, group)};
        BodyAndShapes& def = defs.emplace_back();
        def.body = {.type = piece.anchored ? BodyType::static_body : BodyType::dynamic,
                    .pose = {apply(body->pose, piece.origin - origin), body->pose.rotation},
                    .sleep_allowed = body->sleep_allowed,
                    .user_data = body->user_data};
        for (const std::uint32_t c : group.chunks) {
            const Result<ShapeState> shape = world.shape(destructible.chunks[c].shape);
            if (!shape.ok()) return shape.error();
            if (shape->body != old)
                return Error{ErrorCode::failed_precondition,
                             "a shape of a chunk belongs to another body"};
            def.shapes.push_back(shifted(*shape, origin - piece.origin, group.chunks.size() > 1));
            Filter& filter = def.shapes.back().filter;
            if (filter.group != 0 || !is_passing_debris(state, destructible, group)) continue;
            filter.group = passing_group;
            def.body.continuous = false;
        }
        made.push_back(std::move(piece));
    }
    const Result<std::vector<BodyId>> bodies = world.create_bodies(defs);
    if (!bodies.ok()) return bodies.error();
    for (std::size_t k = 0; k < made.size(); k++) {
        Piece& piece = made[k];
        piece.body = (*bodies)[k];
        const std::vector<ShapeId> shapes = world.shapes_of(piece.body);
        for (std::size_t c = 0; c < piece.chunks.size(); c++)
            destructible.chunks[piece.chunks[c]].shape = shapes[c];
        if (!piece.anchored && body->type == BodyType::dynamic) {
            const Result<BodyState> now = world.body(piece.body);
            const Vec3 v =
                body->linear_velocity + cross(body->angular_velocity, now->center - body->center);
            static_cast<void>(world.set_velocity(piece.body, v, body->angular_velocity).ok());
        }
    }
    Piece& rest = destructible.pieces[p];
    rest.chunks = staying.chunks;
    rest.solve_pending = true;
    rest.solved = false;
    rest.factor.reset();
    remove_detached_shapes(world, destructible, rest, leaving);
    destructible.pieces.insert(destructible.pieces.end(), std::make_move_iterator(made.begin()),
                               std::make_move_iterator(made.end()));
    state.derived = false;
    return {};
}

// The largest group keeps the body; in an anchored piece, the largest anchored group. At most
// `limit` other groups leave. Returns the number of groups that left.
int split(DestructionState& state, World& world, Destructible& destructible, std::size_t p,
          int limit) {
    drop_lost_chunks(state, world, destructible, destructible.pieces[p]);
    if (destructible.pieces[p].chunks.empty()) return 0;
    std::vector<Group> groups;
    {
        Group all{destructible.pieces[p].chunks, {}};
        std::vector<bool> in_piece(destructible.chunks.size());
        for (const std::uint32_t c : all.chunks) in_piece[c] = true;
        for (std::uint32_t k = 0; k < destructible.bonds.size(); k++)
            if (in_piece[destructible.bonds[k].face.a] && in_piece[destructible.bonds[k].face.b])
                all.bonds.push_back(k);
        groups = connected_groups(destructible, all);
    }
    std::size_t stays = 0;
    const auto rank = [&](std::size_t k) {
        return std::pair(is_anchored(destructible, groups[k]), groups[k].chunks.size());
    };
    for (std::size_t k = 1; k < groups.size(); k++)
        if (rank(k) > rank(stays)) stays = k;
    std::vector<Group> leaving;
    Group staying = groups[stays];
    for (std::size_t k = 0; k < groups.size(); k++) {
        if (k == stays) continue;
        if (static_cast<int>(leaving.size()) < limit)
            leaving.push_back(std::move(groups[k]));
        else
            staying.chunks.insert(staying.chunks.end(), groups[k].chunks.begin(),
                                  groups[k].chunks.end());
    }
    std::sort(staying.chunks.begin(), staying.chunks.end());
    const bool all = leaving.size() + 1 == groups.size();
    // If a split fails, for example because the world has no room for more bodies, the piece stays
    // as it is.
    const bool parted =
        leaving.empty() || detach_groups(state, world, destructible, p, leaving, staying).ok();
    Piece& rest = destructible.pieces[p];
    rest.split_pending = parted && !all;
    rest.solve_pending = true;
    rest.solved = false;
    rest.factor.reset();
    state.derived = false;
    if (parted && rest.anchored && !is_anchored(destructible, staying)) {
        static_cast<void>(world.set_type(rest.body, BodyType::dynamic).ok());
        rest.anchored = false;
    }
    return static_cast<int>(leaving.size());
}

}  // namespace

void split_all_pieces(DestructionState& state, World& world) {
    int limit = state.limits.pieces_per_step;
    for (Destructible& destructible : state.destructibles) {
        const std::size_t count = destructible.pieces.size();  // new pieces are connected already
        for (std::size_t p = 0; p < count && limit > 0; p++)
            if (destructible.pieces[p].split_pending)
                limit -= split(state, world, destructible, p, limit);
        std::erase_if(destructible.pieces, [](const Piece& piece) { return piece.chunks.empty(); });
    }
}

void drop_debris(DestructionState& state, World& world, double dt) {
    if (!(state.limits.debris_life > 0)) return;
    for (Destructible& destructible : state.destructibles) {
        const std::size_t count = destructible.pieces.size();
        std::erase_if(destructible.pieces, [&](Piece& piece) {
            if (piece.anchored || piece.chunks.size() != 1) return false;
            if (destructible.chunks[piece.chunks[0]].mass >=
                destructible.density * state.limits.debris_volume)
                return false;
            piece.age += dt;
            if (piece.age < state.limits.debris_life) return false;
            static_cast<void>(world.destroy_body(piece.body).ok());
            return true;
        });
        state.derived = state.derived && destructible.pieces.size() == count;
    }
}

}  // namespace jostle::modules::destruction_detail
