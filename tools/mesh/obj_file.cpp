// SPDX-License-Identifier: MIT
#include "tools/mesh/obj_file.h"

#include <charconv>
#include <cmath>

namespace jostle::mesh {
namespace {

using namespace physics;

constexpr std::size_t most = 1000000;

class Reader {
public:
    Status line(std::string_view text) {
        number_++;
        const std::string_view kind = word(text);
        if (kind == "v") return vertex(text);
        if (kind == "f") return face(text);
        return {};
    }
    ObjMesh take() { return std::move(mesh_); }

private:
    Error fault(const std::string& what) const {
        return {ErrorCode::invalid_argument, "line " + std::to_string(number_) + ": " + what};
    }
    static std::string_view word(std::string_view& rest) {
        constexpr std::string_view space = " \t\r";
        rest.remove_prefix(std::min(rest.find_first_not_of(space), rest.size()));
        const std::size_t end = std::min(rest.find_first_of(space), rest.size());
        const std::string_view found = rest.substr(0, end);
        rest.remove_prefix(end);
        return found;
    }
    template <class Number>
    static bool read(std::string_view text, Number& to) {
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, to);
        return error == std::errc{} && stop == end;
    }

    Status vertex(std::string_view rest) {
        double x[3] = {};
        for (double& one : x) {
            const std::string_view text = word(rest);
            if (!read(text, one) || !std::isfinite(one))
                return fault("\"" + std::string(text) +
                             "\" is not a finite number; a vertex needs three coordinates");
        }
        if (mesh_.vertices.size() >= most) return fault("more than 1000000 vertices");
        mesh_.vertices.push_back({x[0], x[1], x[2]});
        return {};
    }
    // A corner: "7", "7/2", "7/2/5" or "7//5"; negative indices count from the last vertex.
    Status face(std::string_view rest) {
        std::vector<std::uint32_t> corners;
        for (std::string_view text = word(rest); !text.empty(); text = word(rest)) {
            std::int64_t index = 0;
            const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
            if (!read(text.substr(0, text.find('/')), index))
                return fault(
                    "\"" + std::string(text) +
                    "\" is not a corner of a face; use INDEX, INDEX/UV or INDEX/UV/NORMAL");
            const std::int64_t at = index < 0 ? count + index : index - 1;
            if (at < 0 || at >= count)
                return fault("vertex index " + std::to_string(index) +
                             " is out of range; there are " + std::to_string(count) +
                             " vertices up to this line");
            corners.push_back(static_cast<std::uint32_t>(at));
        }
        if (corners.size() < 3) return fault("a face needs at least three corners");
        for (std::size_t k = 1; k + 1 < corners.size(); k++)
            mesh_.indices.insert(mesh_.indices.end(), {corners[0], corners[k], corners[k + 1]});
        if (mesh_.indices.size() > 3 * most) return fault("more than 1000000 triangles");
        return {};
    }

    ObjMesh mesh_;
    int number_ = 0;
};

}  // namespace

Result<ObjMesh> read_obj(std::string_view text) {
    Reader reader;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (Status s = reader.line(text.substr(0, end)); !s.ok()) return s.error();
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    ObjMesh mesh = reader.take();
    if (mesh.indices.empty())
        return Error{ErrorCode::invalid_argument,
                     "the file has no faces (lines such as \"f 1 2 3\")"};
    return mesh;
}

}  // namespace jostle::mesh
