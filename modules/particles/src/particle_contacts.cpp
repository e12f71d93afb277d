// SPDX-License-Identifier: MIT
#include "modules/particles/src/particle_contacts.h"

#include <bit>
#include <cmath>
#include <optional>

namespace jostle::modules::particles_detail {

using namespace physics;

namespace {

using Vectors = std::vector<Vec3>;

struct CellOf {
    std::int64_t x, y, z;

    CellOf(Vec3 p, double inverse_size)
        : x(number(p.x * inverse_size)),
          y(number(p.y * inverse_size)),
          z(number(p.z * inverse_size)) {}
    bool operator==(const CellOf&) const = default;

    std::uint32_t bucket(std::int64_t dx, std::int64_t dy, std::int64_t dz,
                         std::uint32_t mask) const {
        const std::uint64_t h = static_cast<std::uint64_t>(x + dx) * 0x9e3779b97f4a7c15ULL ^
                                static_cast<std::uint64_t>(y + dy) * 0xc2b2ae3d27d4eb4fULL ^
                                static_cast<std::uint64_t>(z + dz) * 0x165667b19e3779f9ULL;
        return static_cast<std::uint32_t>((h ^ (h >> 32)) * 0x85ebca6b >> 8) & mask;
    }

private:
    // Particles are within 1e7 m (ParticleGroup::advance), so the number fits.
    static std::int64_t number(double x) { return static_cast<std::int64_t>(std::floor(x)); }
};

// The moment at which a pair touched, as the part of the substep that is left after it. Nullopt: it
// does not touch. 0: it overlaps, and did so at the start. The separation moved from `start` to
// `end` on a line.
std::optional<double> touch_of(Vec3 start, Vec3 end, double reach) {
    const double overlap = length_squared(end) - reach * reach;
    const double apart = length_squared(start) - reach * reach;
    if (apart <= 0) return overlap < 0 ? std::optional<double>(0) : std::nullopt;
    // |start + motion f| = reach: a f^2 + 2 b f + apart = 0, at the smaller root.
    const Vec3 motion = end - start;
    const double a = length_squared(motion), b = dot(start, motion);
    const double root = b * b - a * apart;
    if (b >= 0 || root < 0) return std::nullopt;
    const double f = apart / (square_root(root) - b);  // without cancellation
    if (f > 1) return std::nullopt;
    return 1 - f;
}

// Counting sort of the particles by bucket.
void sort_by_cell(const Vectors& positions, double inverse_size, ParticleScratch& s) {
    const auto count = static_cast<std::uint32_t>(positions.size());
    const std::uint32_t buckets = std::bit_ceil(maximum(count, 1) > 64 ? 2 * count : 128U);
    s.first_of_bucket.assign(buckets + 1, 0);
    s.bucket.resize(count), s.sorted.resize(count);
    for (std::uint32_t k = 0; k < count; k++) {
        s.bucket[k] = CellOf(positions[k], inverse_size).bucket(0, 0, 0, buckets - 1);
        s.first_of_bucket[s.bucket[k] + 1]++;
    }
    for (std::uint32_t b = 0; b < buckets; b++) s.first_of_bucket[b + 1] += s.first_of_bucket[b];
    // Fills each bucket from its end, backwards, and leaves first_of_bucket[b + 1] at its start.
    for (std::uint32_t k = count; k-- > 0;) s.sorted[--s.first_of_bucket[s.bucket[k] + 1]] = k;
    s.first_of_bucket.push_back(count);
}

struct PairSearch {
    const ParticleGroupDef& def;
    const Vectors &before, &positions;
    double inverse_size, reach;
    double near;  // pairs up to this distance may touch after other impacts
    std::uint32_t mask;
    ParticleScratch& s;

    // Finds the contacts of particle k with later ones of its cell, and with those of the half of
    // the neighbouring cells that come after it in z, y and x, so each pair is found once.
    void find(std::uint32_t k) const {
        const CellOf cell(positions[k], inverse_size);
        Found found;
        search(k, cell, 0, 0, 0, found);
        search(k, cell, 1, 0, 0, found);
        for (std::int64_t dx = -1; dx <= 1; dx++) search(k, cell, dx, 1, 0, found);
        if (!def.planar)
            for (std::int64_t dy = -1; dy <= 1; dy++)
                for (std::int64_t dx = -1; dx <= 1; dx++) search(k, cell, dx, dy, 1, found);
        s.pair_count[k] = found.contacts;
    }

private:
    struct Found {
        std::uint32_t contacts = 0, tested = 0;
    };

    void search(std::uint32_t k, const CellOf& cell, std::int64_t dx, std::int64_t dy,
                std::int64_t dz, Found& found) const {
        const bool own = dx == 0 && dy == 0 && dz == 0;
        const std::uint32_t bucket = cell.bucket(dx, dy, dz, mask);
        const std::uint32_t last = s.first_of_bucket[bucket + 2];
        for (std::uint32_t n = s.first_of_bucket[bucket + 1]; n < last; n++) {
            const std::uint32_t j = s.sorted[n];
            if (own && j <= k) continue;
            if (found.contacts == contacts_max || ++found.tested > tests_max) return;
            const Vec3 end = positions[j] - positions[k];
            if (length_squared(end) > near * near && !touch_of(before[j] - before[k], end, reach))
                continue;
            // Other cells may share the bucket and are searched by themselves.
            const CellOf other(positions[j], inverse_size);
            if (other.x == cell.x + dx && other.y == cell.y + dy && other.z == cell.z + dz)
                s.pairs[k * contacts_max + found.contacts++] = {k, j};
        }
    }
};

// Impacts between the pairs that were found, in sweeps over all of them.
class ContactSolver {
public:
    ContactSolver(const ParticleGroupDef& def, double h, double rest_speed, const Vectors& before,
                  Vectors& positions, Vectors& velocities, const ParticleScratch& s)
        : def_(def),
          h_(h),
          rest_speed_(rest_speed),
          before_(before),
          x_(positions),
          v_(velocities),
          s_(s) {}

