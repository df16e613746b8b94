// Purpose: a temporary folder with copies of a graph's files, which a test can edit, damage and restore. The
// folder is removed after the test.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace weft::test {

class LiveFolder {
 public:
    // Creates the folder with copies of the files tests/render/reload/*.
    LiveFolder();
    ~LiveFolder();
    LiveFolder(const LiveFolder&) = delete;
    LiveFolder& operator=(const LiveFolder&) = delete;

    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
    [[nodiscard]] std::string graph() const { return path("live.json").string(); }
    [[nodiscard]] const std::string& text(const std::string& name) const { return texts_.at(name); }

    // How a file is written: in place, or as most editors do, by writing another file and renaming it.
    enum class Way : uint8_t { in_place, rename };
    // Changes a file permanently: `text` becomes its wanted content, which restore() restores.
    void set(const std::string& name, const std::string& text, Way way = Way::rename);
    // Replaces `from` by `to` in the wanted content of a file. The test fails if `from` does not occur.
    void replace(const std::string& name, const std::string& from, const std::string& to,
                 Way way = Way::rename);
    // Writes `text` to a file but does not change its wanted content, which restore() writes again.
    void spoil(const std::string& name, const std::string& text, Way way = Way::rename) const;
    void remove(const std::string& name) const;
    void restore() const;

 private:
    std::filesystem::path folder_;
    std::map<std::string, std::string> texts_;
};

}  // namespace weft::test
