// Purpose: what the compiler's worker and its caller say to each other, over one stream socket. A frame is
// the length of its payload as u64, little-endian, and the payload: kind, number, count of texts, texts (see
// shader/payload.h). The worker says hello; then, for each `compile`, it asks for includes one by one and
// ends with `done` or `failed`. Nothing that comes in is believed: frames have a limit, and a payload that
// does not parse is as good as none.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace weft::shader {

enum class MessageKind : uint64_t {
    hello,      // compiler_version()
    compile,    // number: the stage; name, text
    include,    // number: 2 × depth + beside; name, includer
    source,     // name, text
    no_source,  // why
    done,       // SPIR-V, the names of unplaced variables
    failed,     // glslang's log
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

// SPIR-V as bytes, little-endian. Nothing when the bytes are no whole words.
[[nodiscard]] std::string words_to_bytes(const std::vector<uint32_t>& words);
[[nodiscard]] std::optional<std::vector<uint32_t>> bytes_to_words(std::string_view bytes);

}  // namespace weft::shader
