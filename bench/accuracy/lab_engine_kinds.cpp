// SPDX-License-Identifier: MIT
#include "accuracy/lab_engine_kinds.h"

namespace jostle::bench::lab {
namespace {

const std::vector<EngineKind>& kinds() {
    static const std::vector<EngineKind> all = {
        {"jostle",
         "double outside, float in the inner loops; sub-steps 8 (default), 1, 4 or 16",
         {"sub8", "sub1", "sub4", "sub16"},
         make_jostle_engine},
    };
    return all;
}

}  // namespace

std::span<const EngineKind> engine_kinds() {
    return kinds();
}

const EngineKind* find_engine_kind(std::string_view name) {
    for (const EngineKind& kind : kinds())
        if (name == kind.name) return &kind;
    return nullptr;
}

}  // namespace jostle::bench::lab
