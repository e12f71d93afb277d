// SPDX-License-Identifier: MIT
//
// A skeleton as exported by a modelling program: seven joints with a tube around each, in a file
// that tests can modify.
#pragma once

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "jostle/base/base64.h"
#include "jostle/modules/ragdoll_gltf.h"

namespace jostle::modules {

inline std::vector<std::byte> bytes_of(const std::string& text) {
    const auto* from = reinterpret_cast<const std::byte*>(text.data());
    return {from, from + text.size()};
}

// hips (1 m high) - spine - head, and two legs of thigh and shin. The root node above is rotated
// and in centimetres, as is common for exporters: its z axis is up.
class GltfSkeleton {
public:
    nlohmann::json json;
    std::string buffer;

    GltfSkeleton() {
        json = {{"asset", {{"version", "2.0"}}}, {"nodes", nlohmann::json::array()}};
        const double s = std::sqrt(0.5);
        node("armature", {0, 0, 0}, {1, 2, 8});
        json["nodes"][0]["rotation"] = {-s, 0, 0, s};
        json["nodes"][0]["scale"] = {0.01, 0.01, 0.01};
        joint("hips", {0, 0, 100}, {2, 4, 6}, {0, 0, 20}, 12);
        json["nodes"][0]["children"] = {1, 8};
        joint("spine", {0, 0, 20}, {3}, {0, 0, 40}, 15);
        joint("head", {0, 0, 40}, {}, {0, 0, 20}, 9);
        joint("left thigh", {10, 0, 0}, {5}, {0, 0, -45}, 8);
        joint("left shin", {0, 0, -45}, {}, {0, 0, -50}, 6);
        joint("right thigh", {-10, 0, 0}, {7}, {0, 0, -45}, 8);
        joint("right shin", {0, 0, -45}, {}, {0, 0, -50}, 6);
        json["nodes"].push_back({{"name", "body"}, {"mesh", 0}, {"skin", 0}});
        write_mesh();
    }

    std::vector<std::byte> gltf() const {
        nlohmann::json all = json;
        all["buffers"] = {
            {{"byteLength", buffer.size()},
             {"uri", "data:application/octet-stream;base64," + encode_base64(bytes_of(buffer))}}};
        return bytes_of(all.dump());
    }
    std::vector<std::byte> glb() const {
        nlohmann::json all = json;
        all["buffers"] = {{{"byteLength", buffer.size()}}};
        std::string text = all.dump(), body;
        while (text.size() % 4 != 0) text += ' ';
        append(body, static_cast<std::uint32_t>(text.size()));
        body += "JSON" + text;
        append(body, static_cast<std::uint32_t>(buffer.size()));
        body += std::string("BIN\0", 4) + buffer;
        std::string head = "glTF";
        append(head, std::uint32_t{2});
        append(head, static_cast<std::uint32_t>(12 + body.size()));
        return bytes_of(head + body);
    }
    std::vector<std::byte> with_external_buffer() const {
        nlohmann::json all = json;
        all["buffers"] = {{{"byteLength", buffer.size()}, {"uri", "skeleton.bin"}}};
        return bytes_of(all.dump());
    }

private:
    struct Tube {
        physics::Vec3 from, extent;
        double radius;
    };
    std::vector<Tube> tubes_;            // by joint, in mesh space: centimetres, z up
    std::vector<physics::Vec3> places_;  // of joints in mesh space

    template <class T>
    static void append(std::string& to, T value) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        to.append(bytes, sizeof value);
    }

    void node(const char* name, physics::Vec3 at, const std::vector<int>& children) {
        json["nodes"].push_back({{"name", name}, {"translation", {at.x, at.y, at.z}}});
        if (!children.empty()) json["nodes"].back()["children"] = children;
    }
    void joint(const char* name, physics::Vec3 at, const std::vector<int>& children,
               physics::Vec3 extent, double radius) {
        const int index = static_cast<int>(json["nodes"].size());
        node(name, at, children);
        physics::Vec3 above;
        for (int k = 1; k < index; k++)
            for (const auto& child : json["nodes"][static_cast<std::size_t>(k)].value(
                     "children", nlohmann::json::array()))
                if (child == index) above = places_[static_cast<std::size_t>(k - 1)];
        places_.push_back(above + at);
        tubes_.push_back({places_.back(), extent, radius});
    }

    std::size_t view(std::size_t begin) {
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", buffer.size() - begin}});
        return json["bufferViews"].size() - 1;
    }
    void accessor(std::size_t begin, int component, std::size_t count, const char* type) {
        const std::size_t of = view(begin);
        json["accessors"].push_back(
            {{"bufferView", of}, {"componentType", component}, {"count", count}, {"type", type}});
    }

    void write_mesh() {
        const std::size_t rings = 9, sides = 12, count = tubes_.size() * rings * sides;
        std::size_t begin = 0;
        for (const Tube& tube : tubes_)
            for (std::size_t r = 0; r < rings; r++)
                for (std::size_t k = 0; k < sides; k++) {
                    const double turn = 2 * physics::pi * static_cast<double>(k) / 12;
                    const physics::Vec3 v =
                        tube.from + tube.extent * (static_cast<double>(r) / 8) +
                        physics::Vec3{std::cos(turn), std::sin(turn), 0} * tube.radius;
                    for (const double x : {v.x, v.y, v.z}) append(buffer, static_cast<float>(x));
                }
        accessor(begin, 5126, count, "VEC3");
        begin = buffer.size();
        for (std::size_t k = 0; k < count; k++)
            for (const std::size_t j :
                 {k / (rings * sides), std::size_t{0}, std::size_t{0}, std::size_t{0}})
                append(buffer, static_cast<std::uint8_t>(j));
        accessor(begin, 5121, count, "VEC4");
        begin = buffer.size();
        for (std::size_t k = 0; k < count; k++)
            for (const int weight : {65535, 0, 0, 0})
                append(buffer, static_cast<std::uint16_t>(weight));
        accessor(begin, 5123, count, "VEC4");
        json["accessors"].back()["normalized"] = true;
        begin = buffer.size();
        for (const physics::Vec3 position : places_)
            for (int k = 0; k < 16; k++)
                append(buffer, static_cast<float>(k % 5 == 0 ? 1
                                                  : k == 12  ? -position.x
                                                  : k == 13  ? -position.y
                                                  : k == 14  ? -position.z
                                                             : 0));
        accessor(begin, 5126, places_.size(), "MAT4");
        json["meshes"] = {
            {{"primitives",
              {{{"attributes", {{"POSITION", 0}, {"JOINTS_0", 1}, {"WEIGHTS_0", 2}}}}}}}};
        json["skins"] = {{{"joints", {1, 2, 3, 4, 5, 6, 7}}, {"inverseBindMatrices", 3}}};
    }
};

}  // namespace jostle::modules
