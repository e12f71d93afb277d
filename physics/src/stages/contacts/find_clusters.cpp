// SPDX-License-Identifier: MIT
#include "physics/src/stages/contacts/find_clusters.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/continuous/ccd_policy.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/pair_properties.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

constexpr std::uint32_t no_cluster = 0xffffffff;

// With two bodies the order of impacts is unambiguous.
constexpr int min_cluster_size = 3;

bool is_member(const BodyCold& cold) {
    return cold.type == BodyType::dynamic && cold.set == BodySet::awake && !cold.asleep_in_place;
}

// The root of the cluster that a cluster was merged into.
std::uint32_t cluster_root(std::vector<BodyCluster>& clusters, std::uint32_t cluster) {
    while (clusters[cluster].cluster_parent != cluster) {
        clusters[cluster].cluster_parent =
            clusters[clusters[cluster].cluster_parent].cluster_parent;
        cluster = clusters[cluster].cluster_parent;
    }
    return cluster;
}

// A body that has contacts and is pressed against them is held by them.
std::uint32_t cluster_with(ContactScratch& scratch, const BodyCold& cold, bool pressed) {
    std::uint32_t& cluster = scratch.cluster_of[cold.at];
    if (cluster == no_cluster) {
        cluster = static_cast<std::uint32_t>(scratch.clusters.size());
        scratch.clusters.push_back({.cluster_parent = cluster,
                                    .bodies = 1,
                                    .held = pressed && scratch.had_contacts[cold.at] != 0});
    }
    return cluster_root(scratch.clusters, cluster);
}

// `closing`: m/s. The second body may be the one that holds the first.
void merge_clusters(ContactScratch& scratch, const BodyCold& a, const BodyCold& b, double closing,
                    bool pressed, bool level) {
    if (!is_member(a))
        return is_member(b) ? merge_clusters(scratch, b, a, closing, pressed, level) : void();
    std::uint32_t cluster = cluster_with(scratch, a, pressed);
    if (is_member(b)) {
        std::uint32_t other = cluster_with(scratch, b, pressed);
        scratch.cluster_edges.push_back({a.at, b.at});
        if (other < cluster) std::swap(cluster, other);
        if (other != cluster) {
            BodyCluster &into = scratch.clusters[cluster], &absorbed = scratch.clusters[other];
            absorbed.cluster_parent = cluster;
            into.bodies += absorbed.bodies;
            into.held |= absorbed.held;
            into.level &= absorbed.level;
            into.fastest = maximum(into.fastest, absorbed.fastest);
        }
    } else {
        scratch.clusters[cluster].held = true;
    }
    scratch.clusters[cluster].fastest = maximum(scratch.clusters[cluster].fastest, closing);
    scratch.clusters[cluster].level &= level;
}

// Returns whether a shape that cannot move freely is within `length` of a body's centre; if its
// impacts are level, in a level direction: the table below a rack of balls does not hold them.
bool is_wall_near(const ContactGraph& stores, std::uint32_t shape, Vec3 center, double length,
                  bool level) {
    const ShapeRecord& s = stores.shapes.shapes[shape];
    Vec3 reach{length, length, length};
    if (level && stores.def.gravity != Vec3{}) {
        const Vec3 up = normalized(stores.def.gravity);
        for (int k = 0; k < 3; k++) reach[k] *= square_root(maximum(0, 1 - up[k] * up[k]));
    }
    const Aabb near{center - reach, center + reach};
    return is_plane(s) ? reaches_plane(stores, s, near) : overlap(near, s.fat);
}

