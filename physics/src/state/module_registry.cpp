// SPDX-License-Identifier: MIT
#include "physics/src/state/module_registry.h"

#include <algorithm>
#include <map>

#include "jostle/physics/module.h"
#include "physics/src/foundation/threads.h"

namespace jostle::physics {
namespace {

struct Registry {
    Mutex mutex;
    std::map<std::string, MakeModule, std::less<>> kinds;
};

Registry& registry() {
    static Registry instance;
    return instance;
}

constexpr std::size_t longest_tag = 32;

bool is_tag(std::string_view tag) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    };
    return !tag.empty() && tag.size() <= longest_tag && std::all_of(tag.begin(), tag.end(), fits);
}

}  // namespace

Status check_module_tag(std::string_view tag) {
    if (is_tag(tag)) return {};
    return Error{ErrorCode::invalid_argument,
                 "the module's tag is \"" + std::string(tag) +
                     "\"; it must be 1 to 32 characters of a-z, 0-9 and _"};
}

Status register_module(std::string tag, MakeModule make) {
    if (Status s = check_module_tag(tag); !s.ok()) return s;
    if (!make)
        return Error{
            ErrorCode::invalid_argument,
            "module \"" + tag + "\": make is empty; pass a function that creates the module"};
    Registry& known = registry();
    const MutexLock lock(known.mutex);
    const std::string name = tag;
    if (!known.kinds.emplace(std::move(tag), std::move(make)).second)
        return Error{ErrorCode::failed_precondition,
                     "module \"" + name + "\" is registered already; register it once"};
    return {};
}

Result<std::unique_ptr<Module>> make_module(std::string_view tag) {
    Registry& known = registry();
    MakeModule make;
    std::string tags;
    {
        const MutexLock lock(known.mutex);
        if (const auto found = known.kinds.find(tag); found != known.kinds.end())
            make = found->second;
        for (const auto& [name, unused] : known.kinds) tags += (tags.empty() ? "" : ", ") + name;
    }
    const std::string quoted = "module \"" + std::string(tag) + "\"";
    if (!make)
        return Error{ErrorCode::not_found,
                     quoted + " is not registered (" +
                         (tags.empty() ? "no module is" : "registered: " + tags) +
                         "); call register_module() first"};
    std::unique_ptr<Module> module = make();
    if (!module || module->tag() != tag)
        return Error{ErrorCode::failed_precondition,
                     quoted + ": the registered function creates " +
                         (module ? "\"" + std::string(module->tag()) + "\"" : "nothing")};
    return module;
}

std::vector<std::string> module_tags() {
    Registry& known = registry();
    const MutexLock lock(known.mutex);
    std::vector<std::string> tags;
    for (const auto& [tag, unused] : known.kinds) tags.push_back(tag);
    return tags;
}

Status Module::configure(World&, const ModuleSettings& settings) {
    if (settings.numbers.empty() && settings.bodies.empty()) return {};
    const std::string& name =
        settings.numbers.empty() ? settings.bodies.front().first : settings.numbers.front().first;
    return Error{
        ErrorCode::invalid_argument,
        "module \"" + std::string(tag()) + "\" accepts no settings; remove \"" + name + "\""};
}

}  // namespace jostle::physics
