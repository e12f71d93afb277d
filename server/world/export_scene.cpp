// SPDX-License-Identifier: MIT
#include "server/world/export_scene.h"

#include <algorithm>
#include <map>
#include <optional>

#include "jostle/physics/module.h"
#include "jostle/physics/vec3.h"

namespace jostle::server {

using namespace physics;
using scenes::SceneBody;
using scenes::SceneDescription;

namespace {

// `said`: what a body does not tell of itself, such as its damping.
SceneBody body_now(const World& world, BodyId id, SceneBody said) {
    const BodyState state = *world.body(id);
    said.body.type = state.type;
    said.body.pose = state.pose;
    // A body is made without shapes, and the velocities of its points stay as it gets them: what is
    // said of its velocity is that of its origin.
    said.body.linear_velocity =
        state.linear_velocity + cross(state.angular_velocity, state.pose.position - state.center);
    said.body.angular_velocity = state.angular_velocity;
    said.body.sleep_allowed = state.sleep_allowed;
    said.body.locks = state.locks;
    said.body.user_data = state.user_data;
    said.shapes.clear();
    for (const ShapeId shape : world.shapes_of(id))
        said.shapes.push_back(def_of(*world.shape(shape)));
    return said;
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
        scene.world = origin_.world;
        scene.world.gravity = world_.gravity();
        scene.world.joint_solver = world_.joint_solver();
        add_scene_bodies();
        add_spawned_bodies();
        add_joints();
        for (const scenes::SceneModule& module : origin_.modules) add_module(module);
        say("bodies of modules", made_by_modules_, "they are made anew with them");
        say("joints that are not the scene's", world_.joints().size() - out_.scene.joints.size(),
            "what clients hold is let go");
        say("modules", modules_begun_anew_, "bodies that they know changed: they begin anew");
        return std::move(out_);
    }

private:
    void add_scene_bodies() {
        new_index_.resize(ids_.bodies.size());
        for (std::size_t i = 0; i < ids_.bodies.size(); i++) {
            if (!world_.contains(ids_.bodies[i])) continue;
            new_index_[i] = out_.scene.bodies.size();
            out_.scene.bodies.push_back(body_now(world_, ids_.bodies[i], origin_.bodies[i]));
        }
    }

    void add_spawned_bodies() {
        std::vector<BodyId> known = ids_.bodies;
        std::ranges::sort(known);
        for (const auto& [id, entity] : state_.entities.all()) {
            if (std::ranges::binary_search(known, entity.body)) continue;
            if (entity.description->owner == 0) {
                made_by_modules_++;
                continue;
            }
            out_.scene.bodies.push_back(body_now(world_, entity.body,
                                                 {.name = entity.description->name,
                                                  .body = {},
                                                  .shapes = {},
                                                  .color = entity.description->color}));
        }
    }

    void add_joints() {
        for (std::size_t i = 0; i < ids_.joints.size(); i++) {
            if (!world_.contains(ids_.joints[i])) continue;
            scenes::SceneJoint joint = origin_.joints[i];
            const JointDef now = world_.joint(ids_.joints[i])->def;
            joint.joint.kind = now.kind;
            joint.joint.solver = now.solver;
            // A joint goes with its bodies: those of one that is there are there.
            if (joint.body_a != scenes::world_body) joint.body_a = *new_index_[joint.body_a];
            joint.body_b = *new_index_[joint.body_b];
            out_.scene.joints.push_back(std::move(joint));
        }
    }

    // Ids in a module's state are those of this world: the same again only where all that the scene
    // made is still there and nothing stands before it.
    bool ids_are_preserved() const {
        return made_by_modules_ == 0 && out_.scene.joints.size() == origin_.joints.size() &&
               std::ranges::all_of(new_index_, [](const auto& index) { return index.has_value(); });
    }

    void add_module(scenes::SceneModule module) {
        Module* const running = world_.module(module.tag);
        if (!running) return;
        for (auto& [name, body] : module.bodies) {
            if (!new_index_[body]) return say("modules", 1, "the body \"" + name + "\" is gone");
            body = *new_index_[body];
        }
        module.state.clear();
        if (ids_are_preserved())
            module.state = save_module(*running);
        else
            modules_begun_anew_++;
        out_.scene.modules.push_back(std::move(module));
    }

    void say(const std::string& what, std::size_t count, const std::string& why) {
        if (count > 0) out_.omitted.push_back(std::to_string(count) + " " + what + ": " + why);
    }

    HostedState& state_;
    World& world_;
    const SceneDescription& origin_;
    const SceneIds& ids_;
    ExportedScene out_;
    std::vector<std::optional<std::size_t>> new_index_;  // of each body of the scene; none: gone
    std::size_t made_by_modules_ = 0, modules_begun_anew_ = 0;
};

}  // namespace

ExportedScene export_scene(HostedState& state, const SceneDescription& origin,
                           const SceneIds& ids) {
    return Exporter(state, origin, ids).run();
}

}  // namespace jostle::server
