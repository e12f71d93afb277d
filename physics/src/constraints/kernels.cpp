// SPDX-License-Identifier: MIT
#include "physics/src/constraints/kernels.h"

#include <atomic>
#include <string>
#include <vector>

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

// Without FMA, x86-64 cannot fuse multiply-adds.
#if defined(JOSTLE_ALL_KERNELS) && defined(__x86_64__) && !defined(JOSTLE_UNFUSED)
constexpr bool has_baseline = false;
const Kernels& usual_table() {
    return scalar::table;
}
#else
constexpr bool has_baseline = true;
const Kernels& usual_table() {
    return baseline::table;
}
#endif

#if defined(JOSTLE_ALL_KERNELS) && defined(__x86_64__)
Kernels with_two_blocks(Kernels table) {
    table.solve = avx512_two::solve;
    table.relax = avx512_two::relax;
    table.relax_last = avx512_two::relax_last;
    return table;
}

const Kernels& avx512_table() {
    static const Kernels table = with_two_blocks(avx512::table);
    return table;
}
#endif

const Kernels& table_of(InstructionSet set) {
    switch (set) {
#if defined(JOSTLE_ALL_KERNELS) && defined(__x86_64__)
        case InstructionSet::avx512:
            return avx512_table();
        case InstructionSet::avx2:
            return avx2::table;
#endif
#if defined(JOSTLE_ALL_KERNELS)
        case InstructionSet::scalar:
            return scalar::table;
#endif
        default:
            return usual_table();
    }
}

std::vector<InstructionSet> find_available() {
    std::vector<InstructionSet> sets;
#if defined(JOSTLE_ALL_KERNELS)
    sets.push_back(InstructionSet::scalar);
#endif
    if (has_baseline) sets.push_back(InstructionSet::baseline);
#if defined(JOSTLE_ALL_KERNELS) && defined(__x86_64__)
#if defined(JOSTLE_UNFUSED)
    const bool avx2 = __builtin_cpu_supports("avx2");
#else
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
    if (avx2) sets.push_back(InstructionSet::avx2);
    if (avx2 && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw"))
        sets.push_back(InstructionSet::avx512);
#endif
    return sets;
}

std::atomic<InstructionSet>& in_use() {
    static std::atomic<InstructionSet> set = available_instruction_sets().back();
    return set;
}

}  // namespace

const Kernels& kernels() {
    return table_of(in_use().load(std::memory_order_relaxed));
}

const char* instruction_set_name(InstructionSet set) {
    switch (set) {
        case InstructionSet::scalar:
            return "scalar";
        case InstructionSet::baseline:
            return "baseline";
        case InstructionSet::avx2:
            return "avx2";
        case InstructionSet::avx512:
            return "avx512";
    }
    return "unknown";
}

std::span<const InstructionSet> available_instruction_sets() {
    static const std::vector<InstructionSet> sets = find_available();
    ASSERT(!sets.empty());
    return sets;
}

InstructionSet instruction_set() {
    return in_use().load(std::memory_order_relaxed);
}

Status use_instruction_set(InstructionSet set) {
    std::string names;
    for (const InstructionSet s : available_instruction_sets()) {
        if (s == set) {
            in_use().store(set, std::memory_order_relaxed);
            return {};
        }
        names += std::string(names.empty() ? "" : ", ") + instruction_set_name(s);
    }
    return Error{ErrorCode::failed_precondition,
                 std::string("instruction set ") + instruction_set_name(set) +
                     " is not available on this machine; available: " + names};
}

}  // namespace jostle::physics
