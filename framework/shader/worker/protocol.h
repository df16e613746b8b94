// Purpose: the messages between the shader worker and its caller, over a stream socket. A frame is the length
// of its payload as u64, little-endian, followed by the payload: kind, number, count of texts, texts (see
// framework/shader/worker/payload.h). The worker first sends `hello`. After each `compile`, the worker
// requests the included files one by one with `include`, and ends with `done` or `failed`. Neither side
// trusts its input: the size of a payload is limited, and after a malformed payload the worker ends or is
// killed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace weft::shader {

enum class MessageKind : uint64_t {
    hello,    // The worker has started. Text: compiler_version().
    compile,  // Request to compile. Number: the stage; texts: name and source text.
    // The worker asks for an included file. Number: 2 × IncludeRequest::depth, plus 1 for #include "x";
    // texts: the name in the #include, and the name of the including file.
    include,
    source,     // Answer to `include`. Texts: name and source text.
    no_source,  // Answer to `include`: the file cannot be included. Text: the reason.
    done,       // The stage compiled. Texts: SPIR-V, then names of inputs and outputs without a location.
    failed,     // The stage did not compile. Text: log of glslang.
};

struct Message {
    MessageKind kind = MessageKind::hello;
    uint64_t number = 0;
    std::vector<std::string> texts;
};

inline constexpr size_t kFrameHeaderBytes = 8;
inline constexpr int kOutOfMemoryExit = 86;  // Exit code of the worker when an allocation fails.
// Maximum size of the log in `failed`. The rest of a longer log is cut off.
inline constexpr size_t kMostLogBytes = 64 << 10;

[[nodiscard]] std::string to_frame(const Message& message);
[[nodiscard]] uint64_t payload_bytes(std::string_view header);
[[nodiscard]] std::optional<Message> parse_payload(std::string_view payload);

// Converts SPIR-V to bytes, little-endian. bytes_to_words() returns nullopt if the number of bytes is not a
// multiple of four.
[[nodiscard]] std::string words_to_bytes(const std::vector<uint32_t>& words);
[[nodiscard]] std::optional<std::vector<uint32_t>> bytes_to_words(std::string_view bytes);

}  // namespace weft::shader
