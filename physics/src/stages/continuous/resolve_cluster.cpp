// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/resolve_cluster.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "jostle/base/check.h"
#include "physics/src/constraints/impact_cluster.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/contacts/call_contact_listeners.h"
#include "physics/src/stages/contacts/find_clusters.h"
#include "physics/src/stages/continuous/toi_motion.h"
#include "physics/src/stages/continuous/toi_policy.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/pair_properties.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

// Larger clusters are resolved in parts.
constexpr std::size_t max_bodies = 64;
constexpr int max_rounds = 200;

// Two touching shapes, of which the first belongs to `body`.
struct Neighbour {
    std::uint32_t own = none, other = none;  // shapes
    std::vector<ImpactPoint> points;         // normals from the first to the second
};

class ClusterImpact {
public:
    ClusterImpact(ToiState& state, ToiBody& t)
        : state_(state),
          t_(t),
          at_(t.fraction),
          bounce_speed_(bounce_speed(state.world.def.gravity, state.step.dt)) {}

    std::optional<ResolvedCluster> run() {
        const WorldState& world = state_.world;
        const std::uint32_t other_body = world.shapes.shapes[t_.other_shape].body;
        // Where slower impacts end, the order of impacts is not visible.
        const ShapeRecord &own = world.shapes.shapes[t_.own_shape],
                          &other = world.shapes.shapes[t_.other_shape];
        if (!(pair_restitution(own.material, other.material) * t_.closing > bounce_speed_) ||
            !(may_branch(t_.body) || may_branch(other_body)) ||
            !bounces_alone(state_.step, t_.own_shape, t_.other_shape))
            return std::nullopt;
        DeflectedBody a = body_at_impact(state_, t_.body, at_),
                      b = body_at_impact(state_, other_body, at_);
        std::vector<Neighbour> first;
        // In a row, where each body has one further neighbour, the order of impacts is unambiguous.
        bool branches = false;
        for (const std::uint32_t body : {t_.body, other_body}) {
            const std::size_t before = first.size();
            for (Neighbour& n : neighbours_of(body))
                if (body_of(n.other) != t_.body && body_of(n.other) != other_body)
                    first.push_back(std::move(n));
            branches |= first.size() > before + 1;
        }
        if (!branches) return std::nullopt;
        std::vector<ImpactPoint> points = t_.points;
        const ContactModifier modifier =
            modifier_at_impact(world, t_.own_shape, t_.other_shape, a.after, b.after, points);
        if (!modifier.enabled || !(modifier.restitution > 0)) return std::nullopt;
        if (!t_.at_start)
            put_on_parabolas(a.after, fall_of(state_, t_.body), b.after,
                             fall_of(state_, other_body), points, at_, state_.step.dt);
        enter(a);
        enter(b);
        shapes_.push_back({t_.own_shape, t_.other_shape});
        cluster_.add_pair({0, 1, std::move(points), modifier.restitution, modifier.friction, {}});
        for (Neighbour& n : first) offer(std::move(n));
        resolve();
        return result();
    }

private:
    std::uint32_t body_of(std::uint32_t shape) const {
        return state_.world.shapes.shapes[shape].body;
    }

    // The shapes that touch a body at the time of the impact and bounce off it, in their order.
    std::vector<Neighbour> neighbours_of(std::uint32_t body) {
        std::vector<Neighbour> found;
        const WorldState& world = state_.world;
        const BodyCold& cold = world.bodies.cold[body];
        if (cold.type != BodyType::dynamic) return found;
        for_each_contact(world.contacts, cold, [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            if (c.parent != none) return;
            const bool is_a = c.body_a == body;
            const std::uint32_t own = is_a ? c.shape_a : c.shape_b,
                                other = is_a ? c.shape_b : c.shape_a;
            if (!is_near(body, other)) return;
            if (!bounces_alone(state_.step, own, other) || !may_hit(state_, own, other)) return;
            Neighbour n{own, other, touching_points(own, other)};
            if (!n.points.empty()) found.push_back(std::move(n));
        });
        std::sort(found.begin(), found.end(), [](const Neighbour& x, const Neighbour& y) {
            return std::pair(x.own, x.other) < std::pair(y.own, y.other);
        });
        return found;
    }

    // Returns whether the bounding spheres touch at the time of the impact, or the sphere of the
    // body and the box of a shape that does not move.
    bool is_near(std::uint32_t body, std::uint32_t other) const {
        const WorldState& world = state_.world;
        const std::uint32_t other_body = body_of(other);
        const BodyCold &cold = world.bodies.cold[body], &cold_other = world.bodies.cold[other_body];
        const double near = 2 * sweep_gap_of(cold, cold_other);
        const Vec3 center = center_at(sweep_of(state_, body), at_);
        if (cold_other.type != BodyType::dynamic) {
            const ShapeRecord& s = world.shapes.shapes[other];
            const Aabb box = grow({center, center}, cold.radius + near);
            return is_plane(s) ? reaches_plane(world, s, box) : overlap(box, s.fat);
        }
        const double reach = cold.radius + cold_other.radius + near;
        return length_squared(center - center_at(sweep_of(state_, other_body), at_)) <=
               reach * reach;
    }
    // Returns whether more than two bodies are near a body, so that it may touch two others.
    bool may_branch(std::uint32_t body) const {
        const BodyCold& cold = state_.world.bodies.cold[body];
        if (cold.type != BodyType::dynamic) return false;
        int count = 0;
        for_each_contact(state_.world.contacts, cold, [&](std::uint32_t contact) {
            const Contact& c = state_.world.contacts.contacts[contact];
            if (count > 2 || c.parent != none) return;
            count += is_near(body, c.body_a == body ? c.shape_b : c.shape_a) ? 1 : 0;
        });
        return count > 2;
    }