// Bodies near enough to be struck within the step join the cluster, in whatever direction they
// move.
void merge_neighbours(const StepContext& step, ContactScratch& scratch, bool pressed) {
    const WorldState& world = step.world;
    struct Member {
        std::uint32_t awake;
        double displacement;  // m: displacement of the fastest body of its cluster in the step
        bool level;
    };
    std::vector<Member>
        members;  // fixed before bodies are added, so that the order does not matter
    for (std::uint32_t awake = 0; awake < scratch.cluster_of.size(); awake++)
        if (scratch.cluster_of[awake] != no_cluster) {
            const BodyCluster& cluster =
                scratch.clusters[cluster_root(scratch.clusters, scratch.cluster_of[awake])];
            members.push_back({awake, cluster.fastest * step.dt, cluster.level});
        }
    for (const Member& member : members) {
        const BodyWarm& warm = world.bodies.awake[member.awake];
        const BodyCold& cold = world.bodies.cold[warm.body];
        for_each_contact(world.contacts, cold, [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            if (c.parent != none) return;
            const bool is_a = c.body_a == warm.body;
            const std::uint32_t other = is_a ? c.body_b : c.body_a;
            const BodyCold& cold_other = world.bodies.cold[other];
            const double reach =
                (cold.inner_radius + cold_other.inner_radius) + member.displacement;
            const bool near =
                is_member(cold_other)
                    ? length_squared(warm_of(world, other).center - warm.center) < reach * reach
                    : !c.composite &&
                          is_wall_near(world, is_a ? c.shape_b : c.shape_a, warm.center,
                                       cold.inner_radius + member.displacement, member.level);
            if (near)
                merge_clusters(scratch, cold, cold_other, 0, pressed && !member.level,
                               member.level);
        });
    }
}

// Length of the rows of clusters: from the first body of a cluster to the one furthest in the
// neighbour graph, and from that to the one furthest from it. A rack of fifteen balls yields five,
// not fifteen.
class Rows {
public:
    explicit Rows(const ContactScratch& scratch)
        : first_(scratch.cluster_of.size() + 1, 0), steps_(scratch.cluster_of.size(), unvisited) {
        for (const auto& [a, b] : scratch.cluster_edges) first_[a]++, first_[b]++;
        std::uint32_t sum = 0;
        for (std::uint32_t& end : first_) end = sum += end;
        neighbours_.resize(sum);
        for (const auto& [a, b] : scratch.cluster_edges)
            neighbours_[--first_[a]] = b, neighbours_[--first_[b]] = a;
    }

    int longest_from(std::uint32_t body) {
        static_cast<void>(traverse_from(body));
        body = furthest();
        const int most = traverse_from(body);
        for (const std::uint32_t k : visited_) steps_[k] = unvisited;
        return most + 1;
    }

private:
    static constexpr int unvisited = -1;

    // Distance to the furthest body, in edges.
    int traverse_from(std::uint32_t body) {
        for (const std::uint32_t k : visited_) steps_[k] = unvisited;
        visited_.assign(1, body);
        steps_[body] = 0;
        for (std::size_t k = 0; k < visited_.size(); k++)
            for (std::uint32_t n = first_[visited_[k]]; n < first_[visited_[k] + 1]; n++) {
                if (steps_[neighbours_[n]] != unvisited) continue;
                steps_[neighbours_[n]] = steps_[visited_[k]] + 1;
                visited_.push_back(neighbours_[n]);
            }
        return steps_[visited_.back()];
    }
    // The lowest index among equally distant bodies, so that the traversal order does not matter.
    std::uint32_t furthest() const {
        std::uint32_t best = visited_.back();
        for (const std::uint32_t k : visited_)
            if (steps_[k] == steps_[visited_.back()]) best = std::min(best, k);
        return best;
    }

    std::vector<std::uint32_t> first_;  // by awake body: start of its range in neighbours_
    std::vector<std::uint32_t> neighbours_;
    std::vector<int> steps_;              // by awake body, in the traversal
    std::vector<std::uint32_t> visited_;  // in traversal order
};

// Returns whether two bodies meet across the direction of gravity.
bool is_level(const NarrowPhaseTask& task, Vec3 gravity) {
    const Vec3 direction{double{task.direction[0]}, double{task.direction[1]},
                         double{task.direction[2]}};
    constexpr double most = 0.1;  // cosine
    return direction != Vec3{} &&
           absolute(dot(direction, gravity)) < most * length(direction) * length(gravity);
}

