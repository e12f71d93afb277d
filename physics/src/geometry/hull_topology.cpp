// SPDX-License-Identifier: MIT
//
// Quickhull (Barber, Dobkin, Huhdanpaa 1996) on triangles. Each face stores the points above it.
// The highest of them becomes a vertex, and the faces visible from it are replaced by a fan to
// their horizon.
#include "physics/src/geometry/hull_topology.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

// Products of three coordinate differences need 95 bits.
__extension__ typedef __int128 Wide;

struct Face {
    std::array<std::uint32_t, 3> corner{};
    // Adjacent face across the edge from corner k to corner k + 1.
    std::array<std::uint32_t, 3> across{};
    // Points outside this face; each point is in the list of one face.
    std::vector<std::uint32_t> above;
    bool alive = true;
    bool seen = false;
};

constexpr std::uint32_t no_index = 0xffffffff;

class Builder {
public:
    explicit Builder(std::span<const GridPoint> points) : points_(points) {}

    std::optional<std::vector<HullTriangle>> run() {
        if (!make_tetrahedron()) return std::nullopt;
        for (std::uint32_t face = next_open(0); face != no_index; face = next_open(face)) {
            add_point(face);
        }
        std::vector<HullTriangle> result;
        for (const Face& face : faces_)
            if (face.alive) result.push_back(face.corner);
        return result;
    }

private:
    // Six times the signed volume of (a, b, c, p): positive if p is above the face (a, b, c).
    Wide volume(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t p) const {
        const GridPoint &o = points_[a], &q = points_[b], &r = points_[c], &s = points_[p];
        ASSERT(a != b && b != c && c != a);
        const std::int64_t ux = q.x - o.x, uy = q.y - o.y, uz = q.z - o.z;
        const std::int64_t vx = r.x - o.x, vy = r.y - o.y, vz = r.z - o.z;
        const std::int64_t wx = s.x - o.x, wy = s.y - o.y, wz = s.z - o.z;
        const Wide nx = Wide(uy) * vz - Wide(uz) * vy, ny = Wide(uz) * vx - Wide(ux) * vz,
                   nz = Wide(ux) * vy - Wide(uy) * vx;
        return nx * wx + ny * wy + nz * wz;
    }
    Wide height(const Face& face, std::uint32_t p) const {
        return volume(face.corner[0], face.corner[1], face.corner[2], p);
    }

    // Chooses extreme points, so that the initial solid is large: two distant points, a third off
    // their line, a fourth off their plane.
    bool make_tetrahedron() {
        const auto count = static_cast<std::uint32_t>(points_.size());
        if (count < 4) return false;
        std::uint32_t a = 0, b = 0;
        for (std::uint32_t i = 0; i < count; i++) {
            if (points_[i] < points_[a]) a = i;
            if (points_[b] < points_[i]) b = i;
        }
        if (a == b) return false;
        std::uint32_t c = no_index;
        Wide widest = 0;
        for (std::uint32_t i = 0; i < count; i++) {
            const GridPoint &o = points_[a], &q = points_[b], &r = points_[i];
            const Wide ux = q.x - o.x, uy = q.y - o.y, uz = q.z - o.z;
            const Wide vx = r.x - o.x, vy = r.y - o.y, vz = r.z - o.z;
            // The largest component of the cross product suffices as a measure.
            const auto size = [](Wide w) { return w < 0 ? -w : w; };
            const Wide area = std::max(
                {size(uy * vz - uz * vy), size(uz * vx - ux * vz), size(ux * vy - uy * vx)});
            if (area > widest) {
                widest = area;
                c = i;
            }
        }
        if (c == no_index) return false;
        std::uint32_t d = no_index;
        Wide furthest = 0;
        for (std::uint32_t i = 0; i < count; i++) {
            const Wide v = volume(a, b, c, i), size = v < 0 ? -v : v;
            if (size > furthest) {
                furthest = size;
                d = i;
            }
        }
        if (d == no_index) return false;
        if (volume(a, b, c, d) > 0) std::swap(b, c);  // d is below (a, b, c) now
        ASSERT(volume(a, b, c, d) < 0 && faces_.empty());
        faces_.push_back({.corner = {a, b, c}, .across = {1, 2, 3}, .above = {}});
        faces_.push_back({.corner = {b, a, d}, .across = {0, 3, 2}, .above = {}});
        faces_.push_back({.corner = {c, b, d}, .across = {0, 1, 3}, .above = {}});
        faces_.push_back({.corner = {a, c, d}, .across = {0, 2, 1}, .above = {}});
        for (std::uint32_t i = 0; i < count; i++)
            if (i != a && i != b && i != c && i != d) assign(i, 0);
        return true;
    }

