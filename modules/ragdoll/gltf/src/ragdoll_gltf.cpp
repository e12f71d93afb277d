// SPDX-License-Identifier: MIT
#include "jostle/modules/ragdoll_gltf.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "modules/ragdoll/gltf/src/skeleton.h"

namespace jostle::modules {

using namespace physics;
using gltf::SkeletonJoint;

namespace {

constexpr std::size_t bones_max = 256;

// A joint that becomes a bone; in metres.
struct BoneSegment {
    std::size_t joint = 0;
    int parent = -1;
    GltfBoneOptions bone_options = {};
    Vec3 start = {}, end = {};  // of its axis
    std::vector<Vec3> points = {};
    std::vector<std::size_t> children = {};
    std::size_t below = 1;  // number of segments in its subtree, including itself
};

Error invalid(const std::string& what) {
    return {ErrorCode::invalid_argument, what};
}
bool is_within(double x, double low, double high) {
    return x >= low && x <= high;  // false for NaN
}

Status check_bone(const GltfBoneOptions& bone, const std::string& where) {
    if (!is_finite(bone.axis) || !(length(bone.axis) > 1e-6))
        return invalid(where + ".axis must be finite and not zero");
    if (!is_within(bone.swing, 0, pi)) return invalid(where + ".swing must be from 0 to pi");
    if (!(bone.lower >= -pi && bone.lower <= bone.upper && bone.upper <= pi))
        return invalid(where + ": lower and upper must be from -pi to pi, lower <= upper");
    return {};
}
Status check(const GltfFigureOptions& options) {
    if (!is_within(options.scale, 1e-4, 1e4)) return invalid("scale must be from 1e-4 to 1e4 m");
    if (!is_within(options.density, 1e-6, 1e6))
        return invalid("density must be from 1e-6 to 1e6 kg/m^3");
    if (!is_within(options.min_radius, 1e-4, 100))
        return invalid("min_radius must be from 1e-4 to 100 m");
    if (Status s = check_bone(options.default_bone, "default_bone"); !s.ok()) return s;
    for (std::size_t k = 0; k < options.bones.size(); k++)
        if (Status s = check_bone(options.bones[k], "bones[" + std::to_string(k) + "] (" +
                                                        options.bones[k].name + ")");
            !s.ok())
            return s;
    return {};
}

const GltfBoneOptions& bone_options_for(const GltfFigureOptions& options, const std::string& name) {
    for (const GltfBoneOptions& bone : options.bones)
        if (bone.name == name) return bone;
    return options.default_bone;
}

// A merged joint adds its points to the nearest bone above it. So does the tip of a chain, a joint
// without a mesh, which marks the end of its parent.
class BoneBuilder {
public:
    BoneBuilder(const std::vector<SkeletonJoint>& joints, const GltfFigureOptions& options)
        : joints_(joints), options_(options), of_joint_(joints.size()) {
        std::vector<bool> bears(joints.size());
        for (std::size_t k = joints.size(); k-- > 0;) {
            bears[k] = bears[k] || !joints[k].points.empty();
            if (bears[k] && joints[k].parent >= 0)
                bears[static_cast<std::size_t>(joints[k].parent)] = true;
        }
        const bool any = bears.front();  // without a mesh, every joint becomes a bone
        for (std::size_t k = 0; k < joints.size(); k++) add(k, !any || bears[k]);
        for (std::size_t k = pieces.size(); k-- > 1;)
            pieces[static_cast<std::size_t>(pieces[k].parent)].below += pieces[k].below;
        for (std::size_t k = 0; k < pieces.size(); k++) find_end(k);
    }

    std::vector<BoneSegment> pieces;

private:
    Vec3 position_of(std::size_t joint) const {
        return joints_[joint].world.shift * options_.scale;
    }

