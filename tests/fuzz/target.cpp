// SPDX-License-Identifier: MIT
//
// The end of libFuzzer that all targets share.
#include "tests/fuzz/target.h"

#include <google/protobuf/stubs/logging.h>

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    // Protobuf says on stderr what it cannot read, which here is nearly everything.
    google::protobuf::SetLogHandler(nullptr);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    jostle::fuzz::run({data, size});
    return 0;
}
