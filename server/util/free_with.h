// SPDX-License-Identifier: MIT
//
// Deleter for an object of a C library: std::unique_ptr<X509, FreeWith<X509_free>>.
#pragma once

namespace jostle::server {

template <auto free>
struct FreeWith {
    template <class T>
    void operator()(T* object) const {
        free(object);
    }
};

}  // namespace jostle::server