    // First reflects each pair at the moment of its contact. Then sweeps, alternately from the last
    // and from the first pair, because impulses of a heap travel from pair to pair.
    void solve() {
        visit(false, [&](ParticlePair pair) { collide(pair); });
        for (int sweep = 0; sweep < sweeps_max && changed_; sweep++) {
            changed_ = false;
            visit(sweep % 2 == 0, [&](ParticlePair pair) { hold(pair); });
        }
    }

private:
    template <class Visit>
    void visit(bool backwards, Visit&& visit) const {
        const std::size_t count = x_.size();
        for (std::size_t n = 0; n < count; n++) {
            const std::size_t k = backwards ? count - 1 - n : n;
            for (std::uint32_t i = 0; i < s_.pair_count[k]; i++)
                visit(s_.pairs[k * contacts_max + i]);
        }
    }

    // Moves both particles from the contact to the end of the substep with their new velocities.
    void collide(ParticlePair pair) {
        const auto [a, b] = pair;
        const Vec3 end = x_[b] - x_[a], start = before_[b] - before_[a];
        const std::optional<double> left = touch_of(start, end, 2 * def_.radius);
        if (!left) return;
        const Vec3 touching = *left > 0 ? end - (end - start) * *left : end;
        const Vec3 change = reflect(pair, normal_of(touching));
        x_[a] -= change * (*left * h_), x_[b] += change * (*left * h_);
        separate(pair);
        changed_ = true;
    }

    void hold(ParticlePair pair) {
        const Vec3 r = x_[pair.b] - x_[pair.a];
        constexpr double touching = 1 + 1e-9;
        if (length_squared(r) > 4 * def_.radius * def_.radius * touching) return;
        if (reflect(pair, normal_of(r)) != Vec3{}) changed_ = true;
        separate(pair);
    }

    static Vec3 normal_of(Vec3 r) {
        const double apart = length(r);
        return apart > 0 ? r * (1 / apart) : Vec3{1, 0, 0};
    }

    double restitution_at(double approach) const {
        return approach > rest_speed_ ? def_.restitution : 0;
    }

    // Returns the change of the velocity of b; that of a is opposite.
    Vec3 reflect(ParticlePair pair, Vec3 n) {
        const auto [a, b] = pair;
        const double approach = -dot(v_[b] - v_[a], n);
        if (!(approach > 0)) return {};
        const Vec3 change = n * (0.5 * (1 + restitution_at(approach)) * approach);
        v_[a] -= change, v_[b] += change;
        support(a), support(b);
        return change;
    }

    void separate(ParticlePair pair) {
        const auto [a, b] = pair;
        const Vec3 r = x_[b] - x_[a];
        const double overlap = 2 * def_.radius - length(r);
        if (!(overlap > 0)) return;
        const Vec3 n = normal_of(r);
        x_[a] -= n * (0.5 * overlap), x_[b] += n * (0.5 * overlap);
        lift(a), lift(b);
    }

    // Calls visit(normal, offset, speed along the normal) for the surfaces that carry a particle.
    template <class Visit>
    void each_surface(std::uint32_t k, Visit&& visit) const {
        for (const ParticleSupport& plane : s_.planes)
            visit(plane.normal, plane.offset, plane.speed);
        if (k < s_.supports.size() && s_.supports[k].normal != Vec3{})
            visit(s_.supports[k].normal, s_.supports[k].offset, s_.supports[k].speed);
    }

    // A particle that lies on a surface does not move into it.
    void support(std::uint32_t k) {
        each_surface(k, [&](Vec3 n, double offset, double speed) {
            if (dot(n, x_[k]) > offset + 1e-9) return;
            const double approach = speed - dot(n, v_[k]);
            if (approach > 0) v_[k] += n * ((1 + restitution_at(approach)) * approach);
        });
    }
    void lift(std::uint32_t k) {
        each_surface(k, [&](Vec3 n, double offset, double) {
            const double below = offset - dot(n, x_[k]);
            if (below > 0) x_[k] += n * below;
        });
    }

    const ParticleGroupDef& def_;
    double h_, rest_speed_;
    const Vectors& before_;
    Vectors &x_, &v_;
    const ParticleScratch& s_;
    bool changed_ = false;
};

}  // namespace

void resolve_contacts(const ParticleGroupDef& def, double h, double rest_speed, const World* world,
                      const Vectors& before, Vectors& positions, Vectors& velocities,
                      ParticleScratch& s) {
    if (positions.size() < 2) return;
    const double inverse_size = 1 / (cell_radii * def.radius);
    sort_by_cell(positions, inverse_size, s);
    s.pair_count.resize(positions.size());
    s.pairs.resize(positions.size() * contacts_max);
    PairSearch search{def,
                      before,
                      positions,
                      inverse_size,
                      2 * def.radius,
                      2.25 * def.radius,
                      static_cast<std::uint32_t>(s.first_of_bucket.size() - 3),
                      s};
    for_ranges(world, positions.size(), 128, [&search](int first, int last) {
        for (int k = first; k < last; k++) search.find(static_cast<std::uint32_t>(k));
    });
    ContactSolver(def, h, rest_speed, before, positions, velocities, s).solve();
}

}  // namespace jostle::modules::particles_detail
