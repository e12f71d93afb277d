// SPDX-License-Identifier: MIT
#include "scenes/src/body_name.h"

#include <charconv>

namespace jostle::scenes {

std::size_t find_body(FieldReader& in, const SceneDescription& scene, const std::string& path,
                      const std::string& text) {
    std::string name = text;
    std::size_t which = 0;
    if (const std::size_t open = text.rfind('[');
        open != std::string::npos && !text.empty() && text.back() == ']') {
        const char *first = text.data() + open + 1, *last = text.data() + text.size() - 1;
        const auto [end, error] = std::from_chars(first, last, which);
        if (error != std::errc{} || end != last || first == last) {
            in.report_error(path, "is \"" + text + "\"; it must be name[index], counting from 0");
            return 0;
        }
        name = text.substr(0, open);
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); i++)
        if (scene.bodies[i].name == name && count++ == which) return i;
    in.report_error(path, count == 0
                              ? "is \"" + text + "\"; no body has the name \"" + name + "\""
                              : "is \"" + text + "\"; there are only " + std::to_string(count) +
                                    " bodies named \"" + name + "\"");
    return 0;
}

std::string name_of(const SceneDescription& scene, std::size_t body) {
    const std::string& name = scene.bodies[body].name;
    std::size_t before = 0;
    for (std::size_t i = 0; i < body; i++) before += scene.bodies[i].name == name ? 1 : 0;
    return before == 0 ? name : name + "[" + std::to_string(before) + "]";
}

}  // namespace jostle::scenes