// The fraction of energy that each impact must retain so that, after `impacts` impacts with the
// energy spread over `bodies` bodies, each body's energy falls from that of `speed` to that of
// `noise`. Computed as a root by bisection.
double retained_energy_fraction(double speed, double noise, int impacts, int bodies) {
    const double left = noise * noise * bodies / maximum(speed * speed, 1e-30);
    if (!(left < 1)) return 1;
    double low = 0, high = 1;
    for (int k = 0; k < 30; k++) {
        const double middle = 0.5 * (low + high);
        double power = 1, square = middle;
        for (int n = impacts; n > 0; n /= 2) {
            if (n % 2 == 1) power *= square;
            square *= square;
        }
        (power < left ? low : high) = middle;
    }
    return low;
}

// The fraction of energy that an impact retains. With sticking friction a ball loses 2/7 of its
// tangential energy, on average over all directions a seventh of its total energy. With slipping
// friction the loss is mu (1 + e) times the mean product of normal and tangential speed, which is
// 0.4 times the squared speed, doubled.
double retained_energy(const Material& a, const Material& b) {
    const double e = pair_restitution(a, b);
    return e * e * (1 - minimum(1.0 / 7, 0.8 * pair_friction(a, b) * (1 + e)));
}

}  // namespace

void find_clusters(StepContext& step) {
    const WorldState& world = step.world;
    ContactScratch& scratch = step.scratch.contacts;
    scratch.clusters.clear();
    scratch.cluster_of.clear();
    scratch.cluster_edges.clear();
    if (std::none_of(scratch.tasks.begin(), scratch.tasks.end(),
                     [](const NarrowPhaseTask& task) { return task.bounces; }))
        return;
    scratch.cluster_of.assign(world.bodies.awake.size(), no_cluster);
    const double falls = 2 * length(world.def.gravity) * step.dt;  // m/s
    for (const NarrowPhaseTask& task : scratch.tasks) {
        if (!task.bounces) continue;
        const Contact& c = world.contacts.contacts[task.contact];
        const bool level = falls > 0 && is_level(task, world.def.gravity);
        merge_clusters(scratch, world.bodies.cold[c.body_a], world.bodies.cold[c.body_b],
                       task.closing, falls > 0 && !level, level);
    }
    merge_neighbours(step, scratch, falls > 0);
    for (std::uint32_t& cluster : scratch.cluster_of)
        if (cluster != no_cluster) cluster = cluster_root(scratch.clusters, cluster);
    Rows rows(scratch);
    for (std::uint32_t awake = 0; awake < scratch.cluster_of.size(); awake++) {
        if (scratch.cluster_of[awake] == no_cluster) continue;
        BodyCluster& cluster = scratch.clusters[scratch.cluster_of[awake]];
        if (!cluster.held || cluster.bodies < min_cluster_size || cluster.row > 0) continue;
        cluster.row = rows.longest_from(awake);
        if (cluster.row < min_cluster_size) continue;
        cluster.min_retained_energy = retained_energy_fraction(
            cluster.fastest, maximum(bounce_speed(world.def.gravity, step.dt), falls),
            2 * cluster.row, cluster.bodies);
    }
}

bool bounces_in_cluster(const ShapedBodies& stores, const ContactScratch& scratch,
                        std::uint32_t shape_a, std::uint32_t shape_b) {
    if (scratch.clusters.empty()) return false;
    const ShapeRecord &a = stores.shapes.shapes[shape_a], &b = stores.shapes.shapes[shape_b];
    const auto min_retained_energy = [&](const ShapeRecord& shape) {
        const BodyCold& cold = stores.bodies.cold[shape.body];
        if (!is_member(cold) || cold.at >= scratch.cluster_of.size()) return 0.0;
        const std::uint32_t cluster = scratch.cluster_of[cold.at];
        return cluster == no_cluster ? 0.0 : scratch.clusters[cluster].min_retained_energy;
    };
    const double least = maximum(min_retained_energy(a), min_retained_energy(b));
    return least > 0 && retained_energy(a.material, b.material) < least;
}

bool bounces_alone(const StepContext& step, std::uint32_t shape_a, std::uint32_t shape_b) {
    const ContactScratch& scratch = step.scratch.contacts;
    return !scratch.bouncing.empty() && bounces(step.world, shape_a, shape_b) &&
           !bounces_in_cluster(step.world, scratch, shape_a, shape_b);
}

}  // namespace jostle::physics
