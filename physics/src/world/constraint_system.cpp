// SPDX-License-Identifier: MIT
//
// Builds the constraint rows of a connected group of bodies and their linear system.
#include "jostle/physics/constraint_system.h"

#include <algorithm>

#include "jostle/physics/world.h"
#include "physics/src/constraints/contact_settings.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/constraints/joints/joint_rows.h"
#include "physics/src/constraints/joints/write_joint.h"
#include "physics/src/constraints/softness.h"
#include "physics/src/constraints/system_matrix.h"
#include "physics/src/foundation/messages.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/contact_modifiers.h"
#include "physics/src/state/force_fields.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/world/body_change.h"
#include "physics/src/world/checks.h"
#include "physics/src/world/contact_view.h"

namespace jostle::physics {
namespace {

Status check_options(const ConstraintSystemOptions& options) {
    if (options.h != 0)
        if (Status s = check_range("h", options.h, 1e-6, 0.25); !s.ok()) return s;
    return check_range("position_correction", options.position_correction, 0, 1);
}

// Bodies connected to `body` by joints and touching contacts through dynamic bodies, sorted by
// index.
std::vector<std::uint32_t> constrained_group(const WorldState& world, std::uint32_t body) {
    std::vector<std::uint32_t> found = {body};
    std::vector<bool> seen(world.bodies.cold.size());
    seen[body] = true;
    const auto visit = [&](std::uint32_t other) {
        if (!is_dynamic(world.bodies, other) || seen[other]) return;
        seen[other] = true;
        found.push_back(other);
    };
    for (std::size_t k = 0; k < found.size(); k++) {
        const BodyCold& cold = world.bodies.cold[found[k]];
        for_each_joint(world.joints, cold, [&](std::uint32_t index) {
            const Joint& joint = world.joints.joints[index];
            visit(joint.body_a);
            visit(joint.body_b);
            if (!joint_is_geared(joint.kind)) return;
            visit(find_carrier(world.bodies, world.joints, joint, 0));
            visit(find_carrier(world.bodies, world.joints, joint, 1));
        });
        for_each_contact(world.contacts, cold, [&](std::uint32_t index) {
            const Contact& contact = world.contacts.contacts[index];
            if (!contact.touching) return;
            visit(contact.body_a);
            visit(contact.body_b);
        });
    }
    std::sort(found.begin(), found.end());
    return found;
}

JointEnd end_now(const BodySets& sets, std::uint32_t body, const Transform& frame) {
    if (body == none) return {.arm = frame.position, .frame = frame.rotation};
    const BodyWarm& warm = warm_of(sets, body);
    return {.center = warm.center,
            .arm = warm.axes * (frame.position - sets.bodies.cold[body].local_center),
            .rotation = warm.rotation,
            .frame = warm.rotation * frame.rotation};
}

Carrier carrier_now(const BodySets& sets, std::uint32_t body) {
    if (body == none) return {};
    const BodyWarm& warm = warm_of(sets, body);
    return {.body = body,
            .center = warm.center,
            .origin = pose_of(warm, sets.bodies.cold[body]).position,
            .rotation = warm.rotation};
}

SystemBody system_body(const WorldState& world, std::uint32_t index,
                       const ConstraintSystemOptions& options, double h) {
    const BodyCold& cold = world.bodies.cold[index];
    const BodyWarm& warm = warm_of(world, index);
    SystemBody body{.id = body_id(world.bodies, index),
                    .moves = cold.type == BodyType::dynamic,
                    .inverse_inertia = diagonal({0, 0, 0})};
    if (cold.type != BodyType::static_body) {
        body.linear_velocity = body.free_linear_velocity = warm.v;
        body.angular_velocity = body.free_angular_velocity = warm.w;
    }
    if (!body.moves) return body;
    body.inverse_mass = free_directions(cold) * cold.inverse_mass;
    body.inverse_inertia = world_inverse_inertia(warm, cold);
    if (!options.forces) return body;
    FieldPush push;
    if (!world.fields.empty()) push = field_push(world, warm, cold, world.time, h);
    const Vec3 acceleration =
        acceleration_of(warm, cold, world.def.gravity) + scaled(push.force, body.inverse_mass);
    const Vec3 momentum =
        // Angular momentum, world.
        warm.axes * (cold.inertia * transposed_times(warm.axes, warm.w));
    const Vec3 torque = warm.torque + push.torque - cross(warm.w, momentum);
    body.free_linear_velocity = warm.v * damping_factor(cold.linear_damping, h) + acceleration * h;
    body.free_angular_velocity =
        warm.w * damping_factor(cold.angular_damping, h) + body.inverse_inertia * torque * h;
    return body;
}

// Collects rows and the bodies they refer to, in order of first reference.
struct ConstraintSystemBuilder {
    const WorldState& world;
    const ConstraintSystemOptions& options;
    double h;
    ConstraintSystem system = {};
    std::vector<std::uint32_t> bodies = {};    // by number
    std::vector<std::int32_t> number_of = {};  // by index; -1: no number yet

