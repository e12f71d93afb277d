// SPDX-License-Identifier: MIT
#include "physics/src/serialization/shared_geometry.h"

#include <cmath>

#include "physics/src/geometry/hull_builder.h"

namespace jostle::physics {
namespace {

// ---- writing ----

void write(ByteWriter& out, Vec3 v) {
    out.write(v.x);
    out.write(v.y);
    out.write(v.z);
}
void write_count(ByteWriter& out, std::size_t count) {
    out.write(static_cast<std::uint64_t>(count));
}

void write_entry(ByteWriter& out, const ConvexHull& hull) {
    write_count(out, hull.vertices.size());
    for (const Vec3 v : hull.vertices) write(out, v);
    write_count(out, hull.faces.size());
    for (const HullFace& face : hull.faces) {
        write_count(out, face.count);
        for (const std::uint16_t v : hull.vertices_of(face)) out.write(v);
    }
}
void write_entry(ByteWriter& out, const TriangleMesh& mesh) {
    write_count(out, mesh.vertices.size());
    for (const Vec3 v : mesh.vertices) write(out, v);
    write_count(out, mesh.triangles.size());
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t corner : t) out.write(corner);
}
void write_entry(ByteWriter& out, const HeightGrid& grid) {
    out.write(grid.columns);
    out.write(grid.rows);
    out.write(grid.spacing_x);
    out.write(grid.spacing_z);
    write_count(out, grid.heights.size());
    for (const double h : grid.heights) out.write(h);
    write_count(out, grid.holes.size());
    for (const std::uint8_t hole : grid.holes) out.write(hole);
}

// ---- reading ----

class Source {
public:
    explicit Source(ByteReader& in) : in_(in) {}

    template <class T>
    T number() {
        const auto bits = in_.read_bits<T>();
        if (in_.failed()) failed_ = true;
        return std::bit_cast<T>(bits);
    }
    Vec3 vec() {
        const double x = number<double>(), y = number<double>(), z = number<double>();
        return {x, y, z};
    }
    // An array cannot be longer than the remaining bytes.
    std::size_t count(std::size_t bytes_each) {
        const auto n = number<std::uint64_t>();
        if (failed_ || n > in_.left() / bytes_each) {
            failed_ = true;
            return 0;
        }
        return static_cast<std::size_t>(n);
    }
    bool failed() const { return failed_; }
    void fail() { failed_ = true; }

private:
    ByteReader& in_;
    bool failed_ = false;
};

Error cut_short() {
    return {ErrorCode::corrupt_data, "the data ends early or contains an invalid number"};
}

Result<std::shared_ptr<const ConvexHull>> read_hull(Source& in) {
    std::vector<Vec3> vertices(in.count(24));
    for (Vec3& v : vertices) {
        v = in.vec();
        if (!is_finite(v)) in.fail();
    }
    std::vector<std::vector<std::uint16_t>> faces(in.count(8));
    for (auto& face : faces) {
        face.resize(in.count(2));
        for (std::uint16_t& v : face) {
            v = in.number<std::uint16_t>();
            if (v >= vertices.size()) in.fail();
        }
        if (face.size() < 3 || face.size() > max_face_vertices) in.fail();
        if (in.failed()) return cut_short();
    }
    if (in.failed() || vertices.size() < 4 || vertices.size() > max_hull_vertices)
        return cut_short();
    return assemble_hull(std::move(vertices), faces);
}

Result<std::shared_ptr<const TriangleMesh>> read_mesh(Source& in) {
    std::vector<Vec3> vertices(in.count(24));
    for (Vec3& v : vertices) v = in.vec();
    std::vector<std::array<std::uint32_t, 3>> triangles(in.count(12));
    for (auto& t : triangles)
        for (std::uint32_t& corner : t) corner = in.number<std::uint32_t>();
    if (in.failed()) return cut_short();
    return build_mesh(vertices, triangles);
}

Result<std::shared_ptr<const HeightGrid>> read_height_field(Source& in) {
    HeightGrid grid;
    grid.columns = in.number<std::uint32_t>();
    grid.rows = in.number<std::uint32_t>();
    grid.spacing_x = in.number<double>();
    grid.spacing_z = in.number<double>();
    grid.heights.resize(in.count(8));
    for (double& h : grid.heights) h = in.number<double>();
    grid.holes.resize(in.count(1));
    for (std::uint8_t& hole : grid.holes) hole = in.number<std::uint8_t>();
    if (in.failed()) return cut_short();
    return build_height_field(std::move(grid));
}

}  // namespace

void SharedGeometry::put(const void* data, Entry entry) {
    if (!indices_.emplace(data, static_cast<std::uint32_t>(entries_.size())).second) return;
    entries_.push_back(std::move(entry));
}

