// SPDX-License-Identifier: MIT
#include "modules/cloth/src/sheet_contacts.h"

#include <algorithm>
#include <cmath>

#include "jostle/base/check.h"
#include "jostle/modules/segments.h"
#include "jostle/physics/scalar.h"

namespace jostle::modules::cloth_detail {

using namespace physics;

namespace {

// Of the distance between two primitives, the share that each may move before the next search. The
// rest is for rounding.
constexpr double share = 0.45;
// Primitives that are closer than this cross already, m.
constexpr double crossed = 1e-7;

// Closest point of a triangle to p, as weights of its corners (Ericson, Real-Time Collision
// Detection, 5.1.5).
std::array<double, 3> closest_on_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const Vec3 bp = p - b;
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        const double t = d1 / (d1 - d3);
        return {1 - t, t, 0};
    }
    const Vec3 cp = p - c;
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        const double t = d2 / (d2 - d6);
        return {1 - t, 0, t};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - t, t};
    }
    const double sum = va + vb + vc;
    if (!(sum > 0)) return {1, 0, 0};
    return {va / sum, vb / sum, vc / sum};
}

// Boxes by the cell of their low corner. No box is longer than a cell. The results and their order
// depend on the boxes and on the order of add() only.
class Grid {
public:
    explicit Grid(double size) : size_(size), scale_(1 / size) {}

    void add(Vec3 low, std::uint32_t item) {
        added_.push_back({cell(index(low.x), index(low.y), index(low.z)), item});
    }
    // After the last add().
    void build() {
        std::size_t buckets = 16;
        while (buckets < 2 * added_.size()) buckets *= 2;
        mask_ = buckets - 1;
        starts_.assign(buckets + 1, 0);
        for (const Entry& entry : added_) starts_[bucket(entry.cell) + 1]++;
        for (std::size_t k = 1; k < starts_.size(); k++) starts_[k] += starts_[k - 1];
        entries_.resize(added_.size());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for (const Entry& entry : added_) entries_[next[bucket(entry.cell)]++] = entry;
    }
    // Calls use(item) once for each item that may overlap a box.
    template <class Use>
    void find(Vec3 low, Vec3 high, Use&& use) const {
        for (std::int64_t x = index(low.x - size_); x <= index(high.x); x++)
            for (std::int64_t y = index(low.y - size_); y <= index(high.y); y++)
                for (std::int64_t z = index(low.z - size_); z <= index(high.z); z++) {
                    const std::uint64_t wanted = cell(x, y, z);
                    const std::size_t k = bucket(wanted);
                    for (std::uint32_t n = starts_[k]; n < starts_[k + 1]; n++)
                        if (entries_[n].cell == wanted) use(entries_[n].item);
                }
    }

private:
    struct Entry {
        std::uint64_t cell = 0;
        std::uint32_t item = 0;
    };
    std::int64_t index(double x) const { return static_cast<std::int64_t>(std::floor(x * scale_)); }
    static std::uint64_t cell(std::int64_t x, std::int64_t y, std::int64_t z) {
        constexpr std::uint64_t bits = (1u << 21) - 1;
        return (static_cast<std::uint64_t>(x) & bits) << 42 |
               (static_cast<std::uint64_t>(y) & bits) << 21 |
               (static_cast<std::uint64_t>(z) & bits);
    }
    // Multiplication by the golden ratio (Knuth, The Art of Computer Programming, 6.4).
    std::size_t bucket(std::uint64_t cell) const {
        return static_cast<std::size_t>((cell * 0x9e3779b97f4a7c15u) >> 32) & mask_;
    }

    double size_, scale_;
    std::size_t mask_ = 0;
    std::vector<Entry> added_, entries_;
    std::vector<std::uint32_t> starts_;
};

}  // namespace

// ---- the sheets ----

void SheetContacts::take(std::span<const ContactSheet> sheets) {
    bool is_same = sheets.size() == parts_.size();
    for (std::size_t k = 0; is_same && k < sheets.size(); k++)
        is_same = parts_[k].of.number == sheets[k].number &&
                  parts_[k].triangles == sheets[k].sheet->topology().triangles.size();
    parts_.resize(sheets.size());
    std::uint32_t vertices = 0;
    for (std::size_t k = 0; k < sheets.size(); k++) {
        parts_[k].of = sheets[k];
        parts_[k].first = vertices;
        parts_[k].shift = sheets[k].sheet->root() - sheets[0].sheet->root();
        vertices += static_cast<std::uint32_t>(sheets[k].sheet->size());
    }
    if (!is_same) read_meshes();
    nodes_.clear();
    for (const Part& part : parts_)
        for (SheetNode& node : part.of.sheet->nodes()) nodes_.push_back(&node);
    ASSERT(nodes_.size() == vertices);
}

