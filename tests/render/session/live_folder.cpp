#include "tests/render/session/live_folder.h"

#include <gtest/gtest.h>
#include <stdlib.h>  // for mkdtemp()

#include <fstream>

#include "tests/render/session_fixture.h"

namespace weft::test {

namespace fs = std::filesystem;

LiveFolder::LiveFolder() {
    std::string pattern = (fs::temp_directory_path() / "weft-live-XXXXXX").string();
    EXPECT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    for (const auto& entry : fs::directory_iterator(WEFT_SOURCE_DIR "/tests/render/reload"))
        set(entry.path().filename().string(), read_text(entry.path().string()).value_or(""));
}

LiveFolder::~LiveFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void LiveFolder::spoil(const std::string& name, const std::string& text, Way way) const {
    const fs::path file = path(name), written = way == Way::rename ? path(name + "~") : file;
    std::ofstream(written, std::ios::binary) << text;
    if (way == Way::rename) fs::rename(written, file);
}

void LiveFolder::set(const std::string& name, const std::string& text, Way way) {
    texts_[name] = text;
    spoil(name, text, way);
}

void LiveFolder::replace(const std::string& name, const std::string& from, const std::string& to, Way way) {
    std::string text = texts_.at(name);
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << name << " has no " << from;
    set(name, text.replace(at, from.size(), to), way);
}

void LiveFolder::remove(const std::string& name) const {
    fs::remove(path(name));
}

void LiveFolder::restore() const {
    fs::create_directories(folder_);
    for (const auto& [name, text] : texts_)
        if (read_text(path(name).string()) != text) spoil(name, text);
}

}  // namespace weft::test
