// Purpose: the messages between compiler worker and caller, over one stream socket. A frame is the length of
// its payload as u64, little-endian, followed by the payload: kind, number, count of texts, texts (see
// shader/payload.h). The worker starts with `hello`. For each `compile` it requests includes one by one and
// ends with `done` or `failed`. No side trusts its input: frames have a maximum size, and a malformed payload
// is treated like a missing one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace weft::shader {

enum class MessageKind : uint64_t {
    hello,      // text: compiler_version()
    compile,    // number: the stage; texts: name, source text
    include,    // number: 2 × depth + beside; texts: name, includer
    source,     // texts: name, source text
    no_source,  // text: the reason
    done,       // texts: SPIR-V, then the names of unplaced variables
    failed,     // text: glslang's log
};

struct Message {
    MessageKind kind = MessageKind::hello;
    uint64_t number = 0;
    std::vector<std::string> texts;
};

inline constexpr size_t kFrameHeaderBytes = 8;
inline constexpr int kOutOfMemoryExit = 86;  // the worker's exit code when an allocation fails
inline constexpr size_t kMostLogBytes = 64 << 10;

[[nodiscard]] std::string to_frame(const Message& message);
[[nodiscard]] uint64_t payload_bytes(std::string_view header);
[[nodiscard]] std::optional<Message> parse_payload(std::string_view payload);

// SPIR-V as bytes, little-endian. bytes_to_words() returns nullopt when the size is not a multiple of 4.
[[nodiscard]] std::string words_to_bytes(const std::vector<uint32_t>& words);
[[nodiscard]] std::optional<std::vector<uint32_t>> bytes_to_words(std::string_view bytes);

}  // namespace weft::shader
