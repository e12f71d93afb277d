// SPDX-License-Identifier: MIT
//
// Serialization, client channel and scene settings of destructibles.
#include <algorithm>

#include "jostle/modules/destruction.h"
#include "jostle/modules/fracture_file.h"
#include "jostle/modules/settings.h"
#include "modules/destruction/src/destruction_checks.h"
#include "modules/destruction/src/destruction_data.h"
#include "modules/destruction/src/destruction_steps.h"

namespace jostle::modules {

using namespace physics;
using namespace destruction_detail;

namespace {

constexpr double saved_load_max = 1e30;  // N, N m

void unit_vector(StateVisitor& v, std::string_view name, Vec3& value) {
    v.field(name, value);
    if (v.loading() && !(absolute(length_squared(value) - 1) < 1e-6))
        v.fail(name, "is not a unit vector");
}

void visit_bond(StateVisitor& v, FractureBond& bond) {
    v.field("a", bond.a);
    v.field("b", bond.b);
    bounded(v, "center", bond.center, coordinate_max);
    unit_vector(v, "normal", bond.normal);
    unit_vector(v, "axis", bond.axis);
    bounded(v, "area", bond.area, area_min, area_max);
    bounded(v, "moment_u", bond.moment_u, second_moment_min, second_moment_max);
    bounded(v, "moment_v", bond.moment_v, second_moment_min, second_moment_max);
    bounded(v, "reach_u", bond.reach_u, 0, coordinate_max);
    bounded(v, "reach_v", bond.reach_v, 0, coordinate_max);
}

void visit_material(StateVisitor& v, BondMaterial& m) {
    bounded(v, "young", m.young, 1, 1e13);
    bounded(v, "poisson", m.poisson, 0, 0.5);
    bounded(v, "tensile", m.tensile, 1, 1e13);
    bounded(v, "shear", m.shear, 1, 1e13);
    bounded(v, "compressive", m.compressive, 1, 1e13);
    bounded(v, "fracture_energy", m.fracture_energy, 0, 1e9);
    bounded(v, "contact_time", m.contact_time, 1e-5, 1);
}

// Checks the consistency of loaded fields. Each chunk is in one piece, or in none if it was lost.
void check_destructible(StateVisitor& v, const Destructible& destructible) {
    if (destructible.alive == destructible.chunks.empty())
        v.fail("chunks", "must be present exactly if the destructible is alive");
    if (destructible.chunks.size() > chunks_max) v.fail("chunks", "has too many elements");
    for (const Bond& bond : destructible.bonds)
        if (!(bond.face.a < bond.face.b && bond.face.b < destructible.chunks.size())) {
            v.fail("bonds", "has a bond without two valid chunks");
            return;
        }
    std::vector<bool> taken(destructible.chunks.size());
    for (const Piece& piece : destructible.pieces) {
        if (piece.chunks.empty()) v.fail("pieces", "has a piece without chunks");
        bool anchored = false;
        for (std::size_t k = 0; k < piece.chunks.size(); k++) {
            const std::uint32_t c = piece.chunks[k];
            if (c >= destructible.chunks.size() || taken[c] ||
                (k > 0 && c <= piece.chunks[k - 1])) {
                v.fail("pieces",
                       "has a chunk that does not exist, is a duplicate, or is out of order");
                return;
            }
            taken[c] = true;
            anchored = anchored || destructible.chunks[c].anchored;
        }
        if (anchored != piece.anchored)
            v.fail("anchored", "does not match the chunks of the piece");
    }
}

void visit_destructible(StateVisitor& v, Destructible& destructible) {
    v.field("alive", destructible.alive);
    v.field("generation", destructible.generation);
    visit_material(v, destructible.material);
    bounded(v, "density", destructible.density, 0, 1e6);
    v.all("chunks", destructible.chunks, [&](Chunk& chunk) {
        bounded(v, "center", chunk.center, coordinate_max);
        bounded(v, "mass", chunk.mass, mass_min, mass_max);
        bounded(v, "inertia_x", chunk.inertia.x, inertia_max);
        bounded(v, "inertia_y", chunk.inertia.y, inertia_max);
        bounded(v, "inertia_z", chunk.inertia.z, inertia_max);
        v.field("shape", chunk.shape);
        v.field("anchored", chunk.anchored);
        bounded(v, "force", chunk.force, saved_load_max);
        bounded(v, "torque", chunk.torque, saved_load_max);
    });
    v.all("bonds", destructible.bonds, [&](Bond& bond) {
        visit_bond(v, bond.face);
        v.field("broken", bond.broken);
    });
    v.all("pieces", destructible.pieces, [&](Piece& piece) {
        v.field("body", piece.body);
        bounded(v, "origin", piece.origin, coordinate_max);
        v.all("chunks", piece.chunks, [&](std::uint32_t& chunk) { v.field("chunk", chunk); });
        v.field("anchored", piece.anchored);
        v.field("check", piece.solve_pending);
        v.field("solved", piece.solved);
        v.field("loaded", piece.loaded);
        v.field("carried", piece.loads_pending);
        v.field("cut", piece.split_pending);
        bounded(v, "spin2", piece.spin2, 0, 1e13);
        bounded(v, "energy", piece.energy, 0, saved_load_max);
        bounded(v, "age", piece.age, 0, 1e7);
        bounded(v, "knocked", piece.passing_time, 0, 1);
        if (v.loading()) piece.factor.reset();
    });
    if (v.loading()) check_destructible(v, destructible);
}

void visit_limits(StateVisitor& v, DestructionLimits& limits) {
    std::int32_t rounds = limits.rounds, pieces = limits.pieces_per_step;
    v.field("rounds", rounds);
    v.field("pieces_per_step", pieces);
    v.field("work_per_step", limits.work_per_step);
    v.field("debris_life", limits.debris_life);
    v.field("debris_volume", limits.debris_volume);
    v.field("passing_volume", limits.passing_volume);
    if (!v.loading()) return;
    limits.rounds = rounds;
    limits.pieces_per_step = pieces;
    if (const Status s = check_limits(limits); !s.ok()) v.fail("limits", s.error().message);
}

}  // namespace

void destruction_detail::visit_state(StateVisitor& v, DestructionState& state) {
    visit_limits(v, state.limits);
    bounded(v, "gravity", state.gravity, 1e5);
    v.all("wholes", state.destructibles,
          [&](Destructible& destructible) { visit_destructible(v, destructible); });
    v.all("again", state.reversed_contacts, [&](ReversedContact& again) {
        v.field("whole", again.destructible);
        v.field("chunk", again.chunk);
        if (v.loading() && (again.destructible >= state.destructibles.size() ||
                            again.chunk >= state.destructibles[again.destructible].chunks.size()))
            v.fail("chunk", "does not exist");
        v.field("other", again.other);
        v.field("other_body", again.other_body);
        bounded(v, "point", again.point, 1e9);
        unit_vector(v, "normal", again.normal);
        bounded(v, "approach", again.approach_speed, 0, 1e9);
    });
    if (v.loading()) state.derived = false;
}

void Destruction::visit(StateVisitor& v) {
    visit_state(v, *state_);
}

void Destruction::publish(const World&, ChannelWriter& channels) const {
    const auto count = [&](std::size_t value) { channels.value(static_cast<std::int32_t>(value)); };
    if (size() == 0 || !channels.begin(0)) return;
    for (const Destructible& destructible : state_->destructibles) {
        if (!destructible.alive) continue;
        count(destructible.pieces.size());
        count(static_cast<std::size_t>(std::count_if(destructible.bonds.begin(),
                                                     destructible.bonds.end(),
                                                     [](const Bond& b) { return !b.broken; })));
        count(destructible.bonds.size());
    }
}

Status Destruction::configure(World& world, const ModuleSettings& given) {
    double count = 1, spacing = 8, width = 6, height = 3, thickness = 0.3, chunks = 150, seed = 1;
    double heading = 0;
    Vec3 foot;
    std::span<const std::byte> file;
    DestructibleDef def;
    DestructionLimits limits = state_->limits;
    SettingsReader settings(given);
    settings.bytes("shape", file);
    settings.number("count", count, 0, 100);
    settings.number("spacing", spacing, 0, 1000);
    settings.number("width", width, 0.1, 100);
    settings.number("height", height, 0.1, 100);
    settings.number("thickness", thickness, 0.02, 100);
    settings.number("chunks", chunks, 1, 2000);
    settings.number("seed", seed, 0, 1e9);
    settings.number("x", foot.x, -1e6, 1e6);
    settings.number("y", foot.y, -1e6, 1e6);
    settings.number("z", foot.z, -1e6, 1e6);
    settings.number("heading", heading, -7, 7);
    settings.number("density", def.density, 1, 1e5);
    settings.number("tensile", def.bonds.tensile, 1, 1e13);
    settings.number("shear", def.bonds.shear, 1, 1e13);
    settings.number("compressive", def.bonds.compressive, 1, 1e13);
    settings.number("fracture_energy", def.bonds.fracture_energy, 0, 1e9);
    settings.number("debris_life", limits.debris_life, 0, 1e6);
    settings.number("debris_volume", limits.debris_volume, 0, 1e12);
    settings.number("passing_volume", limits.passing_volume, 0, 1e12);
    if (Status s = settings.finish(); !s.ok()) return s;
    if (Status s = set_limits(limits); !s.ok()) return s;
    const Vec3 half{0.5 * width, 0.5 * height, 0.5 * thickness};
    Result<FracturedShape> shape =
        file.empty() ? fracture_box(half, random_seeds(half, static_cast<int>(chunks),
                                                       static_cast<std::uint64_t>(seed)))
                     : read_fracture(file);
    if (!shape.ok()) return shape.error();
    if (file.empty()) anchor(*shape, {0, -1, 0}, half.y * (1 - 1e-6));
    def.pose.rotation = from_axis_angle({0, 1, 0}, heading);
    for (int k = 0; k < static_cast<int>(count); k++) {
        def.pose.position = foot + Vec3{spacing * k, file.empty() ? half.y : 0, 0};
        if (const Result<DestructibleId> id = add(world, *shape, def); !id.ok()) return id.error();
    }
    return {};
}

}  // namespace jostle::modules
