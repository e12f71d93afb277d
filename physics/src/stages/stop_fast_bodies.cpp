// SPDX-License-Identifier: MIT
#include "stages/stop_fast_bodies.h"

#include <algorithm>
#include <unordered_map>

#include "collision/narrowphase/collide.h"
#include "collision/narrowphase/collide_composite.h"
#include "collision/narrowphase/time_of_impact.h"
#include "constraints/combine.h"
#include "constraints/free_motion.h"
#include "geometry/inner_radius.h"
#include "jostle/physics/tuning.h"
#include "state/links.h"

namespace jostle::physics {
namespace {

// One end of an impact, or one body under way.
struct Traveller {
    std::uint32_t body = none;
    Sweep sweep;
    // What forces add to the velocity over a whole step, and, while nothing acts but forces, the
    // angular momentum: how fast the body moves at a moment of its sweep follows from them.
    Vec3 velocity, gain;  // m/s at sweep.from, m/s over a step
    bool flies = false;   // no contact or joint acts on it
    Vec3 spin, momentum;  // rad/s; N m s while it flies
    Quat end_rotation;    // at the end of the step, when it is not met before
    Vec3 end_spin;
    bool fast = false;     // looks for impacts itself
    bool changed = false;  // its pose or velocity is no longer what the step made it
    int impacts = 0;
    // The first impact that is known, if any.
    bool looked = false;
    double fraction = 2;
    std::uint32_t own_shape = none, other_shape = none;
    std::vector<std::uint32_t> near;  // shapes that may be in the way
};

class Sweeper {
public:
    explicit Sweeper(StepContext& step) : step_(step), world_(step.world) {}

    void run() {
        for (std::uint32_t i = 0; i < world_.scratch.fast.size(); i++)
            if (world_.scratch.fast[i] != 0 && world_.scratch.not_finite[i] == 0) start(i);
        if (travellers_.empty()) return;
        world_.shapes.fixed->settle();
        world_.shapes.moving->settle();
        find_near_fast();
        const std::size_t fast = travellers_.size();
        for (std::size_t k = 0; k < fast; k++) find_near(k);
        // Every impact uses up one of somebody's, so this ends.
        for (;;) {
            std::size_t first = none;
            double soonest = 1.5;
            for (std::size_t k = 0; k < travellers_.size(); k++) {
                if (!travellers_[k].fast) continue;
                if (!travellers_[k].looked) look(k);
                if (travellers_[k].fraction < soonest) {
                    soonest = travellers_[k].fraction;
                    first = k;
                }
            }
            if (first == none) break;
            impact(first);
        }
        for (Traveller& t : travellers_)
            if (t.changed) arrive(t);
    }

private:
    std::size_t add(std::uint32_t body, const Sweep& sweep, bool fast) {
        where_.emplace(body, travellers_.size());
        Traveller t;
        t.body = body;
        t.sweep = sweep;
        t.fast = fast;
        travellers_.push_back(std::move(t));
        return travellers_.size() - 1;
    }

    void start(std::uint32_t awake) {
        const BodyWarm& now = world_.bodies.awake[awake];
        const BodyWarm& before = world_.scratch.before[awake];
        const Quat turn = now.rotation * conjugate(before.rotation);
        // The turn as a vector; a body that turns more than half round took the way of its spin.
        Vec3 vector = now.w * step_.dt;
        if (length(vector) < 1.5) {
            const Vec3 v{turn.x, turn.y, turn.z};
            const double l = length(v), sign = turn.w < 0 ? -1 : 1;
            vector = l > 1e-12 ? v * (sign * 2 * arc_tangent(l, turn.w * sign) / l) : Vec3{};
        }
        const BodyCold& cold = world_.bodies.cold[now.body];
        Traveller& t = travellers_[add(
            now.body, {0, before.center, before.rotation, now.center - before.center, vector},
            true)];
        t.end_rotation = now.rotation;
        t.end_spin = t.spin = now.w;
        t.velocity = now.v;
        t.flies = cold.type == BodyType::dynamic && cold.lanes == 0 && cold.first_joint == none;
        if (!t.flies) return;
        t.velocity = before.v;
        t.gain = now.v - before.v;
        t.momentum = before.axes * (cold.inertia * transposed_times(before.axes, before.w));
    }

