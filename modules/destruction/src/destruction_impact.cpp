// SPDX-License-Identifier: MIT
//
// What meets a piece that breaks under it: it was pushed no harder than the bonds bear, so both get
// back what was more.
#include <algorithm>

#include "bond_network.h"
#include "contact_motion.h"
#include "destruction_impact.h"
#include "jostle/modules/destruction.h"

namespace jostle::modules {

using namespace physics;
using namespace destruction_detail;

namespace {

constexpr double knocked_time = 0.2;  // s
constexpr int rounds_of_giving = 16;

void push(BodyState& body, Vec3 impulse, Vec3 point) {
    if (!(body.mass > 0)) return;
    body.linear_velocity += impulse / body.mass;
    body.angular_velocity += inverse(body.inertia) * cross(point - body.center, impulse);
}

// What a piece gives back to what struck it.
struct GivenBack {
    Vec3 point, normal;  // the normal pushes what struck on its way
    std::size_t own = 0, other = 0;
    double speed = 0;  // m/s, against each other, that it shall have
    double give_own = 0, give_other = 0;
    double impulse = 0;  // N s, so far

    // The piece gives no more than it got since then.
    void share(BodyState& piece, BodyState& struck, Vec3 linear, Vec3 angular) {
        if (!(give_own + give_other > 0)) return;
        const double now = dot(velocity_at(struck, point) - velocity_at(piece, point), normal);
        double more = (speed - now) / (give_own + give_other);
        if (give_own > 0) {
            const Vec3 got = piece.linear_velocity - linear +
                             cross(piece.angular_velocity - angular, point - piece.center);
            more = minimum(more, dot(got, normal) / give_own);
        }
        more = maximum(more, -impulse);
        impulse += more;
        push(struck, normal * more, point);
        if (give_own > 0) push(piece, normal * -more, point);
    }
};

}  // namespace

// As bodies moved before the step, for what yields(); and who was knocked out.
void Destruction::before_step(World& world, double dt) {
    derive();
    knocked_.clear();
    movers_.clear();
    before_.clear();
    for (const Again& again : again_)
        if (const Result<BodyState> body = world.body(again.other_body); body.ok())
            movers_.push_back(*body);
    for (std::uint32_t w = 0; w < wholes_.size(); w++)
        for (Piece& piece : wholes_[w].pieces) {
            if (piece.knocked > 0) {
                knocked_.emplace_back(piece.body, w);
                piece.knocked = maximum(0, piece.knocked - dt);
            }
            if (piece.anchored || piece.chunks.size() < 2) continue;
            const Result<BodyState> body = world.body(piece.body);
            if (!body.ok()) continue;
            piece.linear = body->linear_velocity;
            piece.angular = body->angular_velocity;
        }
}

void Destruction::pre_solve(PreSolve& pair) {
    if (place_of(pair.shape_a)) note_before(pair.world, pair.body_b);
    if (place_of(pair.shape_b)) note_before(pair.world, pair.body_a);
    for (const auto& [body, whole] : knocked_) {
        if (pair.body_a != body && pair.body_b != body) continue;
        const BodyId other = pair.body_a == body ? pair.body_b : pair.body_a;
        for (const Piece& piece : wholes_[whole].pieces)
            if (piece.body == other) pair.enabled = false;
    }
}

// As it was before the first thing that met it in this step.
void Destruction::note_before(const World& world, BodyId body) {
    if (velocity_before(body)) return;
    if (const Result<BodyState> state = world.body(body); state.ok()) before_.push_back(*state);
}

const BodyState* Destruction::velocity_before(BodyId body) const {
    for (const std::vector<BodyState>* known : {&movers_, &before_})
        for (const BodyState& state : *known)
            if (state.id == body) return &state;
    return nullptr;
}

// What was struck and parted from what it hung on.
void Destruction::mark_knocked() {
    for (const Again& again : again_) {
        Whole& whole = wholes_[again.whole];
        const std::uint32_t at = whole.chunks[again.chunk].piece;
        if (at >= whole.pieces.size()) continue;
        Piece& piece = whole.pieces[at];
        if (!piece.anchored && piece.chunks.size() == 1) piece.knocked = knocked_time;
    }
}

// All but 1 / worst of the impulse was more than the bonds bear. It is taken back from both at the
// point where it acted, so momenta stay what they were.
void Destruction::push_through(World& world, double dt) {
    again_.clear();
    agree();
    for (std::size_t first = 0; first < presses_.size();) {
        std::size_t end = first + 1;
        while (end < presses_.size() && &piece_of(presses_[end]) == &piece_of(presses_[first]))
            end++;
        settle_grounded(world, std::span(presses_).subspan(first, end - first), dt);
        first = end;
    }
    let_through(world, dt);
}

// Of two breaking bodies the weaker one says what both bear; both pay.
void Destruction::agree() {
    for (std::size_t k = 0; k < presses_.size(); k++) {
        Press& press = presses_[k];
        if (!press.twin || !press.impact || !(press.worst > 1)) continue;
        for (std::size_t i = 0; i < k; i++) {
            Press& other = presses_[i];
            if (other.own != press.other || other.other != press.own || !(other.worst > 1))
                continue;
            press.worst = other.worst = maximum(press.worst, other.worst);
            press.paid = other.paid = press.paid + other.paid;
            press.second = true;
        }
    }
}

Destruction::Piece& Destruction::piece_of(const Press& press) {
    Whole& whole = wholes_[press.whole];
    return whole.pieces[whole.chunks[press.chunk].piece];
}

// A piece that something static presses, too: it is not known who gave what. It keeps of its change
// of velocity what its bonds bear; the ground takes the rest.
void Destruction::settle_grounded(World& world, std::span<Press> presses, double dt) {
    double worst = 0;
    bool free = true;
    for (const Press& press : presses) {
        worst = maximum(worst, press.worst);
        const Result<BodyState> other = world.body(press.other_body);
        free = free && other.ok() && other->type == BodyType::dynamic;
    }
    if (free || !(worst > 1)) return;
    for (Press& press : presses) press.grounded = true;
    const Piece& piece = piece_of(presses[0]);
    const Result<BodyState> body = world.body(piece.body);
    if (!body.ok() || body->type != BodyType::dynamic) return;
    const double share = 1 - 1 / worst;
    const Vec3 linear = (body->linear_velocity - piece.linear - world.gravity() * dt) * share;
    const Vec3 angular = (body->angular_velocity - piece.angular) * share;
    static_cast<void>(world
                          .set_velocity(piece.body, body->linear_velocity - linear,
                                        body->angular_velocity - angular)
                          .ok());
}

// The speed against each other that is left: the energy that the bonds took comes off it,
// E = (v0^2 - v^2) / (2 inv). Negative: they part.
double Destruction::speed_left(const Press& press) {
    const double kept = press.approach - (press.approach + press.parting) / press.worst;
    if (!(kept > 0)) return kept;
    const double left2 = kept * kept - 2 * press.paid * press.inv;
    return left2 > 0 ? square_root(left2) : 0;
}

// How fast they shall meet again. Deflected within the step, it met this with a speed that it did
// not bring: what gets back no more than it brought along any normal has no more energy than that.
double Destruction::speed_back(const World& world, const Press& press) const {
    const double speed = speed_left(press);
    const BodyState* before = velocity_before(press.other_body);
    const Whole& whole = wholes_[press.whole];
    const Piece& piece = whole.pieces[whole.chunks[press.chunk].piece];
    const Result<BodyState> own = world.body(piece.body);
    if (!before || !own.ok()) return speed;
    const Vec3 brought = velocity_at(*before, press.point) - piece.linear -
                         cross(piece.angular, press.point - own->center);
    return minimum(speed, dot(brought, press.normal));
}

// All that go on, at once: what one gives back may be what another need not. Projected Gauss-Seidel
// on copies of the bodies; then each impulse acts on both at its point.
void Destruction::let_through(World& world, double dt) {
    std::vector<BodyState> bodies;
    std::vector<Vec3> linear, angular;  // of pieces, before the step
    const auto add = [&](BodyId id, const Piece* piece) {
        std::size_t at = 0;
        while (at < bodies.size() && bodies[at].id != id) at++;
        if (at == bodies.size()) {
            bodies.push_back(*world.body(id));
            linear.push_back({});
            angular.push_back({});
        }
        if (piece) linear[at] = piece->linear + world.gravity() * dt, angular[at] = piece->angular;
        return at;
    };
    std::vector<GivenBack> all;
    for (const Press& press : presses_) {
        if (!press.impact || !(press.worst > 1)) continue;
        const Piece& piece = piece_of(press);
        if (!world.contains(piece.body) || !world.contains(press.other_body)) continue;
        const double speed = speed_back(world, press);
        if (speed > 0)
            again_.push_back({press.whole, press.chunk, press.other, press.other_body, press.point,
                              -press.normal, speed});
        if (press.second) continue;
        const std::size_t own = add(piece.body, &piece), other = add(press.other_body, nullptr);
        all.push_back(
            {.point = press.point,
             .normal = press.normal,
             .own = own,
             .other = other,
             .speed = speed,
             .give_own = press.grounded ? 0 : give(bodies[own], press.point, press.normal),
             .give_other = give(bodies[other], press.point, press.normal)});
    }
    for (int round = 0; round < rounds_of_giving; round++)
        for (GivenBack& one : all)
            one.share(bodies[one.own], bodies[one.other], linear[one.own], angular[one.own]);
    for (const GivenBack& one : all) {
        if (!(one.impulse > 0)) continue;
        const Vec3 push = one.normal * one.impulse;
        static_cast<void>(world.apply_impulse(bodies[one.other].id, push, one.point).ok());
        if (one.give_own > 0)
            static_cast<void>(world.apply_impulse(bodies[one.own].id, -push, one.point).ok());
    }
}

}  // namespace jostle::modules
