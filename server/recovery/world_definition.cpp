// SPDX-License-Identifier: MIT
#include "server/recovery/world_definition.h"

#include <utility>

#include "jostle/physics/arithmetic.h"
#include "jostle/scenes/scene_file.h"
#include "server/util/bytes.h"

namespace jostle::server {
namespace {

constexpr std::uint64_t definition_version = 4;

Error not_a_definition(const std::string& why) {
    return {ErrorCode::corrupt_data, "corrupt world definition: " + why};
}

}  // namespace

std::string encode_world_definition(const WorldDefinition& definition) {
    ByteWriter to;
    to.number(definition_version);
    to.text(definition.owner);
    to.text(scenes::write_scene_json(*definition.scene));
    const SceneBudget& scene = definition.limits.scene;
    to.real(scene.bodies_max);
    to.real(scene.joints_max);
    to.real(scene.joints_per_pair_max);
    to.real(scene.geometry_bytes_max);
    to.real(scene.body_geometry_bytes_max);
    to.real(scene.work_per_second_max);
    to.real(scene.first_step_seconds_max);
    to.real(definition.limits.bodies_owned_max);
    to.real(definition.limits.lag_compensation_ms_max);
    to.real(definition.work_per_second);
    to.real(scene.pairs_per_shape_max);                                // since version 2
    const AttributeLimits& attributes = definition.limits.attributes;  // since version 3
    to.real(attributes.per_target_max);
    to.real(attributes.text_bytes_max);
    to.real(attributes.client_bytes_max);
    to.real(attributes.world_bytes_max);
    to.real(definition.limits.joints_owned_max);  // since version 4
    return to.take();
}

Result<WorldDefinition> decode_world_definition(std::string_view bytes) {
    ByteReader from(bytes);
    const std::uint64_t version = from.number();
    if (from.ok() && (version < 1 || version > definition_version))
        return Error{ErrorCode::failed_precondition,
                     "unsupported world definition: version " + std::to_string(version) +
                         "; this server reads versions 1 to " + std::to_string(definition_version)};
    WorldDefinition definition;
    definition.owner = from.text();
    Result<scenes::SceneDescription> scene = scenes::read_scene_json(from.text());
    bool fits = true;
    const auto count = [&] {
        const double value = from.real();
        fits = fits && value >= 0 && value <= 2e9;
        return fits ? static_cast<int>(value) : 0;
    };
    SceneBudget& budget = definition.limits.scene;
    budget.bodies_max = count();
    budget.joints_max = count();
    budget.joints_per_pair_max = count();
    budget.geometry_bytes_max = from.real();
    budget.body_geometry_bytes_max = count();
    budget.work_per_second_max = from.real();
    budget.first_step_seconds_max = from.real();
    definition.limits.bodies_owned_max = count();
    definition.limits.lag_compensation_ms_max = from.real();
    definition.work_per_second = from.real();
    budget.pairs_per_shape_max = version < 2 ? 0 : count();  // worlds of version 1 had no limit
    if (AttributeLimits& attributes = definition.limits.attributes; version >= 3) {
        attributes.per_target_max = count();
        attributes.text_bytes_max = count();
        attributes.client_bytes_max = count();
        attributes.world_bytes_max = count();
    }
    if (version >= 4) definition.limits.joints_owned_max = count();
    if (!from.ok()) return not_a_definition("unexpected end of data");
    if (!from.at_end()) return not_a_definition("data after the end");
    if (!fits || !(definition.limits.lag_compensation_ms_max >= 0))
        return not_a_definition("a limit is out of range");
    if (!scene.ok()) return not_a_definition("invalid scene: " + scene.error().message);
    definition.scene = std::make_shared<const scenes::SceneDescription>(*std::move(scene));
    return definition;
}

std::string build_engine_id() {
    return std::string(physics::arithmetic_name(physics::arithmetic())) + " " + JOSTLE_VERSION;
}

}  // namespace jostle::server
