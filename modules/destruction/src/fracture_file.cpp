// SPDX-License-Identifier: MIT
#include "jostle/modules/fracture_file.h"

#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "jostle/physics/scalar.h"
#include "modules/destruction/src/destruction_checks.h"

namespace jostle::modules {

using namespace physics;
using namespace destruction_detail;

namespace {

constexpr char magic[8] = {'J', 'F', 'R', 'A', 'C', 'T', '\r', '\n'};
constexpr std::size_t chunk_bytes_min = 2 + 17 * 8 + 24, bond_bytes = 8 + 14 * 8;
// Relative tolerance between the volume of a rebuilt hull and that of the original cell.
constexpr double volume_slack = 1e-3;
enum Kind : std::uint8_t { box = 0, hull = 1 };

Error damaged(std::string message) {
    return {ErrorCode::invalid_argument, std::move(message)};
}
std::string element_name(const char* list, std::size_t k) {
    return std::string(list) + "[" + std::to_string(k) + "]";
}

// ---- writing ----

class Writer {
public:
    template <class T>
    void bits(T value) {
        for (std::size_t k = 0; k < sizeof value; k++)
            out_.push_back(static_cast<std::byte>(value >> (8 * k)));
    }
    void number(double value) { bits(std::bit_cast<std::uint64_t>(value)); }
    void numbers(Vec3 v) { number(v.x), number(v.y), number(v.z); }
    std::vector<std::byte> take() { return std::move(out_); }

private:
    std::vector<std::byte> out_;
};

Status write_chunk(Writer& out, const FractureChunk& chunk) {
    const auto* as_box = std::get_if<Box>(&chunk.geometry);
    const auto* as_hull = std::get_if<Hull>(&chunk.geometry);
    if (!as_box && !as_hull) return damaged("is neither a box nor a hull");
    out.bits(as_box ? Kind::box : Kind::hull);
    out.bits(static_cast<std::uint8_t>(chunk.anchored));
    out.numbers(chunk.pose.position);
    const Quat q = chunk.pose.rotation;
    out.number(q.x), out.number(q.y), out.number(q.z), out.number(q.w);
    out.number(chunk.volume);
    out.numbers(chunk.center);
    const Mat3& m = chunk.unit_inertia;
    out.numbers({m.x.x, m.y.y, m.z.z});
    out.numbers({m.x.y, m.x.z, m.y.z});
    if (as_box) {
        out.numbers(as_box->half_extents);
        return {};
    }
    out.bits(static_cast<std::uint16_t>(as_hull->data->vertices.size()));
    for (const Vec3 p : as_hull->data->vertices) out.numbers(p);
    return {};
}

void write_bond(Writer& out, const FractureBond& bond) {
    out.bits(bond.a), out.bits(bond.b);
    out.numbers(bond.center), out.numbers(bond.normal), out.numbers(bond.axis);
    out.number(bond.area);
    out.number(bond.moment_u), out.number(bond.moment_v);
    out.number(bond.reach_u), out.number(bond.reach_v);
}

// ---- reading ----

class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : left_(bytes) {}

