#include "weft/memory_files.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <utility>

namespace weft {
namespace {

std::string normal_path(const std::string& path) {
    return std::filesystem::path(path).lexically_normal().generic_string();
}

}  // namespace

struct MemoryFiles::Texts {
    std::mutex mutex;
    std::map<std::string, std::string> by_path;
};

MemoryFiles::MemoryFiles() : texts_(std::make_shared<Texts>()) {}

void MemoryFiles::put(const std::string& path, std::string text) {
    const std::lock_guard lock(texts_->mutex);
    texts_->by_path[normal_path(path)] = std::move(text);
}

FileReader MemoryFiles::reader(FileReader others) const {
    return [texts = texts_, others = std::move(others)](const std::string& path) {
        {
            const std::lock_guard lock(texts->mutex);
            const auto found = texts->by_path.find(normal_path(path));
            if (found != texts->by_path.end()) return std::optional(found->second);
        }
        return others(path);
    };
}

}  // namespace weft
