// Purpose: stores the bytes of a fuzzer as the only file of a folder, for code that reads files. The folder
// is in memory (/dev/shm) if possible.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

namespace weft::fuzz {

class FuzzedFile {
 public:
    explicit FuzzedFile(const std::string& name) {
        const bool in_memory = std::filesystem::exists("/dev/shm");
        std::string folder = in_memory ? "/dev/shm/weft-fuzz-XXXXXX" : "/tmp/weft-fuzz-XXXXXX";
        if (mkdtemp(folder.data()) == nullptr) std::abort();
        path_ = std::filesystem::path(folder) / name;
    }
    ~FuzzedFile() {
        std::error_code ignored;
        std::filesystem::remove_all(path_.parent_path(), ignored);
    }
    FuzzedFile(const FuzzedFile&) = delete;
    FuzzedFile& operator=(const FuzzedFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    void write(std::span<const uint8_t> bytes) const {
        FILE* file = std::fopen(path_.c_str(), "wb");
        if (file == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() ||
            std::fclose(file) != 0)
            std::abort();
    }

 private:
    std::filesystem::path path_;
};

}  // namespace weft::fuzz
