#include "shader/shader_memory.h"

#include <algorithm>
#include <system_error>

namespace weft {

namespace fs = std::filesystem;

namespace {

// Returns the key of a program. It contains the absolute paths of the folders, because the same reference
// names different programs in different folders.
std::string key_of(const std::string& reference, ProgramKind kind, const ShaderRoots& roots) {
    std::string key = reference + '\n' + std::to_string(static_cast<int>(kind));
    std::error_code error;
    for (const fs::path& root : roots.roots)
        key += '\n' + fs::absolute(root.empty() ? fs::path(".") : root, error).generic_string();
    // The key also contains the properties of the device, because the SPIR-V gate depends on them.
    const ShaderTarget& target = roots.target;
    key += '\n' + std::to_string(target.capabilities) + ' ' +
           std::to_string(target.storage_read_without_format) + ' ' + std::to_string(target.max_shared_bytes);
    return key + '\n' + fs::absolute(roots.include_root, error).generic_string();
}

}  // namespace

void ShaderMemory::begin() {
    files_.clear();
    for (auto& [key, entry] : entries_) entry.used = false;
}

void ShaderMemory::forget_unused() {
    std::erase_if(entries_, [](const auto& item) { return !item.second.used; });
}

const ShaderProgram* ShaderMemory::find(const std::string& reference, ProgramKind kind,
                                        const ShaderRoots& roots) {
    ++requests_;
    const auto found = entries_.find(key_of(reference, kind, roots));
    if (found != entries_.end()) {
        shader::SourceReader reader(roots);
        const bool same = std::ranges::all_of(
            found->second.probes, [&](const shader::SourceProbe& probe) { return reader.still_so(probe); });
        add_files_of(reader);
        found->second.used = true;
        if (same) return &found->second.program;
    }
    ++misses_;
    return nullptr;
}

void ShaderMemory::remember(const ShaderProgram& program, ProgramKind kind, const ShaderRoots& roots,
                            const shader::SourceReader& reader) {
    entries_[key_of(program.reference, kind, roots)] = {reader.probes(), program, true};
}

void ShaderMemory::add_files_of(const shader::SourceReader& reader) {
    files_.insert(reader.places().begin(), reader.places().end());
}

}  // namespace weft
