#include "weft/memory_files.h"

#include <filesystem>
#include <utility>

#include "weft/limits.h"

namespace weft {
namespace {

std::string normal_path(const std::string& path) {
    return std::filesystem::path(path).lexically_normal().generic_string();
}

}  // namespace

void MemoryFiles::put(const std::string& path, std::string text) {
    const std::lock_guard lock(mutex_);
    texts_[normal_path(path)] = std::move(text);
}

FileReader MemoryFiles::reader(FileReader others) const {
    return [this, others = std::move(others)](const std::string& path) {
        {
            const std::lock_guard lock(mutex_);
            const auto found = texts_.find(normal_path(path));
            if (found != texts_.end()) return std::optional(found->second);
        }
        return others ? others(path) : disk_reader(GraphLimits{}.json_bytes)(path);
    };
}

}  // namespace weft
