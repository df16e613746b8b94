#include "scene/gltf/gltf_container.h"

#include <algorithm>
#include <string>

namespace weft::scene::gltf {
namespace {

// The types of chunks: the texts "JSON" and "BIN\0" as little-endian numbers.
enum ChunkType : uint32_t { kJsonChunk = 0x4e4f534a, kBinChunk = 0x004e4942 };
constexpr size_t kHeaderBytes = 12;
constexpr size_t kChunkHeaderBytes = 8;

uint32_t read_u32(std::span<const uint8_t> bytes, size_t at) {
    return static_cast<uint32_t>(bytes[at]) | static_cast<uint32_t>(bytes[at + 1]) << 8 |
           static_cast<uint32_t>(bytes[at + 2]) << 16 | static_cast<uint32_t>(bytes[at + 3]) << 24;
}

std::string_view as_text(std::span<const uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
    uint32_t type = 0;
    std::span<const uint8_t> bytes;
};

// Returns the chunk at offset `at` and advances `at` to the next chunk. Returns nullopt when the file ends
// inside the chunk.
std::optional<Chunk> next_chunk(std::span<const uint8_t> file, size_t& at) {
    if (file.size() - at < kChunkHeaderBytes) return std::nullopt;
    const size_t length = read_u32(file, at);
    const uint32_t type = read_u32(file, at + 4);
    at += kChunkHeaderBytes;
    if (file.size() - at < length) return std::nullopt;
    const Chunk chunk{type, file.subspan(at, length)};
    at += length;
    return chunk;
}

void report_truncated(Report& report, const std::string& what) {
    report.error("S102", {}, what, "copy or export the file again, because it is truncated");
}

std::optional<Container> open_binary(std::span<const uint8_t> file, Report& report) {
    if (file.size() < kHeaderBytes) {
        report_truncated(report,
                         "a .glb file has at least 12 bytes, this file has " + std::to_string(file.size()));
        return std::nullopt;
    }
    const uint32_t version = read_u32(file, 4);
    if (version != 2) {
        report.error(
            "S113", {},
            version == 1 ? "the file is a binary file of glTF 1.0; wanted glTF 2.0"
                         : "the version of the .glb file is " + std::to_string(version) + "; wanted 2",
            "convert the file to glTF 2.0, for example with `gltf-pipeline -i OLD -o NEW`, or export the "
            "scene as glTF 2.0");
        return std::nullopt;
    }
    const uint32_t length = read_u32(file, 8);
    if (length > file.size() || length < kHeaderBytes) {
        report_truncated(report, "the header of the file gives a size of " + std::to_string(length) +
                                     " bytes, the file has " + std::to_string(file.size()));
        return std::nullopt;
    }
    file = file.first(length);
    size_t at = kHeaderBytes;
    const std::optional<Chunk> json = next_chunk(file, at);
    if (!json || json->type != kJsonChunk) {
        report_truncated(report, "the first chunk of the file is not a complete JSON chunk");
        return std::nullopt;
    }
    Container container{as_text(json->bytes), std::nullopt};
    while (file.size() - at >= kChunkHeaderBytes) {
        const std::optional<Chunk> chunk = next_chunk(file, at);
        if (!chunk) {
            report_truncated(report, "a chunk extends beyond the end of the file");
            return std::nullopt;
        }
        if (chunk->type == kBinChunk && !container.binary) container.binary = chunk->bytes;
    }
    return container;
}

}  // namespace

std::optional<Container> open_container(std::span<const uint8_t> file, Report& report) {
    if (file.empty()) {
        report.error("S102", {}, "the file is empty", "copy or export the file again");
        return std::nullopt;
    }
    // The text "glTF" as a little-endian number: the first four bytes of a .glb file.
    constexpr uint32_t kMagic = 0x46546c67;
    if (file.size() >= 4 && read_u32(file, 0) == kMagic) return open_binary(file, report);
    std::string_view text = as_text(file);
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    const size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text[first] != '{') {
        const TextPosition at = position_of(text, first);
        report.error_at("S102", at.line, at.column,
                        "the file is neither a .glb nor the JSON object of a .gltf",
                        "name a .gltf or .glb file, or export the scene again");
        return std::nullopt;
    }
    return Container{text, std::nullopt};
}

std::optional<uint64_t> count_values(std::string_view json, const SceneLimits& limits, Report& report) {
    if (json.size() > limits.json_bytes) {
        report.error("S107", {},
                     "the JSON has " + std::to_string(json.size()) + " bytes, the limit is " +
                         std::to_string(limits.json_bytes),
                     "store embedded data (data: URIs) in .bin and image files, save the scene as .glb, " +
                         raise_limit_text("scene.jsonBytes"));
        return std::nullopt;
    }
    uint64_t values = 0;
    uint32_t depth = 0;
    bool in_string = false;
    for (size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
            continue;
        }
        if (c == '"') in_string = true;
        if (c == ',' || c == '[' || c == '{') ++values;
        if (c == '[' || c == '{') ++depth;
        if ((c == ']' || c == '}') && depth > 0) --depth;
        if (depth <= limits.json_depth && values <= limits.json_values) continue;
        const TextPosition at = position_of(json, i);
        const bool deep = depth > limits.json_depth;
        report.error_at(
            "S107", at.line, at.column,
            deep ? "the JSON is nested deeper than " + std::to_string(limits.json_depth) + " levels"
                 : "the JSON has more than " + std::to_string(limits.json_values) + " values",
            deep ? "remove deeply nested extras or extensions, " + raise_limit_text("scene.jsonDepth")
                 : "store geometry in binary buffers and split the scene into several files, " +
                       raise_limit_text("scene.jsonValues"));
        return std::nullopt;
    }
    return values;
}

TextPosition position_of(std::string_view text, size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const size_t last_newline = before.rfind('\n');
    const size_t line_start = last_newline == std::string_view::npos ? 0 : last_newline + 1;
    return {static_cast<uint32_t>(1 + std::count(before.begin(), before.end(), '\n')),
            static_cast<uint32_t>(before.size() - line_start + 1)};
}

}  // namespace weft::scene::gltf