    int first_block = 0;  // of the next joint

    int number(std::uint32_t index) {
        std::int32_t& number = number_of[index];
        if (number < 0) {
            number = static_cast<std::int32_t>(bodies.size());
            bodies.push_back(index);
            system.bodies.push_back(system_body(world, index, options, h));
        }
        return number;
    }
    bool full() const { return system.rows.size() > std::size_t{constraint_rows_max}; }

    // A one-sided row must use its remaining distance within h, otherwise it does not act.
    double bias_of(double error, bool one_sided, double share) const {
        return one_sided && error > 0 ? -error / h : -share * error / h;
    }
    bool acts(const ConstraintRow& row, double left) const {
        return left <= 0 || left + h * rate_by_forces(row, system.bodies) < 0;
    }
    static void soften(ConstraintRow& row, const Softness& s, double response) {
        row.softness = response * s.impulse_scale / s.velocity_scale;
        row.bias = -row.error * s.position_rate / s.velocity_scale;
    }

    void add_joint(std::uint32_t index) {
        const Joint& joint = world.joints.joints[index];
        int last = first_block;
        Carrier carriers[2];
        if (joint_is_geared(joint.kind))
            for (int end = 0; end < 2; end++)
                carriers[end] =
                    carrier_now(world, find_carrier(world.bodies, world.joints, joint, end));
        for (const JointRow& from :
             joint_rows(joint, end_now(world, joint.body_a, joint.frame_a),
                        end_now(world, joint.body_b, joint.frame_b), carriers)) {
            add_joint_row(index, from);
            last = from.block < 0 ? last : first_block + from.block;
        }
        first_block = last + 1;
    }

    void add_joint_row(std::uint32_t index, const JointRow& from) {
        ConstraintRow row{.role = from.role,
                          .axis = from.axis,
                          .joint = joint_id(world.joints, index),
                          .jacobians = {}};
        for (int p = 0; p < from.jacobian_count; p++)
            if (from.jacobians[p].body != none)
                row.jacobians[row.jacobian_count++] = {number(from.jacobians[p].body),
                                                       from.jacobians[p].linear,
                                                       from.jacobians[p].angular};
        const double response = response_of(row, system.bodies);
        if (!(response > 0)) return;
        if (from.one_sided && !acts(row, from.error)) return;
        row.lower = from.one_sided ? 0 : from.lower * h;
        row.upper = from.upper * h;
        row.error = from.error;
        row.rate = rate_now(row, system.bodies);
        if (from.block >= 0) row.block = first_block + from.block;
        row.bias = from.holds() ? bias_of(from.error, from.one_sided, options.position_correction)
                                : from.speed;
        row.softness = from.compliance / h;
        if (from.spring.hertz > 0)
            soften(row, soft(from.spring.hertz, from.spring.damping_ratio, h), response);
        else if (from.damper > 0)
            soften(row, damper(from.damper, h), response);
        else if (options.solver_softness && from.rigid() && from.holds() &&
                 !(from.one_sided && from.error > 0))
            soften(row, soft(tuning::joint_stiffness / h, tuning::joint_damping_ratio, h),
                   response);
        system.rows.push_back(row);
    }