    // The velocities of a body at a fraction of the step.
    struct Speed {
        Vec3 v, w;
    };
    Speed speed_at(std::uint32_t body, const Sweep& sweep, double fraction) const {
        const auto known = where_.find(body);
        if (known == where_.end()) {
            const BodyWarm& warm = warm_of(world_, body);
            return {warm.v, warm.w};
        }
        const Traveller& t = travellers_[known->second];
        Speed s{t.velocity + t.gain * (fraction - t.sweep.from), t.spin};
        const BodyCold& cold = world_.bodies.cold[body];
        if (t.flies && !cold.isotropic && cold.locks == 0) {
            const Mat3 axes = to_matrix(rotation_at(sweep, fraction));
            s.w = axes * (cold.inverse_inertia * transposed_times(axes, t.momentum));
        }
        return s;
    }

    // How a body that is not fast moves: back from where it is, by its velocity.
    Sweep sweep_of(std::uint32_t body) {
        const auto known = where_.find(body);
        if (known != where_.end()) return travellers_[known->second].sweep;
        const BodyCold& cold = world_.bodies.cold[body];
        const BodyWarm& warm = warm_of(world_, body);
        if (cold.set != BodySet::awake || (warm.v == Vec3{} && warm.w == Vec3{}))
            return {0, warm.center, warm.rotation, {}, {}};
        const Vec3 motion = warm.v * step_.dt, turn = warm.w * step_.dt;
        return {0, warm.center - motion, normalized(from_rotation_vector(-turn) * warm.rotation),
                motion, turn};
    }

    SweptShape swept(std::uint32_t shape, const Sweep& sweep) const {
        const ShapeRecord& s = world_.shapes.shapes[shape];
        return {&s.geometry, s.offset, s.axes, world_.bodies.cold[s.body].radius, sweep};
    }

    Aabb bounds_of_way(const Traveller& t) const {
        Aabb box{};
        bool first = true;
        for (std::uint32_t s = world_.bodies.cold[t.body].first_shape; s != none;
             s = world_.shapes.shapes[s].next) {
            if (world_.shapes.shapes[s].trigger) continue;
            const Aabb own = swept_bounds(swept(s, t.sweep), t.sweep.from);
            box = first ? own : unite(box, own);
            first = false;
        }
        return grow(box, 0.01);
    }

    bool may_hit(std::uint32_t own, std::uint32_t other) const {
        const ShapeRecord &a = world_.shapes.shapes[own], &b = world_.shapes.shapes[other];
        if (a.body == b.body || a.trigger || b.trigger || !may_meet(a.filter, b.filter))
            return false;
        const BodyType ta = world_.bodies.cold[a.body].type, tb = world_.bodies.cold[b.body].type;
        if (ta != BodyType::dynamic && tb != BodyType::dynamic) return false;
        return !joined_without_contact(world_, a.body, b.body);
    }

    // Two fast bodies may meet where neither is any more.
    void find_near_fast() {
        struct Way {
            Aabb box;
            std::size_t traveller;
        };
        std::vector<Way> ways;
        for (std::size_t k = 0; k < travellers_.size(); k++)
            ways.push_back({bounds_of_way(travellers_[k]), k});
        std::sort(ways.begin(), ways.end(), [](const Way& x, const Way& y) {
            return x.box.low.x < y.box.low.x ||
                   (x.box.low.x == y.box.low.x && x.traveller < y.traveller);
        });
        const auto add_shapes = [&](Traveller& to, std::uint32_t body) {
            for (std::uint32_t s = world_.bodies.cold[body].first_shape; s != none;
                 s = world_.shapes.shapes[s].next)
                to.near.push_back(s);
        };
        for (std::size_t i = 0; i < ways.size(); i++)
            for (std::size_t j = i + 1; j < ways.size() && ways[j].box.low.x <= ways[i].box.high.x;
                 j++) {
                if (!overlap(ways[i].box, ways[j].box)) continue;
                Traveller &x = travellers_[ways[i].traveller], &y = travellers_[ways[j].traveller];
                add_shapes(x, y.body);
                add_shapes(y, x.body);
            }
    }

    void find_near(std::size_t k) {
        Traveller& t = travellers_[k];
        const Aabb box = bounds_of_way(t);
        std::vector<std::uint32_t> found = std::move(t.near);
        // The first way only: after an impact a body goes elsewhere.
        world_.shapes.fixed->query(box, 0xffffffff, found);
        world_.shapes.moving->query(box, 0xffffffff, found);
        for (const std::uint32_t plane : world_.shapes.planes)
            if (reaches_plane(world_, world_.shapes.shapes[plane], box)) found.push_back(plane);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        std::erase_if(found, [&](std::uint32_t s) {
            return world_.shapes.shapes[s].body == t.body || world_.shapes.shapes[s].trigger;
        });
        t.near = std::move(found);
    }