    // Past the end it returns zeros and ended() is true.
    template <class T>
    T bits() {
        T value{};
        if (left_.size() < sizeof value) {
            ended_ = true;
            left_ = {};
            return value;
        }
        for (std::size_t k = 0; k < sizeof value; k++)
            value = static_cast<T>(value | static_cast<T>(left_[k]) << (8 * k));
        left_ = left_.subspan(sizeof value);
        return value;
    }
    double number() { return std::bit_cast<double>(bits<std::uint64_t>()); }
    Vec3 numbers() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    bool ended() const { return ended_; }
    std::size_t left() const { return left_.size(); }

private:
    std::span<const std::byte> left_;
    bool ended_ = false;
};

Result<Geometry> read_geometry(Reader& in, std::uint8_t kind) {
    if (kind == Kind::box) {
        const Vec3 half = in.numbers();
        for (int k = 0; k < 3; k++)
            if (!(half[k] >= min_shape_size && half[k] <= max_shape_size))
                return damaged("half extents are out of range; they must be from 1e-4 to 1e4 m");
        return Geometry{Box{half}};
    }
    const std::size_t count = in.bits<std::uint16_t>();
    if (count < 4 || count > max_hull_vertices)
        return damaged("hull has " + std::to_string(count) + " vertices; it must have 4 to " +
                       std::to_string(max_hull_vertices));
    std::vector<Vec3> points(count);
    for (Vec3& p : points) p = in.numbers();
    if (in.ended()) return damaged("unexpected end of file");
    auto made = build_hull(points);
    if (!made.ok()) return damaged("hull: " + made.error().message);
    return Geometry{Hull{std::move(*made)}};
}

struct Solid {
    double volume = 0;
    Aabb bounds;
};

Solid solid_of(const Geometry& geometry) {
    if (const auto* as_box = std::get_if<Box>(&geometry)) {
        const Vec3 h = as_box->half_extents;
        return {8 * h.x * h.y * h.z, {-h, h}};
    }
    const ConvexHull& data = *std::get<Hull>(geometry).data;
    return {data.volume, data.bounds};
}

// Sylvester's criterion: symmetric, with positive leading minors.
bool is_positive(const Mat3& m) {
    const double second = m.x.x * m.y.y - m.x.y * m.x.y;
    const double third = dot(m.x, cross(m.y, m.z));
    return m.x.x > 0 && second > 0 && third > 0;
}

// Checks that the mass properties of a chunk match its geometry.
Status check_mass(const FractureChunk& chunk) {
    const Solid solid = solid_of(chunk.geometry);
    if (!(absolute(chunk.volume - solid.volume) <= volume_slack * solid.volume))
        return damaged("volume does not match the geometry");
    const Vec3 local = apply_inverse(chunk.pose, chunk.center);
    const double size = length(solid.bounds.high - solid.bounds.low);
    for (int k = 0; k < 3; k++)
        if (!(local[k] >= solid.bounds.low[k] - volume_slack * size &&
              local[k] <= solid.bounds.high[k] + volume_slack * size))
            return damaged("centre of mass is outside the geometry");
    const Mat3& m = chunk.unit_inertia;
    if (!(m.x.x + m.y.y + m.z.z <= 2 * chunk.volume * size * size) || !is_positive(m))
        return damaged("inertia is not possible for a solid of this size");
    return {};
}

Result<FractureChunk> read_chunk(Reader& in) {
    FractureChunk chunk;
    const auto kind = in.bits<std::uint8_t>(), anchored = in.bits<std::uint8_t>();
    if (kind > Kind::hull)
        return damaged("kind is " + std::to_string(kind) + "; it must be 0 (box) or 1 (hull)");
    if (anchored > 1) return damaged("anchored must be 0 or 1");
    chunk.anchored = anchored == 1;
    chunk.pose.position = in.numbers();
    const Vec3 q = in.numbers();
    chunk.pose.rotation = {q.x, q.y, q.z, in.number()};
    chunk.volume = in.number();
    chunk.center = in.numbers();
    const Vec3 on = in.numbers(), off = in.numbers();
    chunk.unit_inertia = {{on.x, off.x, off.y}, {off.x, on.y, off.z}, {off.y, off.z, on.z}};
    const Quat r = chunk.pose.rotation;
    if (!(absolute(r.x * r.x + r.y * r.y + r.z * r.z + r.w * r.w - 1) < 1e-6) ||
        !(length_squared(chunk.pose.position) <= coordinate_max * coordinate_max))
        return damaged("pose must have a unit rotation and a position within 1e5 m");
    Result<Geometry> geometry = read_geometry(in, kind);
    if (!geometry.ok()) return geometry.error();
    if (in.ended()) return damaged("unexpected end of file");
    chunk.geometry = std::move(*geometry);
    if (Status s = check_mass(chunk); !s.ok()) return s.error();
    return chunk;
}

FractureBond read_bond(Reader& in) {
    FractureBond bond;
    bond.a = in.bits<std::uint32_t>(), bond.b = in.bits<std::uint32_t>();
    bond.center = in.numbers(), bond.normal = in.numbers(), bond.axis = in.numbers();
    bond.area = in.number();
    bond.moment_u = in.number(), bond.moment_v = in.number();
    bond.reach_u = in.number(), bond.reach_v = in.number();
    return bond;
}

Status check_head(std::span<const std::byte> bytes) {
    if (bytes.size() > fracture_bytes_max) return damaged("file is larger than 256 MiB");
    if (bytes.size() < fracture_header_bytes + 8 ||
        std::memcmp(bytes.data(), magic, sizeof magic) != 0)
        return damaged("not a fracture file; create one with jostle-mesh fracture");
    Reader head(bytes.subspan(sizeof magic));
    const auto version = head.bits<std::uint32_t>();
    if (version != fracture_version)
        return damaged("unsupported version " + std::to_string(version) +
                       "; this program reads version " + std::to_string(fracture_version) +
                       "; create the file again with jostle-mesh fracture");
    if (head.bits<std::uint64_t>() != fracture_checksum(bytes.subspan(fracture_header_bytes)))
        return damaged("checksum mismatch: the file is corrupt or truncated");
    return {};
}

}  // namespace