void SheetContacts::read_meshes() {
    valid_ = false;
    vertex_part_.clear();
    mesh_faces_.clear();
    mesh_edges_.clear();
    for (std::uint32_t k = 0; k < parts_.size(); k++) {
        Part& part = parts_[k];
        const auto& triangles = part.of.sheet->topology().triangles;
        part.triangles = triangles.size();
        vertex_part_.resize(vertex_part_.size() + part.of.sheet->size(), k);
        for (const auto& t : triangles) {
            const auto& face = mesh_faces_.emplace_back(
                std::array{t[0] + part.first, t[1] + part.first, t[2] + part.first});
            for (std::size_t n = 0; n < 3; n++)
                mesh_edges_.push_back(
                    {std::min(face[n], face[(n + 1) % 3]), std::max(face[n], face[(n + 1) % 3])});
        }
    }
    std::sort(mesh_edges_.begin(), mesh_edges_.end());
    mesh_edges_.erase(std::unique(mesh_edges_.begin(), mesh_edges_.end()), mesh_edges_.end());
}

std::uint32_t SheetContacts::part_of(std::uint32_t vertex) const {
    return vertex_part_[vertex];
}
bool SheetContacts::may_touch(std::uint32_t part, std::uint32_t other) const {
    if (part == other) return parts_[part].of.collide_self && !parts_[part].of.is_fixed;
    return !parts_[part].of.is_fixed || !parts_[other].of.is_fixed;
}
double SheetContacts::gap(std::uint32_t part, std::uint32_t other) const {
    return parts_[part].of.thickness + parts_[other].of.thickness;
}
double SheetContacts::friction(std::uint32_t part, std::uint32_t other) const {
    if (part == other) return parts_[part].of.friction;
    return square_root(parts_[part].of.friction * parts_[other].of.friction);
}
Vec3 SheetContacts::rest(std::uint32_t vertex, bool in_cloth) const {
    const Part& part = parts_[part_of(vertex)];
    const Sheet& sheet = *part.of.sheet;
    return in_cloth ? sheet.topology().rest[vertex - part.first]
                    : sheet.initial()[vertex - part.first];
}
Vec3 SheetContacts::start_of(std::uint32_t vertex) const {
    const SheetNode& n = *nodes_[vertex];
    return Vec3{n.x, n.y, n.z} + parts_[part_of(vertex)].shift;
}
Vec3 SheetContacts::moved_of(std::uint32_t vertex) const {
    if (parts_[part_of(vertex)].of.is_fixed) return {};
    const SheetNode& n = *nodes_[vertex];
    return {n.moved_x, n.moved_y, n.moved_z};
}
double SheetContacts::inverse_mass(std::uint32_t vertex) const {
    return parts_[part_of(vertex)].of.is_fixed ? 0 : double{nodes_[vertex]->inverse_mass};
}

// ---- the search ----

// Parts that cross already have no sides to stay on.
void SheetContacts::limit(std::uint32_t vertex, double distance) {
    if (distance < crossed) return;
    bounds_[vertex] = std::min(bounds_[vertex], static_cast<float>(share * distance));
}

void SheetContacts::search(double reach) {
    searches_++;
    const auto count = static_cast<std::uint32_t>(nodes_.size());
    start_.resize(count);
    for (std::uint32_t k = 0; k < count; k++) start_[k] = start_of(k);
    for (Part& part : parts_) {
        part.box = {start_[part.first], start_[part.first]};
        for (std::size_t k = 1; k < part.of.sheet->size(); k++) {
            part.box.low = min(part.box.low, start_[part.first + k]);
            part.box.high = max(part.box.high, start_[part.first + k]);
        }
    }
    bounds_.assign(count, static_cast<float>(share * reach));
    double longest = reach;
    for (const auto& [a, b] : mesh_edges_)
        longest = maximum(longest, length(start_[a] - start_[b]));
    find_faces(reach, longest);
    find_edges(reach, longest);
    common_ = {};
    valid_ = true;
}

bool SheetContacts::may_touch_in(Vec3 low, Vec3 high, std::uint32_t part, double reach) const {
    const Vec3 more{reach, reach, reach};
    const Aabb box{low - more, high + more};
    for (std::uint32_t other = 0; other < parts_.size(); other++)
        if (may_touch(part, other) && overlap(box, parts_[other].box)) return true;
    return false;
}

