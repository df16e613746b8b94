// Purpose: a folder with a graph's files that a test can edit, break and restore. Removed after the test.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace weft::test {

class LiveFolder {
 public:
    // Holds copies of tests/render/reload/*.
    LiveFolder();
    ~LiveFolder();
    LiveFolder(const LiveFolder&) = delete;
    LiveFolder& operator=(const LiveFolder&) = delete;

    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
    [[nodiscard]] std::string graph() const { return path("live.json").string(); }
    [[nodiscard]] const std::string& text(const std::string& name) const { return texts_.at(name); }

    // In place, or as most editors do, by writing another file and renaming it.
    enum class Way : uint8_t { in_place, rename };
    // Sets the wanted content of the file.
    void set(const std::string& name, const std::string& text, Way way = Way::rename);
    // Replaces the only occurrence of `from`. The test fails if there is none.
    void replace(const std::string& name, const std::string& from, const std::string& to,
                 Way way = Way::rename);
    // Writes other content until restore(), which restores the wanted content of all files.
    void spoil(const std::string& name, const std::string& text, Way way = Way::rename) const;
    void remove(const std::string& name) const;
    void restore() const;

 private:
    std::filesystem::path folder_;
    std::map<std::string, std::string> texts_;
};

}  // namespace weft::test
