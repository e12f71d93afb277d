// SPDX-License-Identifier: MIT
#include "modules/ragdoll/gltf/src/skeleton.h"

#include <algorithm>

#include "jostle/physics/quat.h"

namespace jostle::modules::gltf {

using namespace physics;

namespace {

constexpr std::size_t no_joint = static_cast<std::size_t>(-1);
constexpr double coordinate_max = 1e9;  // units: positions beyond it are invalid

struct Node {
    std::size_t parent = no_joint;
    Affine local, world;
    bool placed = false;
};

bool is_near(const Affine& m) {
    for (const Vec3 v : {m.linear.x, m.linear.y, m.linear.z, m.shift})
        if (!(length(v) < coordinate_max)) return false;
    return true;
}

// From the columns of a 4 x 4 matrix whose last row is 0 0 0 1.
Affine affine_of(const double* m) {
    return {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}, {m[12], m[13], m[14]}};
}

Result<Affine> local_of(const JsonNode& node) {
    if (const JsonNode matrix = node.at("matrix"); matrix.exists()) {
        const Result<std::vector<double>> m = File::numbers(matrix, 16);
        if (!m.ok()) return m.error();
        return affine_of(m->data());
    }
    std::vector<double> shift{0, 0, 0}, turn{0, 0, 0, 1}, scale{1, 1, 1};
    for (const auto& [name, values] :
         {std::pair{"translation", &shift}, {"rotation", &turn}, {"scale", &scale}}) {
        const JsonNode property = node.at(name);
        if (!property.exists()) continue;
        Result<std::vector<double>> read = File::numbers(property, values->size());
        if (!read.ok()) return read.error();
        *values = *read;
    }
    const Quat q{turn[0], turn[1], turn[2], turn[3]};
    if (!(norm_squared(q) > 0.9 && norm_squared(q) < 1.1))
        return node.at("rotation").make_error("is not a unit quaternion");
    const Mat3 m = to_matrix(normalized(q));
    return Affine{{m.x * scale[0], m.y * scale[1], m.z * scale[2]}, {shift[0], shift[1], shift[2]}};
}

// Each node has at most one parent, and no node is its own descendant.
Result<std::vector<Node>> read_nodes(const File& file) {
    const Result<JsonNode> list = file.array("nodes");
    if (!list.ok()) return list.error();
    std::vector<Node> nodes(list->size());
    for (std::size_t k = 0; k < nodes.size(); k++) {
        const Result<Affine> local = local_of(list->at(k));
        if (!local.ok()) return local.error();
        nodes[k].local = *local;
        const JsonNode children = list->at(k).at("children");
        for (std::size_t c = 0; c < children.size(); c++) {
            const Result<std::size_t> child = File::index(children.at(c), nodes.size(), "nodes");
            if (!child.ok()) return child.error();
            if (nodes[*child].parent != no_joint)
                return children.at(c).make_error("is already a child of nodes[" +
                                                 std::to_string(nodes[*child].parent) + "]");
            nodes[*child].parent = k;
        }
    }
    std::vector<std::size_t> chain;
    for (std::size_t k = 0; k < nodes.size(); k++) {
        chain.clear();
        for (std::size_t at = k; at != no_joint && !nodes[at].placed; at = nodes[at].parent) {
            chain.push_back(at);
            if (chain.size() > nodes.size()) return list->at(k).make_error("is its own descendant");
        }
        for (; !chain.empty(); chain.pop_back()) {
            Node& node = nodes[chain.back()];
            node.world =
                node.parent == no_joint ? node.local : nodes[node.parent].world * node.local;
            if (!is_near(node.world))
                return list->at(chain.back()).make_error("has a position beyond 1e9");
            node.placed = true;
        }
    }
    return nodes;
}

std::string name_of(const JsonNode& node, std::size_t index) {
    const JsonNode name = node.at("name");
    if (name.exists() && name.value->is_string())
        return name.value->get_ref<const std::string&>().substr(0, 200);
    return "node " + std::to_string(index);
}

struct SkinReader {
    const File& file;
    const std::vector<Node>& nodes;
    JsonNode skin;
    std::vector<std::size_t> joint_nodes;  // in the order of the skin
    std::vector<SkeletonJoint> joints;     // parents first
    std::vector<std::size_t> joint_index;  // index in `joints`, in the order of the skin

    Status read_joints() {
        const JsonNode list = skin.at("joints");
        if (list.size() == 0 || list.size() > joints_max)
            return list.make_error("must have 1 to " + std::to_string(joints_max) + " nodes");
        std::vector<std::size_t> of_node(nodes.size(), no_joint);
        for (std::size_t k = 0; k < list.size(); k++) {
            const Result<std::size_t> node = File::index(list.at(k), nodes.size(), "nodes");
            if (!node.ok()) return node.error();
            if (of_node[*node] != no_joint) return list.at(k).make_error("is a duplicate");
            of_node[*node] = k;
            joint_nodes.push_back(*node);
        }
        std::vector<std::size_t> parents;
        for (const std::size_t node : joint_nodes) {
            std::size_t above = nodes[node].parent;
            while (above != no_joint && of_node[above] == no_joint) above = nodes[above].parent;
            parents.push_back(above == no_joint ? no_joint : of_node[above]);
        }
        return sort(parents);
    }

