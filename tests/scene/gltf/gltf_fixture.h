// Purpose: writes small glTF files to a temporary folder. A file is put together from separate parts, so that
// a test shows only the parts that matter for it.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <glm/glm.hpp>
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

// Makes an uncompressed 8-bit RGBA PNG. `rgba` may be shorter than the size in the header says: then the file
// is broken.
[[nodiscard]] Bytes png(uint32_t width_px, uint32_t height_px, std::span<const uint8_t> rgba);

// The top-level members of a glTF file as JSON text. The initial file has one triangle with the positions
// (0,0,0) (1,0,0) (0,1,0), normals +z, 16-bit indices 0 1 2, one material and one node. The position (0,0,0)
// shows the lower left corner of a texture.
struct GltfText {
    GltfText();
    [[nodiscard]] std::string json() const;
    [[nodiscard]] Bytes glb(const Bytes& binary) const;

    std::map<std::string, std::string> members;
    Bytes buffer;  // Content of "buffers" in the file. It is ignored if `members` has a member "buffers".
};

class GltfTest : public ::testing::Test {
 protected:
    GltfTest();
    ~GltfTest() override;
    GltfTest(const GltfTest&) = delete;
    GltfTest& operator=(const GltfTest&) = delete;

    void write(const std::string& name, std::span<const uint8_t> bytes) const;
    void write(const std::string& name, const std::string& text) const;

    // Loads the scene. An error makes the test fail.
    Scene load(const GltfText& text);
    Scene load_file(const std::string& name);
    // Expects that loading fails. Returns the first error.
    Diagnostic fail(const GltfText& text, const SceneLimits& limits = {});
    Diagnostic fail_file(const std::string& name, const SceneLimits& limits = {});
    [[nodiscard]] bool warned(const std::string& code) const;

    std::filesystem::path folder_;
    Diagnostics warnings_;
    Diagnostics errors_;
};

// Returns the code and the JSON pointer of a diagnostic as one text, for example "S104 /accessors/0/count".
[[nodiscard]] std::string where(const Diagnostic& diagnostic);

// Expects that two points are at most 1e-5 apart.
void expect_near(const glm::vec3& a, const glm::vec3& b);

}  // namespace weft::scene::test
