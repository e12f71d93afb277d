// SPDX-License-Identifier: MIT
#include "server/world/scene_budget.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/scenes/geometry_message_bytes.h"
#include "server/util/clock.h"

namespace jostle::server {

using namespace physics;

namespace {

Error too_much(std::string message) {
    return {ErrorCode::resource_exhausted, std::move(message)};
}

Status check_geometry_size(const scenes::SceneDescription& scene, const SceneBudget& budget) {
    double bytes = 0;
    std::set<const void*> processed;
    for (std::size_t i = 0; i < scene.bodies.size(); i++) {
        double own = 0;
        for (const ShapeDef& shape : scene.bodies[i].shapes) {
            const auto size = static_cast<double>(scenes::geometry_message_bytes(shape.geometry));
            const bool shared = size > scenes::inline_geometry_bytes_max;
            if (!shared) own += size;
            if (shared && !processed.insert(scenes::shared_data(shape.geometry)).second) continue;
            bytes += size;
            if (bytes > budget.geometry_bytes_max)
                return too_much(
                    fmt::format("the geometry of the scene needs more than {:.0f} bytes in "
                                "messages to each client; scene.geometry_bytes_max allows {:.0f}",
                                budget.geometry_bytes_max, budget.geometry_bytes_max));
        }
        if (own > budget.body_geometry_bytes_max)
            return too_much(
                fmt::format("bodies[{}] \"{}\" has {:.0f} bytes of shapes; "
                            "scene.body_geometry_bytes_max allows {}; merge them into one mesh or "
                            "compound",
                            i, scene.bodies[i].name, own, budget.body_geometry_bytes_max));
    }
    return {};
}

Status check_joints(const scenes::SceneDescription& scene, const SceneBudget& budget) {
    if (scene.joints.size() > static_cast<std::size_t>(budget.joints_max))
        return too_much(fmt::format("the scene has {} joints; scene.joints_max allows {}",
                                    scene.joints.size(), budget.joints_max));
    std::map<std::pair<std::size_t, std::size_t>, int> of_pair;
    for (const scenes::SceneJoint& joint : scene.joints)
        if (++of_pair[std::minmax(joint.body_a, joint.body_b)] > budget.joints_per_pair_max)
            return too_much(
                fmt::format("joint \"{}\": more than {} joints connect the same two bodies; "
                            "scene.joints_per_pair_max allows {}",
                            joint.name, budget.joints_per_pair_max, budget.joints_per_pair_max));
    return {};
}

struct BoxedShape {
    Aabb box;
    Filter filter;
    std::uint32_t body = 0;
    bool moves = false;
};

std::vector<BoxedShape> boxed_shapes(const World& world, std::size_t& unbounded) {
    std::vector<BodyState> bodies;
    world.copy_bodies(bodies);
    std::vector<BoxedShape> boxed;
    for (const BodyState& body : bodies)
        for (const ShapeId id : world.shapes_of(body.id)) {
            const ShapeState shape = *world.shape(id);
            const auto box = world.bounds(id);
            if (box.ok())
                boxed.push_back(
                    {*box, shape.filter, body.id.index, body.type == BodyType::dynamic});
            else
                unbounded++;  // a plane
        }
    return boxed;
}

// Sorts along x and sweeps; stops soon after `max` pairs.
std::size_t count_pairs(const World& world, std::size_t max) {
    std::size_t planes = 0;
    std::vector<BoxedShape> boxed = boxed_shapes(world, planes);
    std::ranges::sort(boxed, {}, [](const BoxedShape& s) { return s.box.low.x; });
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < boxed.size(); i++) {
        if (boxed[i].moves) pairs += planes;
        for (std::size_t k = i + 1; k < boxed.size(); k++) {
            if (boxed[k].box.low.x > boxed[i].box.high.x) break;
            if ((boxed[i].moves || boxed[k].moves) && boxed[i].body != boxed[k].body &&
                overlap(boxed[i].box, boxed[k].box) &&
                may_collide(boxed[i].filter, boxed[k].filter))
                pairs++;
        }
        if (pairs > max) break;
    }
    return pairs;
}

}  // namespace

Status check_description(const scenes::SceneDescription& scene, const SceneBudget& budget) {
    if (scene.bodies.size() > static_cast<std::size_t>(budget.bodies_max))
        return too_much(fmt::format("the scene has {} bodies; world.bodies_max allows {}",
                                    scene.bodies.size(), budget.bodies_max));
    if (Status s = check_joints(scene, budget); !s.ok()) return s;
    return check_geometry_size(scene, budget);
}

Result<double> estimate_work(const scenes::SceneDescription& scene, const World& world,
                             const SceneBudget& budget) {
    ASSERT(scene.hz > 0);
    const double passes = scene.hz * scene.world.substeps;
    std::size_t constant = scene.joints.size();  // work per pass that does not depend on pairs
    for (const scenes::SceneBody& body : scene.bodies)
        if (body.body.type == BodyType::dynamic) constant++;
    const double pairs_max = budget.work_per_second_max / passes - static_cast<double>(constant);
    const std::size_t pairs =
        pairs_max > 0 ? count_pairs(world, static_cast<std::size_t>(pairs_max)) : 0;
    if (static_cast<double>(pairs) <= pairs_max)
        return passes * static_cast<double>(constant + pairs);
    return too_much(fmt::format(
        "the work of {:g} Hz x {} sub-steps x ({} moving bodies and joints + {}{} overlapping "
        "pairs) per second is too high; scene.work_per_second_max allows {:g}",
        scene.hz, scene.world.substeps, constant, pairs > 0 ? "at least " : "", pairs,
        budget.work_per_second_max));
}

Status check_first_step(const scenes::SceneDescription& scene, World world,
                        const SceneBudget& budget) {
    std::mutex mutex;
    std::condition_variable done;
    bool stepped = false;
    std::thread timer([&] {
        std::unique_lock lock(mutex);
        if (!done.wait_for(lock, from_seconds(budget.first_step_seconds_max),
                           [&] { return stepped; }))
            world.stop_stepping();
    });
    const Status step = world.step(1 / scene.hz);
    {
        const std::lock_guard lock(mutex);
        stepped = true;
    }
    done.notify_all();
    timer.join();
    if (step.ok() || step.error().code != ErrorCode::aborted) return {};
    return too_much(fmt::format(
        "the first step of the scene takes longer than {:g} s; scene.first_step_seconds_max allows "
        "{:g} s",
        budget.first_step_seconds_max, budget.first_step_seconds_max));
}

}  // namespace jostle::server
