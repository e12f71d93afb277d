// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/find_impacts.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/seams.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/contacts/find_clusters.h"
#include "physics/src/stages/continuous/swept_shapes.h"
#include "physics/src/stages/continuous/toi_motion.h"
#include "physics/src/stages/continuous/toi_policy.h"

namespace jostle::physics {

namespace {

// The approach that makes a touch an impact. The path of a gyroscopic body may approach although
// its velocities do not. Such an impact has no impulse, but a new sweep starts from there.
// The contact solver pushes overlapping bodies apart: their path separates although their velocity
// may approach. Forces may press two dynamic bodies through each other and turn their velocity
// round within the step. If they do not, overlapping bodies fly on, and the contact solver pushes
// them apart: if each step stopped them at its start, they would stay in the air.
enum class ApproachTest : std::uint8_t {
    by_velocity_or_path,
    by_velocity,
    by_path,
    by_velocity_and_path,
    by_velocity_and_path_or_forces,
    at_bouncing_speed
};

// A shape of the TOI body and the other shape on their paths.
struct SweptPair {
    std::uint32_t own;
    SweptShape a, b;
    double from;  // the fraction of the step from which on both paths exist
    bool bounces;
    bool held;  // the contact solver has resolved the impact
};

class ShapeSweep {
public:
    ShapeSweep(const ToiState& state, ToiBody& t, std::uint32_t other, bool far)
        : state_(state),
          t_(t),
          other_(other),
          other_body_(state.world.shapes.shapes[other].body),
          path_(sweep_of(state, other_body_)),
          gap_(sweep_gap_of(state.world.bodies.cold[t.body], state.world.bodies.cold[other_body_])),
          far_(far),
          deflected_(is_deflected(state, t, state.index_of(other_body_))) {}

    void run() {
        for_each_shape_near(state_.world, t_, swept_shape(state_.world, other_, path_), gap_,
                            [&](std::uint32_t own) { sweep(own); });
    }

private:
    void sweep(std::uint32_t own) {
        if (!may_hit(state_, own, other_)) return;
        const bool bouncy = bounces_alone(state_.step, own, other_);
        // The contact solver resolves pairs with a manifold that move little, unless an impact has
        // deflected one of the bodies since.
        if (!far_ && (!bouncy || (!deflected_ && has_manifold(state_.world, t_, own, other_))))
            return;
        const SweptPair pair{
            .own = own,
            .a = swept_shape(state_.world, own, t_.sweep),
            .b = swept_shape(state_.world, other_, path_),
            .from = std::max(t_.sweep.from, path_.from),
            .bounces = bouncy,
            .held = !deflected_ && solver_has_resolved(state_.step, t_, own, other_)};
        if (touches_without_impact(pair) && far_) sweep_cores(pair);
    }

    // Finds the impact of the whole shapes. Returns whether they touch without one.
    bool touches_without_impact(const SweptPair& pair) {
        const Impact hit = pair.held ? Impact{.at_start = true}
                                     : time_of_impact(pair.a, pair.b, pair.from, gap_, t_.fraction);
        bool touches = hit.at_start;
        if (hit.fraction < t_.fraction)
            touches |=
                !record(pair, hit.fraction, points_at(pair, hit.fraction),
                        far_ ? ApproachTest::by_velocity_or_path : ApproachTest::by_velocity);
        // Shapes that touch at the start of the sweep and bounce do so immediately.
        if (hit.at_start && pair.bounces && !pair.held &&
            continues_impact_chain(state_, t_, pair.own, other_)) {
            const std::vector<ImpactPoint> points = points_at(pair, pair.from);
            if ((points.size() == 1 || !deflected_) &&
                record(pair, pair.from, points, ApproachTest::at_bouncing_speed))
                touches = false;
        }
        return touches;
    }

