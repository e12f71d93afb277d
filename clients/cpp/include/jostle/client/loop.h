// SPDX-License-Identifier: MIT
//
// One thread that moves the messages of its clients.
#pragma once

#include <memory>

namespace jostle::client {

class LoopThread;

class Loop {
public:
    Loop();
    ~Loop();  // ends what is still connected
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;

private:
    friend class Client;
    std::unique_ptr<LoopThread> thread_;
};

}  // namespace jostle::client
