#include "load/data_file.h"

#include <algorithm>
#include <array>

#include "graph/diagnostics/quantity_text.h"
#include "graph/syntax/contained_file.h"
#include "load/text_reader.h"

namespace weft {
namespace {

namespace fs = std::filesystem;

DataFile too_large(const std::string& path, uint64_t bytes, const LoadSettings& settings) {
    return {path,
            {},
            bytes,
            "the file has " + bytes_text(bytes) + "; the limit is " +
                limit_bytes_text(settings.limits.graph.file_bytes),
            "use a smaller file, " + raise_limit_text("graph.fileBytes")};
}

DataFile read_from_disk(const std::string& path, uint64_t most_bytes, const LoadSettings& settings) {
    DataFile file{path, {}, 0, {}, {}};
    const PlainRead read =
        read_plain_file(path, settings.limits.graph.file_bytes, LastLink::followed, [&](uint64_t size_bytes) {
            file.size_bytes = size_bytes;
            file.bytes.resize(std::min(size_bytes, most_bytes));
            return std::as_writable_bytes(std::span(file.bytes));
        });
    if (read.fault == FileFault::too_large) return too_large(path, read.size_bytes, settings);
    if (read.fault != FileFault::none)
        return {path, {}, 0, "the file cannot be read", "check its permissions"};
    file.bytes.resize(read.size_bytes);
    return file;
}

DataFile read(const std::string& path, uint64_t most_bytes, const LoadSettings& settings) {
    if (reads_disk(settings)) return read_from_disk(path, most_bytes, settings);
    std::optional<std::string> bytes = settings.reader(path);
    if (!bytes) return {path, {}, 0, "the file cannot be read", "check that the program provides the file"};
    const uint64_t size_bytes = bytes->size();
    if (size_bytes > settings.limits.graph.file_bytes) return too_large(path, size_bytes, settings);
    return {path, std::move(*bytes), size_bytes, {}, {}};
}

bool exists(const std::string& path, const LoadSettings& settings) {
    std::error_code failed;
    return reads_disk(settings) ? fs::exists(path, failed) : settings.reader(path).has_value();
}

}  // namespace

DataFile find_data_file(const std::string& folder, const std::string& name, uint64_t most_bytes,
                        const LoadSettings& settings, std::set<fs::path>* searched) {
    std::vector<fs::path> places{fs::path(folder)};
    for (const fs::path& shipped : {settings.graph_root, settings.shader_root})
        if (!shipped.empty()) places.push_back(shipped);
    std::vector<fs::path> real;
    for (const fs::path& place : places) real.push_back(real_folder(place));
    for (const fs::path& place : settings.graph_path) real.push_back(real_folder(place));
    std::string tried;
    for (const fs::path& place : places) {
        const std::string path = (place / name).lexically_normal().generic_string();
        tried += (tried.empty() ? "\"" : ", \"") + path + "\"";
        if (searched != nullptr) searched->insert(fs::absolute(path).lexically_normal());
        const RealFile found = find_real_file(path, real);
        if (!found.path.empty() && !found.is_inside)
            return {path,
                    {},
                    0,
                    "the file is a symbolic link that leads out of the folder of the graph",
                    "replace the link by a copy of the file"};
        if (searched != nullptr && !found.path.empty()) searched->insert(found.path);
        if (exists(path, settings)) return read(path, most_bytes, settings);
    }
    return {{}, {}, 0, "the file does not exist", "correct the name; Weft looked for " + tried};
}

DataFile read_data_file(const std::string& path, const LoadSettings& settings) {
    return read(path, UINT64_MAX, settings);
}

Diagnostic unusable_file(const SourceMap& sources, SourceLoc loc, const std::string& name,
                         const std::string& resource, const std::string& fault, const std::string& help) {
    Diagnostic d = sources.error(loc, "W145",
                                 "the file \"" + name + "\" of \"" + resource + "\" is not usable: " + fault);
    d.help.push_back(help);
    return d;
}

}  // namespace weft
