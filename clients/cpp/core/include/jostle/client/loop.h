// SPDX-License-Identifier: MIT
//
// One thread that connects its clients, and reads and writes their messages.
#pragma once

#include <memory>

namespace jostle::client {

class LoopThread;

class Loop {
public:
    Loop();
    ~Loop();  // cancels the streams that are still open, and waits for the thread
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;

private:
    friend class Client;
    std::unique_ptr<LoopThread> thread_;
};

}  // namespace jostle::client
