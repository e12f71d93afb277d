// SPDX-License-Identifier: MIT
#include "tools/sim/inspect.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace jostle::sim {
namespace {

using analysis::Method;
using physics::BodyId;
using physics::ConstraintRow;
using physics::ConstraintSystem;
using physics::Error;
using physics::ErrorCode;
using physics::Result;

// Names of the objects of a scene; bodies created by modules have no names there.
struct Names {
    std::map<BodyId, std::string> bodies;
    std::map<physics::JointId, std::string> joints;

    Names(const scenes::SceneDescription& scene, const scenes::BuiltScene& built) {
        std::map<std::string, int> uses;
        for (const scenes::SceneBody& body : scene.bodies) uses[body.name]++;
        for (const scenes::SceneJoint& joint : scene.joints) uses[joint.name]++;
        // Appends the index in the scene if the name alone is ambiguous.
        const auto name_or_index = [&](const std::string& name, const std::string& other,
                                       std::size_t k) {
            if (name.empty()) return other + " " + std::to_string(k);
            return uses[name] > 1 ? name + " (" + std::to_string(k) + ")" : name;
        };
        for (std::size_t k = 0; k < scene.bodies.size(); k++)
            bodies[built.bodies[k]] = name_or_index(scene.bodies[k].name, "body", k);
        for (std::size_t k = 0; k < scene.joints.size(); k++)
            joints[built.joints[k]] =
                name_or_index(scene.joints[k].name, kind_name(scene.joints[k].joint.kind), k);
    }
    std::string of(BodyId id) const {
        const auto found = bodies.find(id);
        return found != bodies.end() ? found->second : "body #" + std::to_string(id.index);
    }
    std::string of(const ConstraintRow& row, const ConstraintSystem& system) const {
        std::string name;
        if (!is_null(row.joint)) {
            const auto found = joints.find(row.joint);
            name =
                found != joints.end() ? found->second : "joint #" + std::to_string(row.joint.index);
        } else {
            const auto body = [&](int part) {
                return of(system.bodies[static_cast<std::size_t>(row.jacobians[part].body)].id);
            };
            name = body(0) + "/" + body(1);
        }
        return name + " " + name_of(row);
    }
};

Result<BodyId> find_body(const std::string& text, const scenes::SceneDescription& scene,
                         const scenes::BuiltScene& built) {
    for (std::size_t k = 0; k < scene.bodies.size(); k++)
        if (!text.empty() && scene.bodies[k].name == text) return built.bodies[k];
    std::size_t index = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, index);
    if (read.ec == std::errc{} && read.ptr == end && index < scene.bodies.size())
        return built.bodies[index];
    return Error{ErrorCode::not_found, "--inspect: the scene has no body '" + text +
                                           "'; must be a body's name, a number " + "from 0 to " +
                                           std::to_string(scene.bodies.size() - 1) + ", or all"};
}

InspectedGroup group_of(ConstraintSystem system, const Names& names, const InspectOptions& options,
                        bool full_report) {
    InspectedGroup group{.system = std::move(system)};
    for (const physics::SystemBody& body : group.system.bodies)
        if (body.moves) group.bodies.push_back(names.of(body.id));
    group.problem = analysis::problem_of(group.system);
    for (std::size_t k = 0; k < group.problem.count; k++)
        group.problem.names[k] = names.of(group.system.rows[k], group.system);
    group.analysis = analysis::analyse(group.problem);
    if (full_report) {
        group.solutions = analysis::solve_all(group.problem, options.limits);
        group.preconditioning =
            analysis::evaluate_preconditioning(group.problem, group.analysis, options.limits);
    } else {
        group.solutions = {
            analysis::solve(group.problem, Method::projected_gauss_seidel, options.limits)};
    }
    return group;
}

// Inspects all groups, in the order of their first bodies in the scene.
std::vector<InspectedGroup> all_groups(const scenes::BuiltScene& built, const Names& names,
                                       const InspectOptions& options) {
    struct Refused {
        BodyId body;
        std::string reason;
    };
    std::vector<ConstraintSystem> systems;
    std::vector<Refused> refused;
    std::map<BodyId, bool> seen;
    const auto visit_island = [&](BodyId body) {
        for (const std::vector<BodyId>& island : built.world.islands())
            if (std::find(island.begin(), island.end(), body) != island.end())
                for (const BodyId other : island) seen[other] = true;
    };
    for (const BodyId body : built.world.bodies()) {
        if (seen[body] || built.world.body(body)->type != physics::BodyType::dynamic) continue;
        auto system = built.world.constraint_system(body, options.rows);
        if (system.ok()) {
            for (const physics::SystemBody& member : system->bodies) seen[member.id] = true;
            systems.push_back(std::move(*system));
        } else if (system.error().code != ErrorCode::failed_precondition) {
            refused.push_back({body, system.error().message});
            visit_island(body);
        }
    }
    std::vector<InspectedGroup> groups;
    const bool full_report = systems.size() == 1 && refused.empty();
    for (ConstraintSystem& system : systems)
        groups.push_back(group_of(std::move(system), names, options, full_report));
    for (const Refused& group : refused)
        groups.push_back({.bodies = {names.of(group.body)}, .unavailable_reason = group.reason});
    return groups;
}

}  // namespace

int InspectedGroup::motions() const {
    int count = 0;
    for (const physics::SystemBody& body : system.bodies) {
        count += (body.inverse_mass.x > 0) + (body.inverse_mass.y > 0) + (body.inverse_mass.z > 0);
        const physics::Mat3& spin = body.inverse_inertia;
        count += (spin.x.x > 0) + (spin.y.y > 0) + (spin.z.z > 0);
    }
    return count;
}

std::optional<int> InspectedGroup::free_motions() const {
    if (problem.has_bounds()) return {};
    for (const ConstraintRow& row : system.rows)
        if (row.softness > 0) return {};
    return motions() - static_cast<int>(analysis.rank);
}

const analysis::Solution* InspectedGroup::best() const {
    const Method reference_method =
        problem.has_bounds() ? Method::projected_gauss_seidel : Method::minimum_norm;
    for (const analysis::Solution& solution : solutions)
        if (solution.method == reference_method && solution.failed.empty()) return &solution;
    return solutions.empty() ? nullptr : &solutions.front();
}

Result<Inspection> inspect(const scenes::SceneDescription& scene, const scenes::BuiltScene& built,
                           const InspectOptions& options) {
    Inspection found{
        .scene = scene.name, .step = built.world.step_count(), .time = built.world.time()};
    const Names names(scene, built);
    if (options.body == "all") {
        found.groups = all_groups(built, names, options);
        return found;
    }
    const auto body = find_body(options.body, scene, built);
    if (!body.ok()) return body.error();
    auto system = built.world.constraint_system(*body, options.rows);
    if (!system.ok())
        return Error{system.error().code, names.of(*body) + ": " + system.error().message};
    found.groups.push_back(group_of(std::move(*system), names, options, true));
    return found;
}

}  // namespace jostle::sim