    void add(std::size_t k, bool bears) {
        const GltfBoneOptions& bone_options = bone_options_for(options_, joints_[k].name);
        const int above =
            joints_[k].parent < 0
                ? -1
                : static_cast<int>(of_joint_[static_cast<std::size_t>(joints_[k].parent)]);
        const bool is_bone = above < 0 || (bears && bone_options.kind != GltfBoneKind::merged);
        of_joint_[k] = is_bone ? pieces.size() : static_cast<std::size_t>(above);
        if (is_bone) {
            if (above >= 0)
                pieces[static_cast<std::size_t>(above)].children.push_back(of_joint_[k]);
            pieces.push_back({.joint = k,
                              .parent = above,
                              .bone_options = bone_options,
                              .start = position_of(k)});
        } else {
            tips_.push_back({of_joint_[k], position_of(k)});
        }
        for (const Vec3 point : joints_[k].points)
            pieces[of_joint_[k]].points.push_back(point * options_.scale);
    }

    // The axis of a bone ends at the child with the largest subtree. Without children, it ends at
    // the tip, or at the extent of the bone's points in the direction from the parent.
    void find_end(std::size_t k) {
        BoneSegment& piece = pieces[k];
        if (!piece.children.empty()) {
            std::size_t most = piece.children.front();
            for (const std::size_t child : piece.children)
                if (pieces[child].below > pieces[most].below) most = child;
            piece.end = pieces[most].start;
            return;
        }
        piece.end = piece.start;
        for (const auto& [owner, tip] : tips_)
            if (owner == k && length(tip - piece.start) > length(piece.end - piece.start))
                piece.end = tip;
        if (length(piece.end - piece.start) >= options_.min_radius) return;
        const Vec3 from =
            piece.parent < 0 ? piece.start : pieces[static_cast<std::size_t>(piece.parent)].start;
        const Vec3 axis_vector = piece.start - from;
        const Vec3 along =
            length(axis_vector) > 1e-9 ? axis_vector * (1 / length(axis_vector)) : Vec3{0, 1, 0};
        double far = piece.points.empty() ? 0.5 * length(axis_vector) : 0;
        for (const Vec3 point : piece.points) far = maximum(far, dot(point - piece.start, along));
        piece.end = piece.start + along * far;
    }