void SharedGeometry::add(const Geometry& geometry) {
    if (const auto* hull = std::get_if<Hull>(&geometry)) put(hull->data.get(), hull->data);
    if (const auto* mesh = std::get_if<Mesh>(&geometry)) put(mesh->data.get(), mesh->data);
    if (const auto* field = std::get_if<HeightField>(&geometry))
        put(field->data.get(), field->data);
    if (const auto* compound = std::get_if<Compound>(&geometry)) {
        for (const CompoundChild& child : compound->data->children) add(child.geometry);
        put(compound->data.get(), compound->data);
    }
}

void SharedGeometry::collect(const ShapeStore& store) {
    for (std::uint32_t s = 0; s < store.ids.size(); s++)
        if (store.ids.alive(s)) add(store.shapes[s].geometry);
}

namespace {

void write_child(ByteWriter& out, const CompoundChild& child, const SharedGeometry& table) {
    const Geometry& g = child.geometry;
    out.write(static_cast<std::uint8_t>(g.index()));
    double sizes[3] = {};
    if (const auto* s = std::get_if<Sphere>(&g)) sizes[0] = s->radius;
    if (const auto* c = std::get_if<Capsule>(&g)) sizes[0] = c->radius, sizes[1] = c->half_length;
    if (const auto* c = std::get_if<Cylinder>(&g)) sizes[0] = c->radius, sizes[1] = c->half_length;
    if (const auto* c = std::get_if<Cone>(&g)) sizes[0] = c->radius, sizes[1] = c->half_length;
    if (const auto* b = std::get_if<Box>(&g))
        for (int k = 0; k < 3; k++) sizes[k] = b->half_extents[k];
    if (const auto* h = std::get_if<Hull>(&g)) sizes[0] = table.index_of(h->data);
    for (const double size : sizes) out.write(size);
    write(out, child.pose.position);
    const Quat q = child.pose.rotation;
    for (const double x : {q.x, q.y, q.z, q.w}) out.write(x);
}

Result<std::shared_ptr<const CompoundShape>> read_compound(Source& in,
                                                           const SharedGeometry& table) {
    std::vector<CompoundChild> children(in.count(1 + 24 + 24 + 32));
    for (CompoundChild& child : children) {
        const auto kind = static_cast<ShapeKind>(in.number<std::uint8_t>());
        const Vec3 size = in.vec();
        switch (kind) {
            case ShapeKind::sphere:
                child.geometry = Sphere{size.x};
                break;
            case ShapeKind::capsule:
                child.geometry = Capsule{size.x, size.y};
                break;
            case ShapeKind::box:
                child.geometry = Box{size};
                break;
            case ShapeKind::cylinder:
                child.geometry = Cylinder{size.x, size.y};
                break;
            case ShapeKind::cone:
                child.geometry = Cone{size.x, size.y};
                break;
            case ShapeKind::hull: {
                const double index = size.x >= 0 && size.x < 4e9 ? size.x : 4e9;
                child.geometry = Hull{table.at<ConvexHull>(static_cast<std::uint32_t>(index))};
                break;
            }
            default:
                return Error{ErrorCode::corrupt_data,
                             "the kind of a child is unknown or not convex"};
        }
        child.pose.position = in.vec();
        Quat& q = child.pose.rotation;
        for (double* x : {&q.x, &q.y, &q.z, &q.w}) *x = in.number<double>();
    }
    if (in.failed()) return cut_short();
    return build_compound(std::move(children));
}

}  // namespace

void SharedGeometry::write(ByteWriter& out) const {
    write_count(out, entries_.size());
    for (const Entry& entry : entries_) {
        out.write(static_cast<std::uint8_t>(entry.index()));
        if (const auto* hull = std::get_if<0>(&entry)) write_entry(out, **hull);
        if (const auto* mesh = std::get_if<1>(&entry)) write_entry(out, **mesh);
        if (const auto* grid = std::get_if<2>(&entry)) write_entry(out, **grid);
        if (const auto* compound = std::get_if<3>(&entry)) {
            write_count(out, (*compound)->children.size());
            for (const CompoundChild& child : (*compound)->children) write_child(out, child, *this);
        }
    }
}

std::optional<std::string> SharedGeometry::read(ByteReader& reader) {
    Source in(reader);
    const std::size_t count = in.count(9);
    for (std::size_t k = 0; k < count; k++) {
        const std::string name = "geometry[" + std::to_string(k) + "]: ";
        const auto kind = in.number<std::uint8_t>();
        std::optional<std::string> fault;
        const auto add_entry = [&](auto built) {
            if (built.ok())
                entries_.push_back(*built);
            else
                fault = name + built.error().message;
        };
        switch (kind) {
            case 0:
                add_entry(read_hull(in));
                break;
            case 1:
                add_entry(read_mesh(in));
                break;
            case 2:
                add_entry(read_height_field(in));
                break;
            case 3:
                add_entry(read_compound(in, *this));
                break;
            default:
                return name + "has an unknown kind";
        }
        if (fault) return fault;
    }
    if (in.failed()) return "geometry: the data ends early";
    return std::nullopt;
}

}  // namespace jostle::physics
