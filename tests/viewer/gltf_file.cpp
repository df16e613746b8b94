#include "tests/viewer/gltf_file.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <vector>

namespace weft::test {
namespace {

std::string base64(const std::vector<uint8_t>& bytes) {
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t word = 0;
        const size_t rest = std::min<size_t>(3, bytes.size() - i);
        for (size_t j = 0; j < 3; ++j) word = word << 8 | (j < rest ? bytes[i + j] : 0);
        for (size_t j = 0; j < 4; ++j) text += j <= rest ? kDigits[word >> (18 - 6 * j) & 63] : '=';
    }
    return text;
}

// Returns the content of the buffer: four positions, followed by six indices of two triangles.
std::vector<uint8_t> square_bytes() {
    constexpr std::array<float, 12> kPositions{-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
    constexpr std::array<uint16_t, 6> kIndices{0, 2, 1, 0, 3, 2};
    std::vector<uint8_t> bytes(sizeof kPositions + sizeof kIndices);
    std::memcpy(bytes.data(), kPositions.data(), sizeof kPositions);
    std::memcpy(bytes.data() + sizeof kPositions, kIndices.data(), sizeof kIndices);
    return bytes;
}

}  // namespace

std::string square_gltf() {
    return R"({
  "asset": { "version": "2.0" },
  "scene": 0,
  "scenes": [ { "nodes": [0, 1] } ],
  "nodes": [
    { "mesh": 0 },
    { "camera": 0, "translation": [0, 1, 3], "rotation": [-0.1564345, 0, 0, 0.9876883] }
  ],
  "cameras": [ { "name": "front", "type": "perspective", "perspective": { "yfov": 0.8, "znear": 0.1 } } ],
  "meshes": [ { "primitives": [ { "attributes": { "POSITION": 0 }, "indices": 1, "material": 0 } ] } ],
  "materials": [ { "doubleSided": true, "pbrMetallicRoughness": { "baseColorFactor": [0.8, 0.2, 0.1, 1],
                   "metallicFactor": 0, "roughnessFactor": 0.9 } } ],
  "accessors": [
    { "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, 0, -1], "max": [1, 0, 1] },
    { "bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR" }
  ],
  "bufferViews": [ { "buffer": 0, "byteOffset": 0, "byteLength": 48 }, { "buffer": 0, "byteOffset": 48, "byteLength": 12 } ],
  "buffers": [ { "byteLength": 60, "uri": "data:application/octet-stream;base64,)" +
           base64(square_bytes()) + R"(" } ]
}
)";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    assert(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace weft::test
