#include "tests/scene/gltf/gltf_fixture.h"

#include <unistd.h>

#include <fstream>

namespace weft::scene::test {
namespace {

void append_big_endian(Bytes& bytes, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<uint8_t>(value >> shift));
}

void extend(Bytes& bytes, std::span<const uint8_t> more) {
    for (const uint8_t byte : more) bytes.push_back(byte);
}

uint32_t crc32(std::span<const uint8_t> bytes) {
    uint32_t crc = ~0u;
    for (const uint8_t byte : bytes) {
        crc ^= byte;
        for (int i = 0; i < 8; ++i) crc = crc >> 1 ^ (0xedb88320u & (0u - (crc & 1u)));
    }
    return ~crc;
}

void append_png_chunk(Bytes& out, const char* type, const Bytes& body) {
    append_big_endian(out, static_cast<uint32_t>(body.size()));
    Bytes checked(type, type + 4);
    extend(checked, body);
    extend(out, checked);
    append_big_endian(out, crc32(checked));
}

// Writes `raw` in zlib's format with uncompressed blocks, so that the tests need no compressor.
Bytes store(const Bytes& raw) {
    Bytes out{0x78, 0x01};
    uint32_t a = 1;
    uint32_t b = 0;
    for (const uint8_t byte : raw) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    for (size_t at = 0; at < raw.size() || at == 0;) {
        const size_t size = std::min<size_t>(65535, raw.size() - at);
        out.push_back(at + size == raw.size() ? 1 : 0);
        append<uint16_t>(out, {static_cast<uint16_t>(size), static_cast<uint16_t>(~size)});
        extend(out, std::span(raw).subspan(at, size));
        at += size;
        if (size == 0) break;
    }
    append_big_endian(out, b << 16 | a);
    return out;
}

}  // namespace

std::string base64(std::span<const uint8_t> bytes) {
    static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (size_t k = 0; k < 4; ++k) {
            out.push_back(i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63]);
        }
    }
    return out;
}

std::string data_uri(std::span<const uint8_t> bytes) {
    return "data:application/octet-stream;base64," + base64(bytes);
}

Bytes png(uint32_t width_px, uint32_t height_px, std::span<const uint8_t> rgba) {
    Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    Bytes header;
    append_big_endian(header, width_px);
    append_big_endian(header, height_px);
    append<uint8_t>(header, {8, 6, 0, 0, 0});
    append_png_chunk(out, "IHDR", header);
    Bytes rows;
    const size_t row_bytes = size_t{width_px} * 4;
    for (size_t at = 0; at + row_bytes <= rgba.size(); at += row_bytes) {
        rows.push_back(0);
        extend(rows, rgba.subspan(at, row_bytes));
    }
    append_png_chunk(out, "IDAT", store(rows));
    append_png_chunk(out, "IEND", {});
    return out;
}

GltfText::GltfText() {
    append<float>(buffer, {0, 0, 0, 1, 0, 0, 0, 1, 0});  // Buffer view 0 contains the positions.
    append<float>(buffer, {0, 0, 1, 0, 0, 1, 0, 0, 1});  // Buffer view 1 contains the normals.
    append<float>(buffer, {0, 1, 1, 1, 0, 0});           // Buffer view 2 contains the texture coordinates.
    append<uint16_t>(buffer, {0, 1, 2, 0});              // Buffer view 3 contains the indices.
    members["asset"] = R"({"version":"2.0"})";
    members["scenes"] = R"([{"nodes":[0]}])";
    members["nodes"] = R"([{"mesh":0}])";
    members["materials"] = R"([{"name":"plain"}])";
    members["meshes"] =
        R"([{"name":"tri","primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3,"material":0}]}])";
    members["accessors"] = R"([{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
        {"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},
        {"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"},
        {"bufferView":3,"componentType":5123,"count":3,"type":"SCALAR"}])";
    members["bufferViews"] = R"([{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},
        {"buffer":0,"byteOffset":72,"byteLength":24},{"buffer":0,"byteOffset":96,"byteLength":8}])";
}

std::string GltfText::json() const {
    std::map<std::string, std::string> all = members;
    all.try_emplace("buffers", R"([{"byteLength":)" + std::to_string(buffer.size()) + R"(,"uri":")" +
                                   data_uri(buffer) + R"("}])");
    std::string out = "{";
    for (const auto& [key, value] : all) out += (out.size() > 1 ? ",\n\"" : "\n\"") + key + "\": " + value;
    return out + "\n}\n";
}

Bytes GltfText::glb(const Bytes& binary) const {
    GltfText text = *this;
    text.members.try_emplace("buffers", R"([{"byteLength":)" + std::to_string(binary.size()) + "}]");
    std::string json = text.json();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    Bytes padded = binary;
    padded.resize((padded.size() + 3) / 4 * 4, 0);
    Bytes out;
    const auto json_bytes = static_cast<uint32_t>(json.size());
    const auto bin_bytes = static_cast<uint32_t>(padded.size());
    append<uint32_t>(out, {0x46546c67, 2, 28 + json_bytes + bin_bytes, json_bytes, 0x4e4f534a});
    extend(out, Bytes(json.begin(), json.end()));
    append<uint32_t>(out, {bin_bytes, 0x004e4942});
    extend(out, padded);
    return out;
}

GltfTest::GltfTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "weft_gltf_XXXXXX").string();
    folder_ = std::filesystem::path(mkdtemp(pattern.data())) / "scene";
    std::filesystem::create_directory(folder_);
}

GltfTest::~GltfTest() {
    std::filesystem::remove_all(folder_.parent_path());
}

void GltfTest::write(const std::string& name, std::span<const uint8_t> bytes) const {
    std::ofstream file(folder_ / name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    ASSERT_TRUE(file.good());
}

void GltfTest::write(const std::string& name, const std::string& text) const {
    write(name, Bytes(text.begin(), text.end()));
}

Scene GltfTest::load(const GltfText& text) {
    write("scene.gltf", text.json());
    return load_file("scene.gltf");
}

Scene GltfTest::load_file(const std::string& name) {
    warnings_.clear();
    Result<Scene> result = load_gltf(folder_ / name, warnings_);
    if (result.ok()) return std::move(*result);
    ADD_FAILURE() << where(result.errors().front()) << " " << result.errors().front().message;
    return {};
}

Diagnostic GltfTest::fail(const GltfText& text, const SceneLimits& limits) {
    write("scene.gltf", text.json());
    return fail_file("scene.gltf", limits);
}

Diagnostic GltfTest::fail_file(const std::string& name, const SceneLimits& limits) {
    warnings_.clear();
    Result<Scene> result = load_gltf(folder_ / name, warnings_, limits);
    if (result.ok()) {
        ADD_FAILURE() << name << " loaded although it is broken";
        return {};
    }
    errors_ = result.take_errors();
    for (const Diagnostic& error : errors_) {
        EXPECT_EQ(error.severity, Severity::error);
        EXPECT_FALSE(error.message.empty());
        EXPECT_FALSE(error.help.empty()) << where(error);
        EXPECT_NE(error.file.find(folder_.string()), std::string::npos);
    }
    return errors_.front();
}

bool GltfTest::warned(const std::string& code) const {
    for (const Diagnostic& warning : warnings_) {
        if (warning.code == code) return true;
    }
    return false;
}

std::string where(const Diagnostic& diagnostic) {
    return diagnostic.code + " " + diagnostic.pointer;
}

void expect_near(const glm::vec3& a, const glm::vec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-5f) << a.x << " " << a.y << " " << a.z;
}

}  // namespace weft::scene::test