    // Adds the point to the list of the first face, starting at `first`, that it is above. Interior
    // points are dropped.
    void assign(std::uint32_t point, std::size_t first) {
        for (std::size_t f = first; f < faces_.size(); f++)
            if (faces_[f].alive && height(faces_[f], point) > 0) {
                faces_[f].above.push_back(point);
                return;
            }
    }

    std::uint32_t next_open(std::uint32_t from) const {
        for (std::size_t k = 0; k < faces_.size(); k++) {
            const std::size_t f = (from + k) % faces_.size();
            if (faces_[f].alive && !faces_[f].above.empty()) return static_cast<std::uint32_t>(f);
        }
        return no_index;
    }

    struct Rim {
        std::uint32_t from, to;  // counter-clockwise seen from outside, as in the visible face
        std::uint32_t beyond;    // the remaining face
    };

    void add_point(std::uint32_t start) {
        std::uint32_t top = no_index;
        Wide highest = 0;
        for (const std::uint32_t p : faces_[start].above) {
            const Wide h = height(faces_[start], p);
            if (h > highest) {
                highest = h;
                top = p;
            }
        }
        // The visible faces are connected. Exactly coplanar neighbours remain.
        visible_.assign(1, start);
        ASSERT(top != no_index && faces_[start].alive && !faces_[start].seen);
        faces_[start].seen = true;
        for (std::size_t k = 0; k < visible_.size(); k++)
            for (int e = 0; e < 3; e++) {
                const std::uint32_t other = faces_[visible_[k]].across[static_cast<std::size_t>(e)];
                if (faces_[other].seen || height(faces_[other], top) <= 0) continue;
                faces_[other].seen = true;
                visible_.push_back(other);
            }
        rim_.clear();
        for (const std::uint32_t f : visible_)
            for (std::size_t e = 0; e < 3; e++)
                if (!faces_[faces_[f].across[e]].seen)
                    rim_.push_back(
                        {faces_[f].corner[e], faces_[f].corner[(e + 1) % 3], faces_[f].across[e]});
        // Sort the edges around the rim: each edge starts at the end of the previous one.
        for (std::size_t k = 1; k < rim_.size(); k++) {
            std::size_t next = k;
            while (rim_[next].from != rim_[k - 1].to) next++;
            ASSERT(next < rim_.size());
            std::swap(rim_[k], rim_[next]);
        }
        const auto first_new = static_cast<std::uint32_t>(faces_.size());
        const auto count = static_cast<std::uint32_t>(rim_.size());
        ASSERT(count >= 3 && rim_.back().to == rim_.front().from);
        for (std::uint32_t k = 0; k < count; k++) {
            const Rim& r = rim_[k];
            const std::uint32_t previous = first_new + (k + count - 1) % count;
            const std::uint32_t next_face = first_new + (k + 1) % count;
            faces_.push_back({.corner = {r.from, r.to, top},
                              .across = {r.beyond, next_face, previous},
                              .above = {}});
            Face& beyond = faces_[r.beyond];
            for (std::size_t e = 0; e < 3; e++)
                if (beyond.corner[e] == r.to && beyond.corner[(e + 1) % 3] == r.from)
                    beyond.across[e] = first_new + k;
        }
        for (const std::uint32_t f : visible_) {
            faces_[f].alive = false;
            const std::vector<std::uint32_t> orphans = std::move(faces_[f].above);
            faces_[f].above = {};
            for (const std::uint32_t p : orphans)
                if (p != top) assign(p, first_new);
        }
    }

    std::span<const GridPoint> points_;
    std::vector<Face> faces_;
    std::vector<std::uint32_t> visible_;
    std::vector<Rim> rim_;
};

}  // namespace

std::optional<std::vector<HullTriangle>> hull_triangles(std::span<const GridPoint> points) {
    return Builder(points).run();
}

}  // namespace jostle::physics