    void add_contact(const ContactView& view, const ContactSettings& settings) {
        const Contact& contact = world.contacts.contacts[view.contact];
        const ContactInfo& info = view.info;
        const ContactModifier result = modifier_of(world, contact);
        const Vec3 n = info.normal;
        const Vec3 t1 =
            world.def.planar
                ? Vec3{-n.y, n.x, 0}
                : normalized(cross(n, absolute(n.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
        const Vec3 tangents[] = {t1, cross(n, t1)};
        const int a = number(contact.body_a), b = number(contact.body_b);
        const Vec3 center_a = warm_of(world, contact.body_a).center,
                   center_b = warm_of(world, contact.body_b).center;
        for (int k = 0; k < info.count; k++) {
            const Vec3 arm_a = info.point[k] - center_a, arm_b = info.point[k] - center_b;
            const auto row_along = [&](RowRole role, int axis, Vec3 direction) {
                ConstraintRow row{.role = role,
                                  .axis = axis,
                                  .shape_a = info.shape_a,
                                  .shape_b = info.shape_b,
                                  .point = k,
                                  .jacobians = {{a, -direction, -cross(arm_a, direction)},
                                                {b, direction, cross(arm_b, direction)}},
                                  .jacobian_count = 2};
                row.rate = rate_now(row, system.bodies);
                return row;
            };
            ConstraintRow normal = row_along(RowRole::normal, -1, n);
            const double response = response_of(normal, system.bodies);
            normal.error = info.gap[k];
            if (!(response > 0) || !acts(normal, info.gap[k] - tuning::contact_slop)) continue;
            normal.upper = 1e300;
            const double beyond = minimum(info.gap[k] + tuning::contact_slop, 0);
            normal.bias =
                info.gap[k] > 0 ? -info.gap[k] / h : -options.position_correction * beyond / h;
            if (options.solver_softness && info.gap[k] <= 0) {
                const double retained = double{settings.mass_scale};
                normal.softness = response * double{settings.impulse_scale} / retained;
                normal.bias = -double{settings.bias_rate} * beyond;
            }
            const int normal_row = static_cast<int>(system.rows.size());
            system.rows.push_back(normal);
            for (int t = 0; t < 2; t++) {
                if (result.friction == 0) continue;
                ConstraintRow row = row_along(RowRole::tangent, t, tangents[t]);
                if (!(response_of(row, system.bodies) > 0)) continue;
                row.bias = -dot(result.surface_velocity, tangents[t]);
                row.friction = result.friction;
                row.normal_row = normal_row;
                row.upper = result.friction * info.impulse[k];
                row.lower = -row.upper;
                system.rows.push_back(row);
            }
        }
    }

    // Sorts bodies by id. Rows refer to them in order of first reference until then.
    void sort_bodies() {
        std::vector<std::uint32_t> order = bodies;
        std::sort(order.begin(), order.end());
        std::vector<SystemBody> sorted;
        std::vector<int> lane_ref(bodies.size());
        for (const std::uint32_t index : order) {
            const auto number = static_cast<std::size_t>(number_of[index]);
            lane_ref[number] = static_cast<int>(sorted.size());
            sorted.push_back(system.bodies[number]);
        }
        for (ConstraintRow& row : system.rows)
            for (int p = 0; p < row.jacobian_count; p++)
                row.jacobians[p].body = lane_ref[static_cast<std::size_t>(row.jacobians[p].body)];
        system.bodies = std::move(sorted);
    }
};

std::vector<std::uint32_t> joints_on(const BodyStore& store, const JointStore& joints,
                                     const std::vector<std::uint32_t>& bodies) {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t body : bodies)
        for_each_joint(joints, store.cold[body],
                       [&](std::uint32_t joint) { found.push_back(joint); });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

// Lists each contact once: body a of a contact is dynamic.
std::vector<ContactView> contacts_between(const ContactGraph& stores,
                                          const std::vector<std::uint32_t>& bodies) {
    std::vector<ContactView> contacts;
    for (const std::uint32_t body : bodies) {
        for (const ContactView& view : contacts_on(stores, body))
            if (view.info.touching && stores.contacts.contacts[view.contact].body_a == body)
                contacts.push_back(view);
        if (contacts.size() > std::size_t{constraint_rows_max}) break;
    }
    std::sort(contacts.begin(), contacts.end(), [&](const ContactView& x, const ContactView& y) {
        const auto key = [&](const ContactView& view) {
            return std::tuple(view.info.shape_a, view.info.shape_b,
                              stores.contacts.contacts[view.contact].key, view.contact);
        };
        return key(x) < key(y);
    });
    return contacts;
}

Result<ConstraintSystem> system_of(const WorldState& world, std::uint32_t body,
                                   const ConstraintSystemOptions& options) {
    const Island& island = world.islands.islands[world.bodies.cold[body].island];
    const double dt = expected_dt(world);
    const ContactSettings settings =
        contact_settings(dt, substeps_of(island.colour_set, world), island.colour_set.tier);
    const double h = options.h != 0 ? options.h : dt / settings.substeps;
    ConstraintSystemBuilder all{world, options, h};
    all.number_of.assign(world.bodies.cold.size(), -1);
    const std::vector<std::uint32_t> bodies = constrained_group(world, body);
    const auto too_many = [&] {
        return Error{ErrorCode::resource_exhausted,
                     "the group of body {" + std::to_string(body) + ", " +
                         std::to_string(body_id(world.bodies, body).generation) + "} has " +
                         std::to_string(bodies.size()) + " bodies with more than " +
                         std::to_string(constraint_rows_max) + " rows; use a smaller group"};
    };
    for (const std::uint32_t joint : joints_on(world.bodies, world.joints, bodies)) {
        all.add_joint(joint);
        if (all.full()) return too_many();
    }
    const ContactSettings at_h =
        contact_settings(h * settings.substeps, settings.substeps, island.colour_set.tier,
                         {stiffness_dt_of(world, h * settings.substeps), settings.substeps});
    for (const ContactView& contact : contacts_between(world, bodies)) {
        all.add_contact(contact, at_h);
        if (all.full()) return too_many();
    }
    if (all.system.rows.empty())
        return Error{
            ErrorCode::failed_precondition,
            "body {" + std::to_string(body) + ", " +
                std::to_string(body_id(world.bodies, body).generation) +
                "} has no constraint rows: it touches nothing and none of its joints acts"};
    all.sort_bodies();
    all.system.h = h;
    assemble(all.system);
    return std::move(all.system);
}

}  // namespace

Result<ConstraintSystem> World::constraint_system(BodyId body,
                                                  const ConstraintSystemOptions& options) const {
    const WorldState& world = *state_;
    if (Status s = check_options(options); !s.ok()) return s.error();
    if (Status s = check_id(world.bodies, body); !s.ok()) return s.error();
    if (!is_dynamic(world.bodies, body.index))
        return Error{ErrorCode::failed_precondition,
                     "body {" + std::to_string(body.index) + ", " +
                         std::to_string(body.generation) +
                         "} is not dynamic; constraints are solved for dynamic bodies only"};
    return system_of(world, body.index, options);
}

Result<ConstraintSystem> World::constraint_system(JointId joint,
                                                  const ConstraintSystemOptions& options) const {
    const WorldState& world = *state_;
    if (Status s = check_options(options); !s.ok()) return s.error();
    if (Status s = check_id(world.joints, joint); !s.ok()) return s.error();
    const Joint& named = world.joints.joints[joint.index];
    return system_of(world, is_dynamic(world.bodies, named.body_b) ? named.body_b : named.body_a,
                     options);
}

}  // namespace jostle::physics
