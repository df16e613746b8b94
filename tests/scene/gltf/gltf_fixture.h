// Purpose: writes small glTF files to a temporary folder from separate parts, so that a test shows only the
// relevant ones.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "weft/scene/load_gltf.h"

namespace weft::scene::test {

using Bytes = std::vector<uint8_t>;

template <class T>
void append(Bytes& bytes, std::initializer_list<T> values) {
    for (const T value : values) {
        uint8_t raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof value);
        for (const uint8_t byte : raw) bytes.push_back(byte);
    }
}

[[nodiscard]] std::string base64(std::span<const uint8_t> bytes);
[[nodiscard]] std::string data_uri(std::span<const uint8_t> bytes);

// An uncompressed 8-bit RGBA PNG. `rgba` may be shorter than the size in the header, to make a broken file.
[[nodiscard]] Bytes png(uint32_t width_px, uint32_t height_px, std::span<const uint8_t> rgba);

// The top-level members of a glTF as JSON text. Starts as one triangle: positions (0,0,0) (1,0,0) (0,1,0),
// uvs that put (0,0) at the top left of the image, normals +z, indices 0 1 2 as u16, one material, one node.
struct GltfText {
    GltfText();
    [[nodiscard]] std::string json() const;
    [[nodiscard]] Bytes glb(const Bytes& binary) const;

    std::map<std::string, std::string> members;
    Bytes buffer;  // content for "buffers", unless `members` contains "buffers"
};

class GltfTest : public ::testing::Test {
 protected:
    GltfTest();
    ~GltfTest() override;
    GltfTest(const GltfTest&) = delete;
    GltfTest& operator=(const GltfTest&) = delete;

    void write(const std::string& name, std::span<const uint8_t> bytes) const;
    void write(const std::string& name, const std::string& text) const;

    // Loads the scene and fails the test on an error.
    Scene load(const GltfText& text);
    Scene load_file(const std::string& name);
    // Expects that loading fails, and returns the first error.
    Diagnostic fail(const GltfText& text, const SceneLimits& limits = {});
    Diagnostic fail_file(const std::string& name, const SceneLimits& limits = {});
    [[nodiscard]] bool warned(const std::string& code) const;

    std::filesystem::path folder_;
    Diagnostics warnings_;
    Diagnostics errors_;
};

// Code and pointer of a diagnostic as one text: "S104 /accessors/0/count".
[[nodiscard]] std::string where(const Diagnostic& diagnostic);

}  // namespace weft::scene::test
