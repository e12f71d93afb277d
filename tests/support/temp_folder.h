// SPDX-License-Identifier: MIT
//
// A temporary folder that is removed with the test.
#pragma once

#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace jostle::test {

class TempFolder {
public:
    TempFolder() {
        path_ = (std::filesystem::temp_directory_path() / "jostle-test-XXXXXX").string();
        if (mkdtemp(path_.data()) == nullptr)
            throw std::runtime_error("cannot create a temporary folder");
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::string operator/(const std::string& name) const { return path_ + "/" + name; }

    // Replaces the file atomically; only its owner can read it.
    std::string write(const std::string& name, const std::string& text) const {
        const std::string aside = *this / (name + ".new"), target = *this / name;
        std::ofstream(aside, std::ios::binary) << text;
        chmod(aside.c_str(), 0600);
        std::filesystem::rename(aside, target);
        return target;
    }
    std::string read(const std::string& name) const {
        std::ifstream in(*this / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

private:
    std::string path_;
};

}  // namespace jostle::test