    std::vector<ImpactPoint> touching_points(std::uint32_t own, std::uint32_t other) {
        const WorldState& world = state_.world;
        const std::uint32_t body = body_of(own), other_body = body_of(other);
        const BodyCold &cold = world.bodies.cold[body], &cold_other = world.bodies.cold[other_body];
        const Sweep sweep = sweep_of(state_, body), sweep_other = sweep_of(state_, other_body);
        if (at_ < sweep.from || at_ < sweep_other.from) return {};
        const double near = 2 * sweep_gap_of(cold, cold_other);
        return points_touching(swept_shape(world, own, sweep),
                               swept_shape(world, other, sweep_other), at_, near);
    }

    std::uint32_t enter(const DeflectedBody& body) {
        ASSERT(index_of(body.body) == none);
        before_.push_back(body);
        expanded_.push_back(false);
        return cluster_.add_body(body.after);
    }
    std::uint32_t index_of(std::uint32_t body) const {
        for (std::uint32_t k = 0; k < before_.size(); k++)
            if (before_[k].body == body) return k;
        return none;
    }

    // Adds a touching pair, one of whose bodies is in the cluster, unless it is known.
    void offer(Neighbour n) {
        const auto same = [&](const std::pair<std::uint32_t, std::uint32_t>& shapes) {
            return shapes == std::pair(n.own, n.other) || shapes == std::pair(n.other, n.own);
        };
        if (std::any_of(shapes_.begin(), shapes_.end(), same)) return;
        std::uint32_t a = index_of(body_of(n.own)), b = index_of(body_of(n.other));
        ASSERT(a != none);
        if (b == none) {
            if (before_.size() >= max_bodies) return;
            b = enter(body_at_impact(state_, body_of(n.other), at_));
        }
        const ContactModifier modifier = modifier_at_impact(
            state_.world, n.own, n.other, cluster_.bodies()[a], cluster_.bodies()[b], n.points);
        if (!modifier.enabled) return;
        shapes_.push_back({n.own, n.other});
        cluster_.add_pair({a, b, std::move(n.points), modifier.restitution, modifier.friction, {}});
    }

    bool is_deflected_body(std::size_t k, double least) const {
        const ImpactBody &now = cluster_.bodies()[k], &before = before_[k].after;
        return length(now.v - before.v) > least ||
               length(now.w - before.w) * state_.world.bodies.cold[before_[k].body].radius > least;
    }

    // Adds what touches the bodies that the last round has deflected.
    void expand(double least) {
        const std::size_t count = before_.size();
        for (std::size_t k = 0; k < count; k++) {
            if (expanded_[k] || !is_deflected_body(k, least)) continue;
            expanded_[k] = true;
            for (Neighbour& n : neighbours_of(before_[k].body)) offer(std::move(n));
        }
    }

    void resolve() {
        const double first = cluster_.hardest();
        const double least = noise * first;
        for (int round = 0; round < max_rounds; round++) {
            if (!cluster_.reflect(least, bounce_speed_)) break;
            expand(reach_fraction * first);
            if (cluster_.hardest() <= bounce_speed_ * stop_fraction) break;
        }
        cluster_.stop();
        expand(reach_fraction * first);
        cluster_.stop();
    }

    ResolvedCluster result() {
        WorldState& world = state_.world;
        ResolvedCluster done{.impact = {.at = at_, .bounced = true, .a = {}, .b = {}},
                             .bodies = {}};
        for (std::size_t k = 0; k < before_.size(); k++) {
            if (!is_deflected_body(k, 0)) continue;
            DeflectedBody body = before_[k];
            body.after = cluster_.bodies()[k];
            done.bodies.push_back(body);
        }
        for (std::size_t k = 0; k < shapes_.size(); k++) {
            const HardestPoint& hit = cluster_.pairs()[k].hit;
            if (!(hit.normal_impulse > 0)) continue;
            world.profile.impacts++;
            report_impact(state_, shapes_[k].first, shapes_[k].second, hit, true);
        }
        for (const DeflectedBody& body : done.bodies) request_wake(world, t_.body, body.body);
        return done;
    }

    static constexpr double noise = 1e-9, reach_fraction = 1e-4, stop_fraction = 0.2;

    ToiState& state_;
    ToiBody& t_;
    const double at_, bounce_speed_;
    ImpactCluster cluster_;
    std::vector<DeflectedBody> before_;                            // by index in the cluster
    std::vector<bool> expanded_;                                   // likewise
    std::vector<std::pair<std::uint32_t, std::uint32_t>> shapes_;  // by pair of the cluster
};

}  // namespace

std::optional<ResolvedCluster> resolve_cluster(ToiState& state, std::size_t index) {
    ToiBody& t = state.bodies[index];
    std::optional<ResolvedCluster> cluster = ClusterImpact(state, t).run();
    if (!cluster) return std::nullopt;
    t.impacts++;
    request_search(state, index);
    return cluster;
}

}  // namespace jostle::physics