void SheetContacts::find_faces(double reach, double longest) {
    faces_.clear();
    Grid grid(longest);
    for (std::uint32_t f = 0; f < mesh_faces_.size(); f++) {
        const Vec3 a = start_[mesh_faces_[f][0]], b = start_[mesh_faces_[f][1]],
                   c = start_[mesh_faces_[f][2]];
        const Vec3 low = min(a, min(b, c)), high = max(a, max(b, c));
        if (may_touch_in(low, high, part_of(mesh_faces_[f][0]), reach)) grid.add(low, f);
    }
    grid.build();
    const Vec3 more{reach, reach, reach};
    for (std::uint32_t v = 0; v < start_.size(); v++) {
        const Vec3 p = start_[v];
        if (!may_touch_in(p, p, part_of(v), reach)) continue;
        grid.find(p - more, p + more, [&](std::uint32_t f) {
            const auto& t = mesh_faces_[f];
            if (t[0] == v || t[1] == v || t[2] == v) return;
            if (!may_touch(part_of(v), part_of(t[0]))) return;
            const Vec3 a = start_[t[0]], b = start_[t[1]], c = start_[t[2]];
            const Vec3 low = min(a, min(b, c)), high = max(a, max(b, c));
            if (p.x < low.x - reach || p.y < low.y - reach || p.z < low.z - reach ||
                p.x > high.x + reach || p.y > high.y + reach || p.z > high.z + reach)
                return;
            const std::array<double, 3> w = closest_on_triangle(p, a, b, c);
            const double distance = length(p - (a * w[0] + b * w[1] + c * w[2]));
            if (distance > reach) return;
            faces_.push_back({v, t});
            limit(v, distance);
            for (const std::uint32_t k : t) limit(k, distance);
        });
    }
}

void SheetContacts::find_edges(double reach, double longest) {
    edges_.clear();
    Grid grid(longest);
    for (std::uint32_t e = 0; e < mesh_edges_.size(); e++) {
        const Vec3 a = start_[mesh_edges_[e][0]], b = start_[mesh_edges_[e][1]];
        if (may_touch_in(min(a, b), max(a, b), part_of(mesh_edges_[e][0]), reach))
            grid.add(min(a, b), e);
    }
    grid.build();
    const Vec3 more{reach, reach, reach};
    for (std::uint32_t e = 0; e < mesh_edges_.size(); e++) {
        const std::uint32_t a0 = mesh_edges_[e][0], a1 = mesh_edges_[e][1];
        if (!may_touch_in(min(start_[a0], start_[a1]), max(start_[a0], start_[a1]), part_of(a0),
                          reach))
            continue;
        const Vec3 low = min(start_[a0], start_[a1]) - more,
                   high = max(start_[a0], start_[a1]) + more;
        grid.find(low, high, [&](std::uint32_t other) {
            if (other <= e) return;
            const auto [b0, b1] = mesh_edges_[other];
            if (a0 == b0 || a0 == b1 || a1 == b0 || a1 == b1) return;
            if (!may_touch(part_of(a0), part_of(b0))) return;
            const Vec3 p = start_[b0], q = start_[b1];
            const Vec3 l = min(p, q), u = max(p, q);
            if (u.x < low.x || u.y < low.y || u.z < low.z || l.x > high.x || l.y > high.y ||
                l.z > high.z)
                return;
            const auto [s, t] = closest_on_segments(start_[a0], start_[a1], p, q, 0);
            const double distance =
                length(start_[a0] + (start_[a1] - start_[a0]) * s - (p + (q - p) * t));
            if (distance > reach) return;
            edges_.push_back({a0, a1, b0, b1});
            for (const std::uint32_t k : {a0, a1, b0, b1}) limit(k, distance);
        });
    }
}

// ---- the contacts ----

// Pushes two points apart, weighted sums of up to four vertices: negative weights on one side.
void SheetContacts::separate(std::span<const std::uint32_t> vertices,
                             std::span<const double> weights, std::uint32_t part,
                             std::uint32_t other) {
    Vec3 apart, relative, apart_at_rest;
    double response = 0;
    for (std::size_t k = 0; k < vertices.size(); k++) {
        apart += end_of(vertices[k]) * weights[k];
        relative += moved_of(vertices[k]) * weights[k];
        response += inverse_mass(vertices[k]) * weights[k] * weights[k];
        apart_at_rest += rest(vertices[k], part == other) * weights[k];
    }
    // Neighbours in a mesh that is finer than the gap, and cloths that started closer, remain so.
    const double distance_min = minimum(gap(part, other), 0.8 * length(apart_at_rest));
    const double distance = length(apart);
    if (distance >= distance_min || !(distance > 1e-9) || !(response > 0)) return;
    const Vec3 n = apart * (1 / distance);
    const double push = (distance_min - distance) / response;
    Vec3 impulse = n * push;
    const Vec3 slip = relative - n * dot(n, relative);
    const double size = length(slip);
    if (size > 1e-12)
        impulse -= slip * (minimum(friction(part, other) * push, size / response) / size);
    for (std::size_t k = 0; k < vertices.size(); k++) {
        const Part& owner = parts_[part_of(vertices[k])];
        if (owner.of.is_fixed) continue;
        owner.of.sheet->set_moved(
            vertices[k] - owner.first,
            moved_of(vertices[k]) + impulse * (weights[k] * inverse_mass(vertices[k])));
    }
}

