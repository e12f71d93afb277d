// SPDX-License-Identifier: MIT
#include "server/world/export_scene.h"

#include <algorithm>
#include <map>
#include <optional>

#include "jostle/base/check.h"
#include "jostle/modules/island_coupling.h"
#include "jostle/physics/module.h"
#include "jostle/physics/vec3.h"

namespace jostle::server {

using namespace physics;
using scenes::SceneBody;
using scenes::SceneDescription;

namespace {

// `scene_body` holds the properties that BodyState lacks, such as damping.
SceneBody export_body(const World& world, BodyId id, SceneBody scene_body) {
    const BodyState state = *world.body(id);
    scene_body.body.type = state.type;
    scene_body.body.pose = state.pose;
    // A definition holds the velocity of the origin, because the body is created without shapes and
    // gets its centre of mass later.
    scene_body.body.linear_velocity =
        state.linear_velocity + cross(state.angular_velocity, state.pose.position - state.center);
    scene_body.body.angular_velocity = state.angular_velocity;
    scene_body.body.sleep_allowed = state.sleep_allowed;
    scene_body.body.locks = state.locks;
    scene_body.body.user_data = state.user_data;
    scene_body.shapes.clear();
    for (const ShapeId shape : world.shapes_of(id))
        scene_body.shapes.push_back(def_of(*world.shape(shape)));
    return scene_body;
}

class Exporter {
public:
    Exporter(HostedState& state, const SceneDescription& origin, const SceneIds& ids)
        : state_(state), world_(state.world), origin_(origin), ids_(ids) {}

    ExportedScene run() {
        SceneDescription& scene = out_.scene;
        scene.name = origin_.name;
        scene.description = origin_.description;
        scene.hz = origin_.hz;
        scene.precision = origin_.precision;
        scene.view = origin_.view;
        scene.room = origin_.room;
        scene.world = origin_.world;
        scene.world.gravity = world_.gravity();
        scene.world.joint_solver = world_.joint_solver();
        add_scene_bodies();
        add_spawned_bodies();
        add_joints();
        for (const scenes::SceneModule& module : origin_.modules) add_module(module);
        report_omitted("module bodies", module_bodies_, "their modules create them again");
        report_omitted("joints", count_grabs(), "they are grabs of clients");
        report_omitted("module states", reset_modules_,
                       "bodies that they refer to changed, so the modules start from their initial "
                       "state");
        return std::move(out_);
    }

private:
    void add_scene_bodies() {
        new_index_.resize(ids_.bodies.size());
        for (std::size_t i = 0; i < ids_.bodies.size(); i++) {
            if (!world_.contains(ids_.bodies[i])) continue;
            new_index_[i] = out_.scene.bodies.size();
            add_body(ids_.bodies[i], origin_.bodies[i]);
        }
    }

    void add_spawned_bodies() {
        std::vector<BodyId> known = ids_.bodies;
        std::ranges::sort(known);
        for (const auto& [id, entity] : state_.entities.all()) {
            if (std::ranges::binary_search(known, entity.body)) continue;
            if (entity.description->owner == 0) {
                module_bodies_++;
                continue;
            }
            add_body(entity.body, {.name = entity.description->name,
                                   .body = {},
                                   .shapes = {},
                                   .color = entity.description->color});
        }
        ASSERT(out_.bodies.size() == out_.scene.bodies.size());
    }

    void add_body(BodyId id, const SceneBody& scene_body) {
        out_.scene.bodies.push_back(export_body(world_, id, scene_body));
        out_.bodies.push_back(id);
    }

    void add_joints() {
        for (std::size_t i = 0; i < ids_.joints.size(); i++) {
            if (!world_.contains(ids_.joints[i])) continue;
            scenes::SceneJoint joint = origin_.joints[i];
            const JointDef now = world_.joint(ids_.joints[i])->def;
            joint.joint.kind = now.kind;
            joint.joint.solver = now.solver;
            // The bodies of an existing joint exist.
            ASSERT(new_index_[joint.body_b]);
            if (joint.body_a != scenes::world_body) joint.body_a = *new_index_[joint.body_a];
            joint.body_b = *new_index_[joint.body_b];
            out_.scene.joints.push_back(std::move(joint));
        }
    }

    // All other joints are those of the scene and couplings that modules create again.
    std::size_t count_grabs() const {
        const auto joints = world_.joints();
        const auto couplings = std::ranges::count_if(joints, [&](JointId id) {
            return modules::is_island_coupling(world_.joint(id)->def.kind) &&
                   std::ranges::find(ids_.joints, id) == ids_.joints.end();
        });
        return joints.size() - out_.scene.joints.size() - static_cast<std::size_t>(couplings);
    }

    // A module's state refers to bodies and joints by id. The exported scene yields the same ids
    // only if every body and joint of the original scene still exists and no module created bodies.
    bool ids_are_preserved() const {
        return module_bodies_ == 0 && out_.scene.joints.size() == origin_.joints.size() &&
               std::ranges::all_of(new_index_, [](const auto& index) { return index.has_value(); });
    }

    void add_module(scenes::SceneModule module) {
        Module* const running = world_.module(module.tag);
        if (!running) return;
        for (auto& [name, body] : module.bodies) {
            if (!new_index_[body])
                return report_omitted("modules", 1, "body \"" + name + "\" no longer exists");
            body = *new_index_[body];
        }
        module.state.clear();
        if (ids_are_preserved())
            module.state = save_module(*running);
        else
            reset_modules_++;
        out_.scene.modules.push_back(std::move(module));
    }

    void report_omitted(const std::string& noun, std::size_t count, const std::string& reason) {
        if (count > 0) out_.omitted.push_back(std::to_string(count) + " " + noun + ": " + reason);
    }

    HostedState& state_;
    World& world_;
    const SceneDescription& origin_;
    const SceneIds& ids_;
    ExportedScene out_;
    std::vector<std::optional<std::size_t>> new_index_;  // per body of the scene; nothing: removed
    std::size_t module_bodies_ = 0, reset_modules_ = 0;
};

}  // namespace

ExportedScene export_scene(HostedState& state, const SceneDescription& origin,
                           const SceneIds& ids) {
    return Exporter(state, origin, ids).run();
}

}  // namespace jostle::server
