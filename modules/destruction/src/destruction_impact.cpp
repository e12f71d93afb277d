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

}  // namespace

// As bodies moved before the step, for what yields(); and who was knocked out.
void Destruction::before_step(World& world, double dt) {
    knocked_.clear();
    movers_.clear();
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
    for (const auto& [body, whole] : knocked_) {
        if (pair.body_a != body && pair.body_b != body) continue;
        const BodyId other = pair.body_a == body ? pair.body_b : pair.body_a;
        for (const Piece& piece : wholes_[whole].pieces)
            if (piece.body == other) pair.enabled = false;
    }
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
    for (const Press& press : presses_)
        if (press.impact && press.worst > 1) let_through(world, press, dt);
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

// Where they meet in several places the first ones give back what the others need not: none gets
// more than the speed that it had there, and the piece gives back no more than it got.
void Destruction::let_through(World& world, const Press& press, double dt) {
    const Piece& piece = piece_of(press);
    const Result<BodyState> a = world.body(piece.body), b = world.body(press.other_body);
    if (!a.ok() || !b.ok()) return;
    const Vec3 n = press.normal;
    const double speed = speed_left(press);
    const double inv_a = press.grounded ? 0 : give(*a, press.point, n);
    const double inv_b = give(*b, press.point, n);
    const double now = dot(velocity_at(*b, press.point) - velocity_at(*a, press.point), n);
    double impulse = inv_a + inv_b > 0 ? (speed - now) / (inv_a + inv_b) : 0;
    if (inv_a > 0) {
        const Vec3 got = a->linear_velocity - piece.linear - world.gravity() * dt +
                         cross(a->angular_velocity - piece.angular, press.point - a->center);
        impulse = minimum(impulse, dot(got, n) / inv_a);
    }
    if (impulse > 0 && !press.second) {
        static_cast<void>(world.apply_impulse(press.other_body, n * impulse, press.point).ok());
        if (inv_a > 0)
            static_cast<void>(world.apply_impulse(piece.body, n * -impulse, press.point).ok());
    }
    if (speed > 0)
        again_.push_back(
            {press.whole, press.chunk, press.other, press.other_body, press.point, -n, speed});
}

}  // namespace jostle::modules
