// SPDX-License-Identifier: MIT
#include "jostle/modules/user_field.h"

#include <map>
#include <mutex>
#include <utility>

namespace jostle::modules {

using namespace physics;

namespace {

struct Registry {
    std::mutex lock;
    std::map<std::string, std::shared_ptr<const UserForce>, std::less<>> laws;
};

Registry& registry() {
    static Registry all;
    return all;
}

bool is_name(std::string_view name) {
    if (name.empty() || name.size() > 32) return false;
    for (const char c : name)
        if (!((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_')) return false;
    return true;
}

}  // namespace

Status register_user_field(std::string law, UserForce force) {
    if (!is_name(law))
        return invalid_argument("law is \"" + law + "\"; it must be 1 to 32 of a-z, 0-9 and _");
    if (!force) return invalid_argument("force of \"" + law + "\" is empty; it must be a function");
    Registry& all = registry();
    const std::lock_guard guard(all.lock);
    auto shared = std::make_shared<const UserForce>(std::move(force));
    if (all.laws.emplace(law, std::move(shared)).second) return {};
    return Error{ErrorCode::already_exists,
                 "user field \"" + law + "\" is already registered; use another name"};
}

std::shared_ptr<const UserForce> find_user_field(std::string_view law) {
    Registry& all = registry();
    const std::lock_guard guard(all.lock);
    const auto at = all.laws.find(law);
    return at == all.laws.end() ? nullptr : at->second;
}

std::vector<std::string> user_fields() {
    Registry& all = registry();
    const std::lock_guard guard(all.lock);
    std::vector<std::string> names;
    for (const auto& [name, force] : all.laws) names.push_back(name);
    return names;
}

}  // namespace jostle::modules
