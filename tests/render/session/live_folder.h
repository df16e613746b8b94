// Purpose: a graph's files in a folder of their own, to be edited, broken and mended. Gone after the test.
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
    // What the file shall hold from now on.
    void set(const std::string& name, const std::string& text, Way way = Way::rename);
    // Replaces what stands there once. The test fails where it isn't there.
    void replace(const std::string& name, const std::string& from, const std::string& to,
                 Way way = Way::rename);
    // Until mend(), which brings all files back to what they shall hold.
    void spoil(const std::string& name, const std::string& text, Way way = Way::rename) const;
    void remove(const std::string& name) const;
    void mend() const;

 private:
    std::filesystem::path folder_;
    std::map<std::string, std::string> texts_;
};

}  // namespace weft::test