    // Touching shapes that do not approach are left to the contact solver, or were resolved just
    // before. But one end of a body may rest while the other end comes down, or the bodies may
    // still approach after the solver or an impact. Then scaled-down copies of the thinner body's
    // shape stop at the distance that the whole shape lacks. Of shapes held by contacts, only
    // copies small enough to pass through are swept: a limb that is stopped here leaves its joints.
    void sweep_cores(const SweptPair& pair) {
        const BodyStore& bodies = state_.world.bodies;
        const BodyCold &cold = bodies.cold[t_.body], &cold_other = bodies.cold[other_body_];
        const bool other_is_thinner =
            cold_other.type == BodyType::dynamic && cold_other.inner_radius < cold.inner_radius;
        SweptShape core_a = pair.a, core_b = pair.b;
        for (const double scale : tuning::swept_cores) {
            if (pair.held && scale > tuning::held_core) continue;
            (other_is_thinner ? core_b : core_a).scale = scale;
            const Impact hit = time_of_impact(core_a, core_b, pair.from, gap_, t_.fraction);
            bool touches = hit.at_start;
            if (hit.fraction < t_.fraction)
                touches |= !record(pair, hit.fraction, points_along(pair.a, pair.b, hit),
                                   ApproachTest::by_velocity_or_path);
            if (!touches) return;
        }
        // All copies overlap from the start. A body that forces pull through the other one within
        // the step stays where it is.
        const double thin = other_is_thinner ? cold_other.inner_radius : cold.inner_radius;
        const bool passes =
            length(t_.sweep.translation - path_.translation) * (1 - pair.from) > thin;
        record(pair, pair.from, points_at(pair, pair.from),
               !passes                                ? ApproachTest::by_velocity_and_path
               : cold_other.type == BodyType::dynamic ? ApproachTest::by_velocity_and_path_or_forces
                                                      : ApproachTest::by_path);
    }

    std::vector<ImpactPoint> points_at(const SweptPair& pair, double fraction) const {
        return points_touching(pair.a, pair.b, fraction, 5 * gap_);
    }

    // The shapes that may form one floor with the other shape, where they are at that fraction: its
    // body's, and if it is not dynamic, those of other such bodies.
    std::vector<TransformedShape> floor_at(double fraction) const {
        const WorldState& world = state_.world;
        const auto gives_way = [&](std::uint32_t body) {
            return world.bodies.cold[body].type == BodyType::dynamic;
        };
        std::vector<TransformedShape> shapes;
        for (const std::uint32_t shape : t_.candidates) {
            const std::uint32_t body = world.shapes.shapes[shape].body;
            if (shape == other_ ||
                (body != other_body_ && (gives_way(body) || gives_way(other_body_))))
                continue;
            const SweptShape swept = swept_shape(world, shape, sweep_of(state_, body));
            if (fraction >= swept.sweep.from)
                shapes.push_back(transformed_shape_at(swept, fraction));
        }
        return shapes;
    }

    // A shape that slides from one piece of a floor onto the next one does not hit its side. Drops
    // such points: the piece that covers them is swept on its own.
    void drop_covered_points(const SweptPair& pair, double fraction,
                             std::vector<ImpactPoint>& points) const {
        const std::vector<TransformedShape> floor = floor_at(fraction);
        if (floor.empty()) return;
        const TransformedShape own = transformed_shape_at(pair.a, fraction),
                               other = transformed_shape_at(pair.b, fraction);
        const double margin = tuning::touch_gap / tuning::sweep_gap * gap_;
        std::erase_if(points, [&](const ImpactPoint& p) {
            return is_covered(other, own, p.position, -p.normal, floor, margin);
        });
    }

    // Records an impact, unless an earlier or harder one is known. Returns false if the shapes do
    // not approach at that time.
    bool record(const SweptPair& pair, double fraction, std::vector<ImpactPoint> points,
                ApproachTest approach) {
        if (fraction > t_.fraction) return true;
        drop_covered_points(pair, fraction, points);
        const std::optional<double> closing = closing_speed(points, fraction, approach);
        if (!closing) return false;
        if (fraction == t_.fraction && *closing <= t_.closing) return true;
        ASSERT(fraction >= pair.from && fraction <= 1);
        t_.fraction = fraction;
        t_.closing = *closing;
        t_.at_start = fraction == pair.from;
        t_.own_shape = pair.own;
        t_.other_shape = other_;
        t_.points = points;
        return true;
    }