    // The first impact on the way that is left.
    void look(std::size_t k) {
        Traveller& t = travellers_[k];
        t.looked = true;
        t.fraction = 2;
        if (t.impacts >= tuning::sweep_impacts) return;
        for (const std::uint32_t other : t.near) look_at(t, other);
    }

    // Whether one shape is met before all that are known.
    void look_at(Traveller& t, std::uint32_t other) {
        const Sweep motion = sweep_of(world_.shapes.shapes[other].body);
        for (std::uint32_t own = world_.bodies.cold[t.body].first_shape; own != none;
             own = world_.shapes.shapes[own].next) {
            if (!may_hit(own, other)) continue;
            const double from = std::max(t.sweep.from, motion.from);
            const auto hit =
                time_of_impact(swept(own, t.sweep), swept(other, motion), from, tuning::sweep_gap);
            if (!hit) continue;
            // What touches already is the contact solver's, or was resolved just now; but the
            // heart of the body stays on its side.
            const double fraction =
                hit->at_start ? core_impact(t, own, other, motion, from) : hit->fraction;
            if (fraction >= t.fraction) continue;
            if (!hit->at_start && !closes_in(own, other, t.sweep, motion, fraction)) continue;
            t.fraction = fraction;
            t.own_shape = own;
            t.other_shape = other;
        }
    }

    struct Point {
        Vec3 position, normal;
    };
    std::vector<Point> touching(std::uint32_t own, std::uint32_t other, const Sweep& a,
                                const Sweep& b, double fraction) const {
        const Placed pa = placed_at(swept(own, a), fraction),
                     pb = placed_at(swept(other, b), fraction);
        std::vector<PartManifold> parts;
        if (is_composite(kind_of(*pa.geometry)) || is_composite(kind_of(*pb.geometry))) {
            collide_composite(pa, pb, 5 * tuning::sweep_gap, parts);
        } else {
            PairCache cache;
            parts.push_back({0, collide(pa, pb, 5 * tuning::sweep_gap, cache)});
        }
        std::vector<Point> points;
        for (const PartManifold& part : parts)
            for (int k = 0; k < part.manifold.count; k++)
                points.push_back({part.manifold.point[k], part.manifold.normal});
        return points;
    }

    // When a ball inside the body first touches; 2: never.
    double core_impact(const Traveller& t, std::uint32_t own, std::uint32_t other,
                       const Sweep& motion, double from) const {
        const Geometry ball = Sphere{0.5 * inner_radius_of(world_.shapes.shapes[own].geometry)};
        SweptShape core = swept(own, t.sweep);
        core.geometry = &ball;
        core.radius = length(core.offset) + std::get<Sphere>(ball).radius;
        const auto hit = time_of_impact(core, swept(other, motion), from, tuning::sweep_gap);
        if (!hit) return 2;
        // There already: only if it goes on inwards.
        const Vec3 u = speed_at(world_.shapes.shapes[other].body, motion, hit->fraction).v -
                       speed_at(t.body, t.sweep, hit->fraction).v;
        for (const Point& p : touching(own, other, t.sweep, motion, hit->fraction))
            if (dot(u, p.normal) < 0) return hit->fraction;
        return 2;
    }

    // Whether the velocities there still bring them together.
    bool closes_in(std::uint32_t own, std::uint32_t other, const Sweep& a, const Sweep& b,
                   double fraction) const {
        const std::uint32_t body_a = world_.shapes.shapes[own].body,
                            body_b = world_.shapes.shapes[other].body;
        const Vec3 ca = center_at(a, fraction), cb = center_at(b, fraction);
        const Speed sa = speed_at(body_a, a, fraction), sb = speed_at(body_b, b, fraction);
        for (const Point& p : touching(own, other, a, b, fraction)) {
            const Vec3 u =
                (sb.v + cross(sb.w, p.position - cb)) - (sa.v + cross(sa.w, p.position - ca));
            if (dot(u, p.normal) < -1e-3) return true;
        }
        return false;
    }

