#include "shader/compile/shader_sources.h"

#include <algorithm>
#include <system_error>

#include "graph/diagnostics/quantity_text.h"
#include "graph/syntax/contained_file.h"
#include "shader/compile/content_hash.h"

namespace weft::shader {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxSuggestionDepth = 3;
constexpr size_t kMaxSuggestionEntries = 2000;

// Returns true if the path is relative and contains no "..". Such a path stays below its root folder, except
// through a symbolic link.
bool is_plain_relative(const fs::path& path) {
    if (path.empty() || path.has_root_path() || path.native().find('\0') != std::string::npos) return false;
    return std::ranges::none_of(path, [](const fs::path& part) { return part == ".." || part.empty(); });
}

constexpr const char* kClimbing = "the path is absolute or contains \"..\"";

}  // namespace

SourceReader::SourceReader(const ShaderRoots& roots) : limits_(roots.limits) {
    const auto add = [&](const fs::path& folder) {
        roots_.push_back({folder, real_folder(folder)});
        folders_.push_back(roots_.back().canonical);
    };
    std::ranges::for_each(roots.roots, add);
    add(roots.include_root);
    for (const fs::path& folder : roots.allowed) folders_.push_back(real_folder(folder));
}

SourceLookup SourceReader::look(size_t root, const fs::path& relative) {
    const std::string key = relative.generic_string();
    if (const auto known = texts_.find({root, key}); known != texts_.end())
        return {&known->second, false, {}};

    SourceProbe probe{root, key, false, 0};
    std::error_code error;
    const fs::path folder =
        roots_[root].canonical.empty()
            ? fs::absolute(roots_[root].shown.empty() ? fs::path(".") : roots_[root].shown, error)
            : roots_[root].canonical;
    places_.push_back((folder / relative).lexically_normal());
    const RealFile real =
        roots_[root].canonical.empty() ? RealFile{} : find_real_file(folder / relative, folders_);
    const fs::path& file = real.path;
    if (!file.empty() && file != places_.back()) places_.push_back(file);
    if (file.empty()) {
        probes_.push_back(probe);
        return {nullptr, false, "no such file"};
    }
    if (!real.is_inside) return {nullptr, true, "the file is a link to a place outside the shader folders"};
    SourceLookup lookup = load(root, relative, file);
    if (lookup.source != nullptr) {
        probe.present = true;
        probe.text_hash = hash_of(lookup.source->text);
        probes_.push_back(probe);
    }
    return lookup;
}

SourceLookup SourceReader::load(size_t root, const fs::path& relative, const fs::path& file) {
    FileContent content = read_plain_file(file, limits_.file_bytes, LastLink::refused);
    if (content.fault == FileFault::too_large)
        return {nullptr, true, "the file is larger than " + limit_bytes_text(limits_.file_bytes)};
    if (content.fault == FileFault::not_plain) return {nullptr, true, "this is not a regular file"};
    if (content.fault != FileFault::none) return {nullptr, true, "the file cannot be read"};
    if (texts_.size() >= limits_.files)
        return {nullptr, true, "the shader has more than " + std::to_string(limits_.files) + " files"};
    std::string text = std::move(content.bytes);
    total_bytes_ += text.size();
    if (total_bytes_ > limits_.text_bytes)
        return {
            nullptr, true,
            "the files of the shader have more than " + limit_bytes_text(limits_.text_bytes) + " together"};

    const std::string key = relative.generic_string();
    SourceText source;
    source.name = find(key) == nullptr ? key : key + "@" + std::to_string(root);
    source.path = (roots_[root].shown / relative).generic_string();
    source.text = std::move(text);
    source.root = root;
    source.relative = key;
    return {&texts_.emplace(std::pair(root, key), std::move(source)).first->second, false, {}};
}

SourceLookup SourceReader::read_reference(const std::string& relative) {
    if (!is_plain_relative(relative)) return {nullptr, true, kClimbing};
    for (size_t root = 0; root + 1 < roots_.size(); ++root) {
        SourceLookup lookup = look(root, relative);
        if (lookup.source != nullptr || lookup.refused) return lookup;
    }
    return {nullptr, false, "no such file"};
}

SourceLookup SourceReader::read_shared(const std::string& relative) {
    return look(roots_.size() - 1, relative);
}

SourceLookup SourceReader::read_include(const std::string& requested, const std::string& includer,
                                        bool beside) {
    if (!is_plain_relative(requested)) return {nullptr, true, kClimbing};
    const SourceText* parent = find(includer);
    SourceLookup lookup;
    std::string places;
    const auto search = [&](size_t root, const fs::path& folder) {
        if (lookup.source != nullptr || lookup.refused) return;
        lookup = look(root, folder / requested);
        places += (places.empty() ? "" : ", then in ") + shown_folder(root, folder);
    };
    if (beside && parent != nullptr) {
        const fs::path folder = fs::path(parent->relative).parent_path();
        search(parent->root, folder);
        if (!folder.empty()) search(parent->root, {});
    }
    search(roots_.size() - 1, {});
    if (lookup.source == nullptr && !lookup.refused) lookup.reason += "; Weft looked in " + places;
    if (lookup.source != nullptr && parent != nullptr) {
        SourceText& found = texts_.at({lookup.source->root, lookup.source->relative});
        if (found.included_by.empty()) {
            found.included_by = includer;
            found.include_text = requested;
        }
    }
    return lookup;
}

std::string SourceReader::shown_folder(size_t root, const fs::path& relative) const {
    const fs::path folder = (roots_[root].shown / relative / ".").lexically_normal().parent_path();
    return folder.empty() ? "." : folder.generic_string();
}

bool SourceReader::still_so(const SourceProbe& probe) {
    if (probe.root >= roots_.size() || !is_plain_relative(probe.relative)) return false;
    const SourceLookup lookup = look(probe.root, probe.relative);
    if (lookup.refused || (lookup.source != nullptr) != probe.present) return false;
    return !probe.present || hash_of(lookup.source->text) == probe.text_hash;
}

std::vector<const SourceText*> SourceReader::sources() const {
    std::vector<const SourceText*> all;
    for (const auto& [key, source] : texts_) all.push_back(&source);
    return all;
}

const SourceText* SourceReader::find(std::string_view name) const {
    const auto found =
        std::ranges::find_if(texts_, [&](const auto& item) { return item.second.name == name; });
    return found == texts_.end() ? nullptr : &found->second;
}

std::vector<std::string> SourceReader::known_references(const std::string& extension) const {
    std::vector<std::string> known;
    for (size_t root = 0; root + 1 < roots_.size(); ++root) {
        if (roots_[root].canonical.empty()) continue;
        std::error_code error;
        fs::recursive_directory_iterator it(roots_[root].canonical,
                                            fs::directory_options::skip_permission_denied, error);
        size_t entries = 0;
        for (; !error && it != fs::recursive_directory_iterator() && entries < kMaxSuggestionEntries;
             ++entries) {
            if (it->path().extension() == extension) {
                known.push_back(it->path().lexically_relative(roots_[root].canonical).generic_string());
            }
            if (it.depth() >= kMaxSuggestionDepth) it.disable_recursion_pending();
            it.increment(error);
        }
    }
    std::ranges::sort(known);
    known.erase(std::unique(known.begin(), known.end()), known.end());
    return known;
}

}  // namespace weft::shader