void SheetContacts::push_apart() {
    for (const Faces& pair : faces_) {
        const auto& [a, b, c] = pair.face;
        const std::array<double, 3> w =
            closest_on_triangle(end_of(pair.vertex), end_of(a), end_of(b), end_of(c));
        const std::uint32_t vertices[] = {pair.vertex, a, b, c};
        const double weights[] = {1, -w[0], -w[1], -w[2]};
        separate(vertices, weights, part_of(pair.vertex), part_of(a));
    }
    for (const Edges& pair : edges_) {
        const auto [s, t] = closest_on_segments(end_of(pair.a0), end_of(pair.a1), end_of(pair.b0),
                                                end_of(pair.b1), 0);
        const std::uint32_t vertices[] = {pair.a0, pair.a1, pair.b0, pair.b1};
        const double weights[] = {1 - s, s, t - 1, -t};
        separate(vertices, weights, part_of(pair.a0), part_of(pair.b0));
    }
}

// ---- bounds ----

Vec3 SheetContacts::mean_motion() const {
    if (!is_free_) return {};
    Vec3 sum;
    double mass = 0;
    for (std::uint32_t k = 0; k < nodes_.size(); k++) {
        const double m = 1 / inverse_mass(k);
        sum += moved_of(k) * m;
        mass += m;
    }
    return sum * (1 / mass);
}

bool SheetContacts::leaves_bounds() const {
    const Vec3 common = common_ + mean_motion();
    for (std::uint32_t k = 0; k < nodes_.size(); k++) {
        const double bound = double{bounds_[k]};
        if (length_squared(end_of(k) - start_[k] - common) > bound * bound) return true;
    }
    return false;
}

void SheetContacts::move_all(Vec3 by) {
    for (const Part& part : parts_)
        for (std::uint32_t k = 0; k < part.of.sheet->size(); k++)
            part.of.sheet->set_moved(k, part.of.sheet->moved(k) + by);
}

// Returns whether a vertex reached its bound.
bool SheetContacts::bound() {
    common_ += mean_motion();
    bool reached = false;
    Vec3 lost;
    double mass = 0;
    for (const Part& part : parts_) {
        if (part.of.is_fixed) continue;
        const auto count = static_cast<std::uint32_t>(part.of.sheet->size());
        for (std::uint32_t k = part.first; k < part.first + count; k++) {
            if (is_free_) mass += 1 / inverse_mass(k);
            const Vec3 motion = end_of(k) - start_[k] - common_;
            const double size = length(motion), most = double{bounds_[k]};
            if (size <= most) continue;
            reached = true;
            if (is_free_) lost += motion * ((1 - most / size) / inverse_mass(k));
            part.of.sheet->set_moved(k - part.first,
                                     start_[k] + common_ + motion * (most / size) - start_of(k));
        }
    }
    if (is_free_ && reached) move_all(lost * (1 / mass));
    return reached;
}

void SheetContacts::resolve(std::span<const ContactSheet> sheets) {
    take(sheets);
    is_free_ = true;
    double most = 0, thickness = 0;
    for (std::uint32_t k = 0; k < nodes_.size(); k++) is_free_ = is_free_ && inverse_mass(k) > 0;
    const Vec3 mean = mean_motion();
    for (std::uint32_t k = 0; k < nodes_.size(); k++)
        most = maximum(most, length_squared(moved_of(k) - mean));
    for (const Part& part : parts_) thickness = maximum(thickness, part.of.thickness);
    // A fast sheet gets a greater reach, so that it is rarely bounded by it.
    const double widest = 2 * thickness, reach = 1.2 * widest + 2 * square_root(most);
    if (!valid_ || leaves_bounds()) search(minimum(reach, 6 * widest));
    push_apart();
    // The next search starts from the bounded positions.
    if (bound()) valid_ = false;
}

}  // namespace jostle::modules::cloth_detail