    // Both bodies at the moment of the impact, with their masses as they stand there.
    struct End {
        std::uint32_t body;
        Vec3 center, inverse_mass, v, w;
        Mat3 inverse_inertia = diagonal({0, 0, 0});
    };
    End end_of(std::uint32_t body, const Sweep& sweep, double fraction) {
        const BodyCold& cold = world_.bodies.cold[body];
        BodyWarm there = warm_of(world_, body);
        there.rotation = rotation_at(sweep, fraction);
        there.axes = to_matrix(there.rotation);
        const Speed speed = speed_at(body, sweep, fraction);
        End e{body, center_at(sweep, fraction), {}, speed.v, speed.w};
        if (cold.inverse_mass == 0) return e;
        e.inverse_mass = free_directions(cold) * cold.inverse_mass;
        e.inverse_inertia = world_inverse_inertia(there, cold);
        return e;
    }

    void impact(std::size_t index) {
        const double at = travellers_[index].fraction;
        const std::uint32_t own = travellers_[index].own_shape,
                            other = travellers_[index].other_shape;
        const std::uint32_t body_a = travellers_[index].body,
                            body_b = world_.shapes.shapes[other].body;
        const Sweep sweep_a = travellers_[index].sweep, sweep_b = sweep_of(body_b);
        const std::vector<Point> points = touching(own, other, sweep_a, sweep_b, at);
        if (world_.bodies.cold[body_b].set == BodySet::sleeping) {
            wake_island(world_, world_.bodies.cold[body_b].island, world_.events.woke);
            world_.scratch.not_finite.resize(world_.bodies.awake.size(), 0);
        }
        End a = end_of(body_a, sweep_a, at), b = end_of(body_b, sweep_b, at);
        bounce(own, other, a, b, points);
        travellers_[index].impacts++;
        go_on(a, sweep_a, at);
        go_on(b, sweep_b, at);
        // Whoever might meet one of the two looks anew, at those two or, if it would have met one
        // of them next, at everything.
        const auto changed = [&](std::uint32_t shape) {
            const std::uint32_t body = world_.shapes.shapes[shape].body;
            return body == body_a || body == body_b;
        };
        for (Traveller& t : travellers_) {
            if (!t.looked) continue;
            if (t.body == body_a || t.body == body_b || (t.fraction < 2 && changed(t.other_shape)))
                t.looked = false;
            else if (t.impacts < tuning::sweep_impacts)
                for (const std::uint32_t s : t.near)
                    if (changed(s)) look_at(t, s);
        }
    }

    // Sequential impulses on the points: restitution against the approach, friction in a cone.
    void bounce(std::uint32_t own, std::uint32_t other, End& a, End& b,
                const std::vector<Point>& points) {
        const Material &ma = world_.shapes.shapes[own].material,
                       &mb = world_.shapes.shapes[other].material;
        const double e = pair_restitution(ma, mb), mu = pair_friction(ma, mb);
        const auto relative = [&](const Point& p) {
            return (b.v + cross(b.w, p.position - b.center)) -
                   (a.v + cross(a.w, p.position - a.center));
        };
        const auto push = [&](const Point& p, Vec3 impulse) {
            a.v -= scaled(a.inverse_mass, impulse);
            a.w -= a.inverse_inertia * cross(p.position - a.center, impulse);
            b.v += scaled(b.inverse_mass, impulse);
            b.w += b.inverse_inertia * cross(p.position - b.center, impulse);
        };
        const auto response = [&](const Point& p, Vec3 d) {
            const Vec3 ta = cross(p.position - a.center, d), tb = cross(p.position - b.center, d);
            return dot(scaled(a.inverse_mass + b.inverse_mass, d), d) +
                   dot(ta, a.inverse_inertia * ta) + dot(tb, b.inverse_inertia * tb);
        };
        struct Load {
            double approach = 0, normal = 0;
            Vec3 friction;
        };
        std::vector<Load> loads(points.size());
        double hardest = 0;
        for (std::size_t k = 0; k < points.size(); k++) {
            loads[k].approach = dot(relative(points[k]), points[k].normal);
            if (-loads[k].approach > hardest) {
                hardest = -loads[k].approach;
                hit_ = {shape_id(world_, own),
                        shape_id(world_, other),
                        body_id(world_, a.body),
                        body_id(world_, b.body),
                        points[k].position,
                        points[k].normal,
                        hardest};
            }
        }
        for (int sweep = 0; sweep < 12; sweep++)
            for (std::size_t k = 0; k < points.size(); k++) {
                const Point& p = points[k];
                Load& load = loads[k];
                const double target =
                    -load.approach > tuning::restitution_speed ? -e * load.approach : 0;
                const double response_n = response(p, p.normal);
                if (!(response_n > 0)) continue;
                const double before = load.normal;
                load.normal =
                    maximum(0, before - (dot(relative(p), p.normal) - target) / response_n);
                push(p, p.normal * (load.normal - before));
                const Vec3 u = relative(p), slip = u - p.normal * dot(u, p.normal);
                const double speed = length(slip);
                if (speed < 1e-12) continue;
                const Vec3 along = slip * (1 / speed);
                const double response_t = response(p, along);
                if (!(response_t > 0)) continue;
                const Vec3 old = load.friction;
                Vec3 now = old - along * (speed / response_t);
                const double most = mu * load.normal, size = length(now);
                if (size > most) now = now * (size > 0 ? most / size : 0);
                load.friction = now;
                push(p, now - old);
            }
        if (hardest >= world_.def.hit_speed) world_.events.hits.push_back(hit_);
    }

