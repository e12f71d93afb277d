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

// All but 1 / worst of the impulse was more than the bonds bear: the piece changes its velocity by
// that share only, and what it met keeps the rest of its approach.
void Destruction::push_through(World& world, double dt) {
    again_.clear();
    agree();
    for (std::size_t first = 0; first < presses_.size();) {
        std::size_t end = first + 1;
        while (end < presses_.size() && &piece_of(presses_[end]) == &piece_of(presses_[first]))
            end++;
        yield(world, std::span(presses_).subspan(first, end - first), dt);
        first = end;
    }
    for (const Press& press : presses_)
        if (press.impact && press.worst > 1) let_through(world, press);
    for (const BodyState& mover : movers_) slow_down(world, mover);
}

// What was pressed on from several sides, and got its speed back along each, is no faster than it
// was.
void Destruction::slow_down(World& world, const BodyState& before) {
    const Result<BodyState> body = world.body(before.id);
    if (!body.ok() || body->type != BodyType::dynamic) return;
    const double speed = length(body->linear_velocity), most = length(before.linear_velocity);
    if (speed > most)
        static_cast<void>(
            world.set_linear_velocity(before.id, body->linear_velocity * (most / speed)).ok());
}

// Of two breaking bodies the weaker one says what both bear.
void Destruction::agree() {
    for (Press& press : presses_) {
        if (!press.twin || !press.impact) continue;
        for (const Press& other : presses_)
            if (other.own == press.other && other.other == press.own && press.worst > 1 &&
                other.worst > press.worst)
                press.worst = other.worst;
    }
}

Destruction::Piece& Destruction::piece_of(const Press& press) {
    Whole& whole = wholes_[press.whole];
    return whole.pieces[whole.chunks[press.chunk].piece];
}

double Destruction::impulse_of(const Press& press) {
    return press.impact ? (press.approach + press.parting) / press.inv : 0;
}

// One piece, with all that presses on it. What it gives back goes to those that hit it, by
// how hard they did. Where what is static pressed, too, it is not known who gave what.
void Destruction::yield(World& world, std::span<Press> presses, double dt) {
    double worst = 0, impulses = 0;
    bool free = true;
    for (const Press& press : presses) {
        worst = maximum(worst, press.worst);
        impulses += impulse_of(press);
        const Result<BodyState> other = world.body(press.other_body);
        free = free && other.ok() && other->type == BodyType::dynamic;
    }
    const Piece& piece = piece_of(presses[0]);
    const Result<BodyState> body = world.body(piece.body);
    if (!(worst > 1) || !body.ok() || body->type != BodyType::dynamic) return;
    const double share = 1 - 1 / worst;
    const Vec3 linear = (body->linear_velocity - piece.linear - world.gravity() * dt) * share;
    const Vec3 angular = (body->angular_velocity - piece.angular) * share;
    for (Press& press : presses) {
        press.free = free;
        press.back = linear * (body->mass * impulse_of(press) / impulses);
    }
    static_cast<void>(world
                          .set_velocity(piece.body, body->linear_velocity - linear,
                                        body->angular_velocity - angular)
                          .ok());
}

// The energy that the bonds took comes off the speed that is left: E = (v0^2 - v^2) / (2 inv).
void Destruction::let_through(World& world, const Press& press) {
    const double kept = press.approach - (press.approach + press.parting) / press.worst;
    const double left2 = kept * absolute(kept) - 2 * press.paid * press.inv;
    const double speed = left2 > 0 ? square_root(left2) : 0;
    const BodyId own = piece_of(press).body;
    const Result<BodyState> a = world.body(own), b = world.body(press.other_body);
    if (!a.ok() || !b.ok()) return;
    const Vec3 n = press.normal;
    const double inv_b = give(*b, press.point, n);
    Vec3 back = press.free ? press.back : Vec3{};
    if (inv_b > 0 && !press.free && kept > 0)
        back = n * ((kept - dot(velocity_at(*b, press.point) - velocity_at(*a, press.point), n)) /
                    inv_b);
    if (!other_yields(press))
        static_cast<void>(world.apply_impulse(press.other_body, back, press.point).ok());
    if (!(kept > 0)) return;
    const Vec3 paid = n * ((kept - speed) / press.inv);
    static_cast<void>(world.apply_impulse(own, paid, press.point).ok());
    static_cast<void>(world.apply_impulse(press.other_body, -paid, press.point).ok());
    if (speed > 0)
        again_.push_back(
            {press.whole, press.chunk, press.other, press.other_body, press.point, -n, speed});
}

// Whether what it met broke, too, and has its own share.
bool Destruction::other_yields(const Press& press) const {
    return press.twin && std::any_of(presses_.begin(), presses_.end(), [&](const Press& other) {
               return other.own == press.other && other.other == press.own && other.worst > 1;
           });
}

}  // namespace jostle::modules
