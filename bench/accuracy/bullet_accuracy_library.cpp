// SPDX-License-Identifier: MIT
#include "bench/accuracy/bullet_accuracy_library.h"

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

namespace jostle::bench::accuracy {
namespace {

using Maker = Engine* (*)();

// RTLD_DEEPBIND resolves symbols in the library and its dependencies first, where Bullet has double
// precision; in this program it has single precision.
Maker open_library() {
    void* library = dlopen(JOSTLE_BULLET_ACCURACY, RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
    void* maker = library ? dlsym(library, "make_bullet_accuracy_engine") : nullptr;
    if (!maker) {
        std::fprintf(stderr, "jostle-bench: cannot open Bullet: %s\n", dlerror());
        std::exit(1);
    }
    return reinterpret_cast<Maker>(maker);
}

}  // namespace

std::unique_ptr<Engine> open_bullet_engine() {
    static const Maker make = open_library();
    return std::unique_ptr<Engine>(make());
}

}  // namespace jostle::bench::accuracy
