// SPDX-License-Identifier: MIT
#include "server/grpc/message_bytes.h"

#include <array>
#include <vector>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// gRPC calls the deleter on the thread that releases the last reference; the count of a shared_ptr
// may be changed on any thread.
grpc::Slice share(const SharedBytes& bytes) {
    ASSERT(bytes);
    auto* const owner = new SharedBytes(bytes);
    // gRPC's interface takes void* but never writes into a slice.
    void* const data = const_cast<char*>(bytes->data());
    return grpc::Slice(
        data, bytes->size(), [](void* user) { delete static_cast<SharedBytes*>(user); }, owner);
}

}  // namespace

grpc::ByteBuffer to_byte_buffer(const OutMessage& message) {
    std::array<grpc::Slice, 2> slices;
    std::size_t count = 0;
    if (!message.header.empty()) {
        slices[count++] = grpc::Slice(message.header.data(), message.header.size());
    }
    if (message.shared && !message.shared->empty()) slices[count++] = share(message.shared);
    ASSERT(count <= slices.size());
    if (message.cells.empty()) return grpc::ByteBuffer(slices.data(), count);
    std::vector<grpc::Slice> all(slices.begin(),
                                 slices.begin() + static_cast<std::ptrdiff_t>(count));
    for (const SharedBytes& cell : message.cells) all.push_back(share(cell));
    return grpc::ByteBuffer(all.data(), all.size());
}

void copy_bytes(std::string& out, const grpc::ByteBuffer& buffer) {
    out.clear();
    grpc::Slice single;
    if (buffer.TrySingleSlice(&single).ok()) {
        out.assign(reinterpret_cast<const char*>(single.begin()), single.size());
        return;
    }
    std::vector<grpc::Slice> slices;
    if (!buffer.Dump(&slices).ok()) return;
    for (const grpc::Slice& slice : slices) {
        out.append(reinterpret_cast<const char*>(slice.begin()), slice.size());
    }
}

}  // namespace jostle::server