    // Breadth-first, siblings in the order of the skin.
    Status sort(const std::vector<std::size_t>& parents) {
        joint_index.assign(parents.size(), no_joint);
        std::vector<std::vector<std::size_t>> children(parents.size());
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < parents.size(); k++)
            (parents[k] == no_joint ? order : children[parents[k]]).push_back(k);
        if (order.size() != 1)
            return skin.at("joints").make_error("has " + std::to_string(order.size()) +
                                                " roots; it must have exactly one");
        for (std::size_t k = 0; k < order.size(); k++)
            order.insert(order.end(), children[order[k]].begin(), children[order[k]].end());
        for (const std::size_t k : order) {
            joint_index[k] = joints.size();
            const std::size_t node = joint_nodes[k];
            joints.push_back(
                {.node = node,
                 .name = name_of(file.root().at("nodes").at(node), node),
                 .parent = parents[k] == no_joint ? -1 : static_cast<int>(joint_index[parents[k]]),
                 .world = nodes[node].world});
        }
        return {};
    }

    // Per joint in the order of the skin: the transform from mesh points to the scene. It is the
    // inverse bind matrix followed by the transform of the joint.
    Result<std::vector<Affine>> binds() const {
        std::vector<Affine> result;
        for (const std::size_t node : joint_nodes) result.push_back(nodes[node].world);
        const JsonNode property = skin.at("inverseBindMatrices");
        if (!property.exists()) return result;
        const Result<AccessorData> matrices = file.accessor(property, "MAT4");
        if (!matrices.ok()) return matrices.error();
        if (matrices->count() < result.size())
            return property.make_error("has " + std::to_string(matrices->count()) +
                                       " matrices for " + std::to_string(result.size()) +
                                       " joints");
        for (std::size_t k = 0; k < result.size(); k++)
            result[k] = result[k] * affine_of((*matrices)[k]);
        return result;
    }

    Status read_points(std::size_t index) {
        const Result<std::vector<Affine>> to_scene = binds();
        if (!to_scene.ok()) return to_scene.error();
        const Result<JsonNode> meshes = file.array("meshes");
        if (!meshes.ok()) return meshes.error();
        std::size_t points = 0, all = 0;
        const JsonNode list = file.root().at("nodes");
        for (std::size_t k = 0; k < list.size(); k++) {
            const JsonNode of_skin = list.at(k).at("skin"), of_mesh = list.at(k).at("mesh");
            if (!of_skin.exists() || !of_mesh.exists() || *of_skin.value != index) continue;
            const Result<std::size_t> mesh = File::index(of_mesh, meshes->size(), "meshes");
            if (!mesh.ok()) return mesh.error();
            const JsonNode primitives = meshes->at(*mesh).at("primitives");
            all += primitives.size();
            if (all > elements_max)
                return primitives.make_error(
                    "has too many elements; the meshes of a skin may have at most " +
                    std::to_string(elements_max) + " primitives in total");
            for (std::size_t p = 0; p < primitives.size(); p++)
                if (Status s = read_primitive(primitives.at(p).at("attributes"), *to_scene, points);
                    !s.ok())
                    return s;
        }
        return {};
    }

    Status read_primitive(const JsonNode& attributes, const std::vector<Affine>& to_scene,
                          std::size_t& points) {
        const JsonNode joints_at = attributes.at("JOINTS_0"),
                       weights_at = attributes.at("WEIGHTS_0");
        if (!joints_at.exists() || !weights_at.exists()) return {};
        const Result<AccessorData> position = file.accessor(attributes.at("POSITION"), "VEC3"),
                                   joint = file.accessor(joints_at, "VEC4"),
                                   weight = file.accessor(weights_at, "VEC4");
        for (const auto* numbers : {&position, &joint, &weight})
            if (!numbers->ok()) return numbers->error();
        if (joint->count() != position->count() || weight->count() != position->count())
            return attributes.make_error("has attributes of different counts");
        points += position->count();
        if (points > points_max)
            return attributes.make_error("has more points than " + std::to_string(points_max));
        for (std::size_t k = 0; k < position->count(); k++) {
            const double *const w = (*weight)[k], *const j = (*joint)[k], *const x = (*position)[k];
            const auto most = static_cast<std::size_t>(std::max_element(w, w + 4) - w);
            if (!(j[most] >= 0 && j[most] < static_cast<double>(to_scene.size())))
                return joints_at.make_error("refers to a joint that the skin does not have");
            const auto at = static_cast<std::size_t>(j[most]);
            const Vec3 position_in_scene = gltf::apply(to_scene[at], {x[0], x[1], x[2]});
            if (!(length(position_in_scene) < coordinate_max))
                return attributes.at("POSITION").make_error("has a position beyond 1e9");
            joints[joint_index[at]].points.push_back(position_in_scene);
        }
        return {};
    }
};

}  // namespace

Vec3 apply(const Affine& m, Vec3 v) {
    return m.linear * v + m.shift;
}
Affine operator*(const Affine& a, const Affine& b) {
    return {a.linear * b.linear, apply(a, b.shift)};
}

Result<std::vector<SkeletonJoint>> read_skeleton(const File& file, std::size_t skin) {
    const Result<JsonNode> skins = file.array("skins");
    if (!skins.ok()) return skins.error();
    if (skin >= skins->size())
        return skins->make_error("has no element " + std::to_string(skin) + "; it has " +
                                 std::to_string(skins->size()) + " elements");
    const Result<std::vector<Node>> nodes = read_nodes(file);
    if (!nodes.ok()) return nodes.error();
    SkinReader reader{file, *nodes, skins->at(skin), {}, {}, {}};
    if (Status s = reader.read_joints(); !s.ok()) return s.error();
    if (Status s = reader.read_points(skin); !s.ok()) return s.error();
    return std::move(reader.joints);
}

}  // namespace jostle::modules::gltf