    // The highest closing speed of the points at a fraction of the step, m/s. Empty if they do not
    // approach.
    std::optional<double> closing_speed(const std::vector<ImpactPoint>& points, double fraction,
                                        ApproachTest approach) const {
        const Vec3 center_a = center_at(t_.sweep, fraction), center_b = center_at(path_, fraction);
        const Speed speed_a = speed_of(state_, t_.body, fraction),
                    speed_b = speed_of(state_, other_body_, fraction);
        const double least = approach == ApproachTest::at_bouncing_speed
                                 ? tuning::touching_impact_speed
                                 : 1e-3;  // m/s
        bool closes = false;
        double most = 0;
        for (const ImpactPoint& p : points) {
            const Vec3 ra = p.position - center_a, rb = p.position - center_b;
            const Vec3 u = (speed_b.v + cross(speed_b.w, rb)) - (speed_a.v + cross(speed_a.w, ra));
            const Vec3 displacement = (path_.translation + cross(path_.rotation_vector, rb)) -
                                      (t_.sweep.translation + cross(t_.sweep.rotation_vector, ra));
            most = maximum(most, -dot(u, p.normal));
            const double centers = dot(path_.translation - t_.sweep.translation, p.normal);
            const bool by_velocity = dot(u, p.normal) < -least,
                       by_path = dot(displacement, p.normal) < -least * state_.step.dt;
            switch (approach) {
                case ApproachTest::by_velocity_or_path:
                    closes |= by_velocity || by_path;
                    break;
                case ApproachTest::by_velocity:
                case ApproachTest::at_bouncing_speed:
                    closes |= by_velocity;
                    break;
                case ApproachTest::by_path:
                    closes |= centers < -least * state_.step.dt;
                    break;
                case ApproachTest::by_velocity_and_path_or_forces:
                    closes |= centers < -least * state_.step.dt &&
                              dot(speed_b.v - speed_a.v, p.normal) > 0;
                    [[fallthrough]];
                case ApproachTest::by_velocity_and_path:
                    closes |= by_velocity && centers < 0;
                    break;
            }
        }
        if (!closes) return std::nullopt;
        return most;
    }

    const ToiState& state_;
    ToiBody& t_;
    const std::uint32_t other_, other_body_;
    const Sweep path_;      // of the other body
    const double gap_;      // m
    const bool far_;        // the relative motion needs a sweep
    const bool deflected_;  // an impact of this step has deflected one of the bodies
};

}  // namespace

void sweep_against(const ToiState& state, ToiBody& t, std::uint32_t shape) {
    const std::uint32_t body = state.world.shapes.shapes[shape].body;
    if (spheres_miss(state, t, body)) return;
    const bool far = needs_sweep(state, t, body);
    if (far || state.any_bounces) ShapeSweep(state, t, shape, far).run();
}

namespace {

// Returns whether the TOI body of another body sweeps this pair in the same round, which suffices.
bool is_swept_by_other(const ToiState& state, std::size_t index, std::uint32_t other_body) {
    const std::uint32_t known = state.index_of(other_body);
    if (known == none || known >= index ||
        state.bodies[known].full_search_round != state.search_round)
        return false;
    const WorldState& world = state.world;
    const std::vector<std::uint32_t>& candidates = state.bodies[known].candidates;
    for (std::uint32_t s = world.bodies.cold[state.bodies[index].body].first_shape; s != none;
         s = world.shapes.shapes[s].next)
        if (!world.shapes.shapes[s].trigger &&
            !std::binary_search(candidates.begin(), candidates.end(), s))
            return false;
    return searches(state, known);
}

// Finds the first impact on the remaining path.
void search_path(const ToiState& state, std::size_t index, ToiBody& t) {
    t.fraction = Impact::never;
    if (!searches(state, index)) return;
    for (const std::uint32_t shape : t.candidates)
        if (!is_swept_by_other(state, index, state.world.shapes.shapes[shape].body))
            sweep_against(state, t, shape);
}

// Tests whether bodies that were deflected since the last search are hit before the known impact.
void search_deflected(const ToiState& state, ToiBody& t) {
    const WorldState& world = state.world;
    for (const std::uint32_t body : t.deflected_bodies)
        for (std::uint32_t s = world.bodies.cold[body].first_shape; s != none;
             s = world.shapes.shapes[s].next)
            sweep_against(state, t, s);
}

void find_impact(ToiState& state, std::size_t index) {
    ToiBody& t = state.bodies[index];
    ASSERT(t.fast && t.queued);
    if (t.checked)
        search_deflected(state, t);
    else
        search_path(state, index, t);
    t.checked = true;
    t.queued = false;
    t.deflected_bodies.clear();
}

}  // namespace

void find_impacts(ToiState& state, ImpactQueue& queue) {
    state.search_round++;
    const std::vector<std::size_t>& to_search = state.to_search;
    int sweeps = 0;
    for (const std::size_t k : to_search) {
        ToiBody& t = state.bodies[k];
        if (!t.checked) t.full_search_round = state.search_round;
        sweeps += static_cast<int>(t.checked ? t.deflected_bodies.size() : t.candidates.size());
    }
    state.world.profile.sweeps += sweeps;
    if (state.world.profile.impacts > 0) state.world.profile.sweeps_after_impacts += sweeps;
    state.step.thread_pool.run(static_cast<int>(to_search.size()), 1, [&](int begin, int end) {
        for (int k = begin; k < end; k++)
            find_impact(state, to_search[static_cast<std::size_t>(k)]);
    });
    for (const std::size_t k : to_search) queue.update(state, k);
    state.to_search.clear();
}

}  // namespace jostle::physics