std::uint64_t fracture_checksum(std::span<const std::byte> bytes) {
    std::uint64_t sum = 0xcbf29ce484222325u;
    for (const std::byte b : bytes) sum = (sum ^ static_cast<std::uint64_t>(b)) * 0x100000001b3u;
    return sum;
}

Result<std::vector<std::byte>> write_fracture(const FracturedShape& shape) {
    if (Status s = check_shape(shape); !s.ok()) return s.error();
    Writer body;
    body.bits(static_cast<std::uint32_t>(shape.chunks.size()));
    body.bits(static_cast<std::uint32_t>(shape.bonds.size()));
    for (std::size_t k = 0; k < shape.chunks.size(); k++)
        if (Status s = write_chunk(body, shape.chunks[k]); !s.ok())
            return damaged(element_name("chunks", k) + " " + s.error().message);
    for (const FractureBond& bond : shape.bonds) write_bond(body, bond);
    const std::vector<std::byte> rest = body.take();
    Writer out;
    for (const char c : magic) out.bits(static_cast<std::uint8_t>(c));
    out.bits(fracture_version);
    out.bits(fracture_checksum(rest));
    std::vector<std::byte> bytes = out.take();
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return bytes;
}

Result<FracturedShape> read_fracture(std::span<const std::byte> bytes) {
    if (Status s = check_head(bytes); !s.ok()) return s.error();
    Reader in(bytes.subspan(fracture_header_bytes));
    const std::size_t chunks = in.bits<std::uint32_t>(), bonds = in.bits<std::uint32_t>();
    if (chunks < 1 || chunks > chunks_max || bonds > bonds_max ||
        chunks * chunk_bytes_min + bonds * bond_bytes > in.left())
        return damaged("header declares " + std::to_string(chunks) + " chunks and " +
                       std::to_string(bonds) + " bonds, which exceeds the file size or the limits");
    FracturedShape shape;
    for (std::size_t k = 0; k < chunks; k++) {
        Result<FractureChunk> chunk = read_chunk(in);
        if (!chunk.ok()) return damaged(element_name("chunks", k) + ": " + chunk.error().message);
        shape.chunks.push_back(std::move(*chunk));
    }
    for (std::size_t k = 0; k < bonds; k++) {
        shape.bonds.push_back(read_bond(in));
        if (in.ended()) return damaged(element_name("bonds", k) + ": unexpected end of file");
    }
    if (in.left() > 0)
        return damaged(std::to_string(in.left()) + " unexpected bytes at the end of the file");
    if (Status s = check_shape(shape); !s.ok()) return s.error();
    return shape;
}

}  // namespace jostle::modules
