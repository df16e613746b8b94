// Purpose: tells whether files have changed since they were read, without reading them again. A stamp is what
// the file system stores about a file: its device and inode numbers, its size, and its times of change.
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>

namespace weft {

class FileStamps {
 public:
    // Create the object before the files are read.
    FileStamps();

    // Stamps the files that were read, and those that were searched but do not exist. Call this once, after
    // reading.
    void take(const std::set<std::filesystem::path>& files);
    // Returns true only if every file still has the content that was read. Returns false if this is not sure:
    // before take(), or if a file changed while the files were read or shortly before.
    [[nodiscard]] bool hold() const;

 private:
    struct Stamp {
        bool exists = false;
        uint64_t device = 0, inode = 0;
        int64_t size_bytes = 0;
        // Times since 1970 of the last change of the content, and of the last change of content or metadata.
        int64_t modified_ns = 0, changed_ns = 0;
        bool operator==(const Stamp&) const = default;
    };

    static Stamp stamp_of(const std::filesystem::path& path);
    void add(const std::filesystem::path& path);

    int64_t begun_ns_;
    bool sure_ = false;
    std::map<std::filesystem::path, Stamp> stamps_;
};

}  // namespace weft
