// SPDX-License-Identifier: MIT
#include "scenes/src/module_message.h"

#include <algorithm>

#include "jostle/base/nearest_name.h"
#include "jostle/physics/module.h"
#include "jostle/scenes/catalog.h"
#include "jostle/v1/scene.pb.h"
#include "scenes/src/body_name.h"
#include "scenes/src/module_objects.h"

namespace jostle::scenes {

namespace {

constexpr std::size_t setting_name_bytes_max = 64;
constexpr double setting_max = 1e300;

// Such names have one spelling in JSON and contain no character that is special in field paths.
bool is_name(const std::string& text) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    };
    return !text.empty() && text.size() <= setting_name_bytes_max &&
           std::all_of(text.begin(), text.end(), fits);
}

// Maps of messages are unordered: sorts them by name.
template <class Value>
std::map<std::string, Value> read_names(FieldReader& in, const std::string& path,
                                        const google::protobuf::Map<std::string, Value>& given) {
    std::map<std::string, Value> sorted(given.begin(), given.end());
    for (const auto& [name, value] : sorted)
        if (!is_name(name))
            in.report_error(path,
                            "\"" + name.substr(0, setting_name_bytes_max) +
                                "\" is not a valid name; it must be 1 to 64 of a-z, 0-9 and _");
    return sorted;
}

void check_tag(FieldReader& in, const SceneDescription& scene, const std::string& path,
               const std::string& tag) {
    const auto has_it = [&](const SceneModule& module) { return module.tag == tag; };
    if (std::any_of(scene.modules.begin(), scene.modules.end(), has_it))
        in.report_error(path,
                        "is \"" + tag + "\", a duplicate; a world has at most one module per tag");
    register_catalog_modules();
    const std::vector<std::string> known = physics::module_tags();
    if (std::find(known.begin(), known.end(), tag) != known.end()) return;
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
    in.report_error(path, "is \"" + tag + "\"; it must be one of " +
                              (names.empty() ? "none" : names) + did_you_mean(tag, known));
}

// Returns the field that contains the module's objects; null if there is none.
const google::protobuf::FieldDescriptor* objects_field_of(const v1::Module& m) {
    const auto* choice = m.GetDescriptor()->FindOneofByName("objects");
    return m.GetReflection()->GetOneofFieldDescriptor(m, choice);
}

}  // namespace

void read_module(FieldReader& in, SceneDescription& scene, const std::string& path,
                 const v1::Module& m) {
    if (scene.modules.size() == modules_max)
        return in.report_error(
            path, "exceeds the maximum of " + std::to_string(modules_max) + " modules in a scene");
    const google::protobuf::FieldDescriptor* kind = objects_field_of(m);
    const std::string tag = kind && m.tag().empty() ? kind->name() : m.tag();
    if (kind && tag != kind->name())
        in.report_error(path + ".tag", "is \"" + tag + "\", but its objects belong to \"" +
                                           kind->name() + "\"; remove the tag");
    check_tag(in, scene, path + ".tag", tag);
    SceneModule module{.tag = tag, .settings = {}, .bodies = {}, .state = {}};
    if (kind)
        read_module_objects(in, scene, module, path + "." + kind->name(),
                            m.GetReflection()->GetMessage(m, kind));
    for (const auto& [name, number] : read_names(in, path + ".settings", m.settings()))
        module.settings[name] =
            in.number(path + ".settings." + name, number, -setting_max, setting_max);
    for (const auto& [name, body] : read_names(in, path + ".bodies", m.bodies()))
        module.bodies[name] = find_body(in, scene, path + ".bodies." + name, body);
    const auto* state = reinterpret_cast<const std::byte*>(m.state().data());
    module.state.assign(state, state + m.state().size());
    scene.modules.push_back(std::move(module));
}

void write_module(v1::Module& out, const SceneDescription& scene, const SceneModule& module) {
    out.set_tag(module.tag);
    for (const auto& [name, number] : module.settings) (*out.mutable_settings())[name] = number;
    for (const auto& [name, body] : module.bodies)
        (*out.mutable_bodies())[name] = name_of(scene, body);
    const auto* kind = out.GetDescriptor()->FindFieldByName(module.tag);
    if (kind && kind->containing_oneof() && !module.objects.empty())
        write_module_objects(*out.GetReflection()->MutableMessage(&out, kind), scene, module);
    out.set_state(module.state.data(), module.state.size());
}

}  // namespace jostle::scenes