    // The rest of the step with the new velocity. What impulses cannot move keeps its way.
    void go_on(const End& end, const Sweep& old, double at) {
        if (end.inverse_mass == Vec3{} && end.inverse_inertia == diagonal({0, 0, 0})) return;
        const BodyCold& cold = world_.bodies.cold[end.body];
        const double left = 1 - at, dt = left * step_.dt;
        const auto known = where_.find(end.body);
        const std::size_t index = known == where_.end() ? add(end.body, old, false) : known->second;
        Traveller& t = travellers_[index];
        // From here on it flies, whatever held it before: the next step's contacts will see.
        BodyWarm there = warm_of(world_, end.body);
        there.rotation = rotation_at(old, at);
        there.axes = to_matrix(there.rotation);
        there.w = end.w;
        there.torque = {};
        const FreeSpin free = dt > 0 ? free_spin(there, cold, dt) : FreeSpin{there.rotation, end.w};
        t.end_rotation = free.rotation;
        t.end_spin = free.w;
        t.flies = true;
        t.momentum = there.axes * (cold.inertia * transposed_times(there.axes, end.w));
        t.spin = end.w;
        t.velocity = end.v;
        // The way that is turned: the short one while it is less than half round.
        Vec3 turned = end.w * dt;
        if (length(turned) < 1.5 && dt > 0) {
            const Quat q = free.rotation * conjugate(there.rotation);
            const Vec3 v{q.x, q.y, q.z};
            const double l = length(v), sign = q.w < 0 ? -1 : 1;
            turned = l > 1e-12 ? v * (sign * 2 * arc_tangent(l, q.w * sign) / l) : Vec3{};
        }
        const Vec3 mean = end.v + t.gain * (0.5 * left);
        t.sweep = {at, end.center, there.rotation, mean * step_.dt,
                   left > 0 ? turned * (1 / left) : Vec3{}};
        t.changed = true;
        if (t.fast) return;
        // What was hit may now be fast itself.
        const double way = (length(end.v) + length(end.w) * cold.radius) * dt;
        if (!cold.continuous || way <= tuning::sweep_fraction * cold.inner_radius) return;
        t.fast = true;
        find_near(index);
        for (Traveller& other : travellers_)
            if (&other != &t && other.fast) other.looked = false;
    }

    void arrive(Traveller& t) {
        const bool stays = t.impacts >= tuning::sweep_impacts;
        const double until = stays ? t.sweep.from : 1;
        BodyWarm& warm = warm_of(world_, t.body);
        const Vec3 center = center_at(t.sweep, until);
        world_.bodies.reach[t.body].travel +=
            length(center - warm.center) + 3.2 * world_.bodies.cold[t.body].radius;
        warm.center = center;
        warm.rotation = stays ? rotation_at(t.sweep, until) : t.end_rotation;
        warm.axes = to_matrix(warm.rotation);
        warm.v = t.velocity + t.gain * (until - t.sweep.from);
        warm.w = stays ? t.spin : t.end_spin;
        warm.quiet = 0;
        look_ahead(world_, t.body, step_.dt);
        for (std::uint32_t s = world_.bodies.cold[t.body].first_shape; s != none;
             s = world_.shapes.shapes[s].next)
            if (!fits_fat_box(world_.shapes.shapes[s], warm, step_.dt))
                refatten(world_, s, warm, step_.dt);
    }

    StepContext& step_;
    WorldState& world_;
    std::vector<Traveller> travellers_;
    std::unordered_map<std::uint32_t, std::size_t> where_;  // looked up, never walked
    ContactHit hit_;
};

}  // namespace

void stop_fast_bodies(StepContext& step) {
    if (!step.world.def.continuous || step.world.scratch.any_fast == 0) return;
    Sweeper(step).run();
}

}  // namespace jostle::physics