    const std::vector<SkeletonJoint>& joints_;
    const GltfFigureOptions& options_;
    // by joint: its segment, or the segment that it is merged into
    std::vector<std::size_t> of_joint_;
    std::vector<std::pair<std::size_t, Vec3>> tips_;
};

// A unit vector perpendicular to another one, as close to the desired one as possible.
Vec3 across(Vec3 along, Vec3 desired) {
    for (const Vec3 v : {desired, Vec3{0, 0, 1}, Vec3{1, 0, 0}}) {
        const Vec3 rest = v - along * dot(along, v);
        if (length(rest) > 1e-3 * maximum(length(v), 1e-9)) return rest * (1 / length(rest));
    }
    return {0, 1, 0};
}
// The rotation with these orthonormal axes.
Quat rotation_of(const Mat3& m) {
    const double t = m.x.x + m.y.y + m.z.z;
    if (t > 0) return normalized({m.y.z - m.z.y, m.z.x - m.x.z, m.x.y - m.y.x, 1 + t});
    if (m.x.x >= m.y.y && m.x.x >= m.z.z)
        return normalized({1 + m.x.x - m.y.y - m.z.z, m.x.y + m.y.x, m.z.x + m.x.z, m.y.z - m.z.y});
    if (m.y.y >= m.z.z)
        return normalized({m.x.y + m.y.x, 1 + m.y.y - m.x.x - m.z.z, m.y.z + m.z.y, m.z.x - m.x.z});
    return normalized({m.z.x + m.x.z, m.y.z + m.z.y, 1 + m.z.z - m.x.x - m.y.y, m.x.y - m.y.x});
}

// Mean distance of the points from the axis, limited to the radius of a sphere.
double radius_of(const BoneSegment& piece, Vec3 along, double size, double least) {
    double sum = 0;
    for (const Vec3 point : piece.points) {
        const Vec3 arm = point - piece.start;
        sum += length(arm - along * clamp(dot(arm, along), 0, size));
    }
    const double mean =
        piece.points.empty() ? 0.15 * size : sum / static_cast<double>(piece.points.size());
    return maximum(least, minimum(mean, maximum(0.5 * size, least)));
}

RagdollBone bone_of(const BoneSegment& piece, const SkeletonJoint& joint,
                    const GltfFigureOptions& options) {
    const Vec3 axis_vector = piece.end - piece.start;
    const double size = length(axis_vector);
    const Vec3 along = size > 1e-9 ? axis_vector * (1 / size) : Vec3{0, 1, 0};
    const double radius = radius_of(piece, along, size, options.min_radius);
    RagdollBone bone{.name = joint.name, .parent = piece.parent};
    const Vec3 side = across(along, joint.world.linear.x);
    // A capsule lies along y.
    bone.rest = {piece.start + axis_vector * 0.5, rotation_of({side, along, cross(side, along)})};
    bone.shapes.push_back(
        {.geometry = Capsule{radius, maximum(0.5 * size - radius, 2e-4 + 1e-3 * radius)},
         .density = options.density});
    if (piece.parent < 0) return bone;
    const GltfBoneOptions& bone_options = piece.bone_options;
    bone.muscle = bone_options.muscle;
    const JointLimit limit{true, bone_options.lower, bone_options.upper};
    Vec3 x = along, z = side;
    if (bone_options.kind == GltfBoneKind::hinge) {
        const Vec3 axis = joint.world.linear * bone_options.axis;
        z = length(axis) > 1e-12 ? axis * (1 / length(axis)) : side;
        x = across(z, along);
        bone.joint = HingeJoint{.limit = limit};
    } else if (bone_options.kind == GltfBoneKind::cone_twist) {
        bone.joint = ConeTwistJoint{.swing = bone_options.swing, .twist = limit};
    }
    bone.frame = {piece.start, rotation_of({x, cross(z, x), z})};
    return bone;
}

// Reads a buffer file.
Result<std::vector<std::byte>> read_bytes(const std::filesystem::path& path) {
    std::error_code code;
    const auto size = std::filesystem::file_size(path, code);
    if (code) return Error{ErrorCode::not_found, path.string() + " cannot be opened"};
    if (size > gltf::file_bytes_max) return invalid(path.string() + " is larger than 64 MB");
    std::ifstream in(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in.good() && !in.eof())
        return Error{ErrorCode::not_found, path.string() + " cannot be read"};
    const auto* from = reinterpret_cast<const std::byte*>(text.data());
    return std::vector<std::byte>(from, from + text.size());
}

bool is_below(const std::filesystem::path& path) {
    if (path.empty() || path.is_absolute()) return false;
    return std::none_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
}

}  // namespace

Result<GltfFigure> figure_from_gltf(std::span<const std::byte> bytes,
                                    const GltfFigureOptions& options,
                                    const GltfBufferReader& outside) {
    if (Status s = check(options); !s.ok()) return s.error();
    const Result<gltf::File> file = gltf::File::open(bytes, outside);
    if (!file.ok()) return file.error();
    const Result<std::vector<SkeletonJoint>> joints = gltf::read_skeleton(*file, options.skin);
    if (!joints.ok()) return joints.error();
    for (const GltfBoneOptions& bone : options.bones)
        if (std::none_of(joints->begin(), joints->end(),
                         [&](const SkeletonJoint& joint) { return joint.name == bone.name; }))
            return invalid("the skin has no joint \"" + bone.name + "\"");
    const BoneBuilder found(*joints, options);
    if (found.pieces.size() > bones_max)
        return invalid("the skin has " + std::to_string(found.pieces.size()) +
                       " joints with a mesh; a figure has at most " + std::to_string(bones_max) +
                       "; merge some joints");
    GltfFigure figure;
    for (const BoneSegment& piece : found.pieces) {
        const SkeletonJoint& joint = (*joints)[piece.joint];
        figure.def.bones.push_back(bone_of(piece, joint, options));
        figure.nodes.push_back(joint.node);
    }
    return figure;
}

Result<GltfFigure> read_gltf_figure(const std::string& path, const GltfFigureOptions& options) {
    const std::filesystem::path file(path);
    const Result<std::vector<std::byte>> bytes = read_bytes(file);
    if (!bytes.ok()) return bytes.error();
    const auto read_external = [&](const std::string& uri) -> Result<std::vector<std::byte>> {
        if (!is_below(uri)) return invalid("\"" + uri + "\" is not in the folder of the file");
        return read_bytes(file.parent_path() / uri);
    };
    return figure_from_gltf(*bytes, options, read_external);
}

}  // namespace jostle::modules
