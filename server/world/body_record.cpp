// SPDX-License-Identifier: MIT
#include "server/world/body_record.h"

#include <span>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/serialization.h"

namespace jostle::server {

using namespace physics;

namespace {

Error corrupt_record(std::string_view what) {
    return {ErrorCode::corrupt_data, "corrupt record of a " + std::string(what)};
}

std::string bytes_of(const World& world) {
    const std::vector<std::byte> saved = save(world);
    if (saved.size() > record_bytes_max) return {};
    return {reinterpret_cast<const char*>(saved.data()), saved.size()};
}

Result<World> world_of(std::string_view bytes) {
    if (bytes.size() > record_bytes_max) return corrupt_record("body or joint");
    return load(std::as_bytes(std::span(bytes)));
}

}  // namespace

BodyAndShapes definition_of(const World& world, BodyId body) {
    ASSERT(world.contains(body));
    BodyAndShapes out{.body = *world.definition(body)};
    for (const ShapeId shape : world.shapes_of(body))
        out.shapes.push_back(def_of(*world.shape(shape)));
    return out;
}

std::string record_body(const World& world, BodyId body) {
    const BodyAndShapes def = definition_of(world, body);
    World copy;
    if (!copy.create_body(def.body, def.shapes).ok()) return {};
    return bytes_of(copy);
}

Result<BodyAndShapes> body_of_record(std::string_view bytes) {
    const Result<World> world = world_of(bytes);
    if (!world.ok()) return world.error();
    const std::vector<BodyId> bodies = world->bodies();
    if (bodies.size() != 1) return corrupt_record("body");
    return definition_of(*world, bodies.front());
}

std::string record_joint(const JointDef& joint) {
    World copy;
    const auto body = copy.create_body({}, ShapeDef{.geometry = Sphere{1}});
    ASSERT(body.ok());
    JointDef def = joint;
    def.body_a = {};
    def.body_b = *body;
    if (!copy.create_joint(def).ok()) return {};
    return bytes_of(copy);
}

Result<JointDef> joint_of_record(std::string_view bytes) {
    const Result<World> world = world_of(bytes);
    if (!world.ok()) return world.error();
    const std::vector<JointId> joints = world->joints();
    if (joints.size() != 1) return corrupt_record("joint");
    return world->joint(joints.front())->def;
}

}  // namespace jostle::server
