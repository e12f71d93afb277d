// SPDX-License-Identifier: MIT
#include "jostle/modules/cosmetic_particles.h"

#include <algorithm>
#include <cmath>

#include "jostle/physics/module.h"
#include "modules/particles/src/particle_fields.h"

namespace jostle::modules {

using namespace physics;

namespace {

constexpr std::size_t groups_max = 64;

// The definitions as the state of a module, so that they are encoded and checked like saved worlds.
class CosmeticDefinitions final : public Module {
public:
    Vec3 gravity;
    std::vector<ParticleGroupDef> defs;

    std::string_view tag() const override { return "cosmetic"; }
    void visit(StateVisitor& v) override {
        v.field("gravity", gravity);
        v.all("groups", defs, [&](ParticleGroupDef& def) {
            if (v.failed() || defs.size() > groups_max) return;
            particles_detail::StateFields fields(v);
            particles_detail::visit_def(fields, def);
            if (!v.loading() || v.failed()) return;
            if (Status s = check(def); !s.ok()) v.fail("def", s.error().message);
            if (!def.cosmetic) v.fail("cosmetic", "is false");
        });
        if (v.loading() && defs.size() > groups_max) v.fail("groups", "has more than 64 elements");
    }
};

Error corrupt(const std::string& what) {
    return {ErrorCode::corrupt_data, "cosmetic particles: " + what};
}

Result<std::vector<std::byte>> bytes_of(std::span<const std::int32_t> values) {
    if (values.size() < 2) return corrupt("the values end before their size");
    if (values[0] != cosmetic_version)
        return corrupt("version is " + std::to_string(values[0]) + "; must be " +
                       std::to_string(cosmetic_version));
    const auto size = static_cast<std::uint32_t>(values[1]);
    if ((std::size_t{size} + 3) / 4 != values.size() - 2)
        return corrupt("size is " + std::to_string(size) + " bytes, but " +
                       std::to_string(values.size() - 2) + " values follow");
    std::vector<std::byte> bytes;
    for (std::uint32_t k = 0; k < size; k++)
        bytes.push_back(static_cast<std::byte>(
            static_cast<std::uint32_t>(values[2 + k / 4]) >> (8 * (k % 4)) & 0xff));
    return bytes;
}

double longest_life(std::span<const ParticleGroup> groups) {
    double most = 0;
    for (const ParticleGroup& group : groups) {
        const Emitter& e = group.def().emitter;
        most = maximum(most, e.lifetime * (1 + e.lifetime_spread));
    }
    return most;
}

}  // namespace

std::vector<std::int32_t> encode_cosmetic(Vec3 gravity,
                                          std::span<const ParticleGroupDef* const> defs) {
    CosmeticDefinitions definitions;
    definitions.gravity = gravity;
    for (const ParticleGroupDef* def : defs) definitions.defs.push_back(*def);
    const std::vector<std::byte> bytes = save_module(definitions);
    std::vector<std::int32_t> values = {cosmetic_version, static_cast<std::int32_t>(bytes.size())};
    for (std::size_t k = 0; k < bytes.size(); k += 4) {
        std::uint32_t word = 0;
        for (std::size_t n = 0; n < 4 && k + n < bytes.size(); n++)
            word |= std::to_integer<std::uint32_t>(bytes[k + n]) << (8 * n);
        values.push_back(static_cast<std::int32_t>(word));
    }
    return values;
}

Status CosmeticParticles::decode(std::span<const std::int32_t> values) {
    if (std::ranges::equal(values, values_)) return {};
    const Result<std::vector<std::byte>> bytes = bytes_of(values);
    if (!bytes.ok()) return bytes.error();
    CosmeticDefinitions definitions;
    if (Status s = load_module(definitions, *bytes); !s.ok()) return s;
    const Vec3 g = abs(definitions.gravity);
    if (!(maximum(g.x, maximum(g.y, g.z)) <= 1e4)) return corrupt("gravity is out of range");
    std::vector<ParticleGroup> groups;
    for (const ParticleGroupDef& def : definitions.defs) {
        Result<ParticleGroup> group = ParticleGroup::create(def);
        if (!group.ok()) return group.error();
        groups.push_back(std::move(*group));
    }
    groups_ = std::move(groups);
    gravity_ = definitions.gravity;
    values_.assign(values.begin(), values.end());
    step_ = -1;  // start one lifetime before the next time
    return {};
}

void CosmeticParticles::advance_to(double time) {
    if (!(time >= 0 && time <= 1e12)) return;
    const auto last = static_cast<std::int64_t>(std::floor(time / cosmetic_step));
    const auto life =
        static_cast<std::int64_t>(std::ceil(longest_life(groups_) / cosmetic_step)) + 1;
    if (step_ < 0 || last < step_ || last - step_ > life) {
        for (ParticleGroup& group : groups_) group.clear();
        step_ = std::max<std::int64_t>(last - life, 0);
    }
    for (; step_ < last; step_++) {
        const double begin = static_cast<double>(step_) * cosmetic_step;
        const double end = static_cast<double>(step_ + 1) * cosmetic_step;
        for (ParticleGroup& group : groups_) group.advance({.gravity = gravity_}, begin, end);
    }
}

}  // namespace jostle::modules
