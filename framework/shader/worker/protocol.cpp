#include "shader/worker/protocol.h"

#include "shader/worker/payload.h"

namespace weft::shader {

std::string to_frame(const Message& message) {
    PayloadWriter body;
    body.number(static_cast<uint64_t>(message.kind));
    body.number(message.number);
    body.number(message.texts.size());
    for (const std::string& text : message.texts) body.text(text);
    PayloadWriter frame;
    frame.text(body.payload());
    return frame.payload();
}

uint64_t payload_bytes(std::string_view header) {
    return PayloadReader(header).number().value_or(0);
}

std::optional<Message> parse_payload(std::string_view payload) {
    PayloadReader reader(payload);
    const auto kind = reader.number();
    const auto number = reader.number();
    const auto count = reader.number();
    if (!count || *kind > static_cast<uint64_t>(MessageKind::failed)) return std::nullopt;
    Message message{static_cast<MessageKind>(*kind), *number, {}};
    for (uint64_t i = 0; i < *count; ++i) {
        const auto text = reader.text();
        if (!text) return std::nullopt;
        message.texts.emplace_back(*text);
    }
    if (!reader.at_end()) return std::nullopt;
    return message;
}

std::string words_to_bytes(const std::vector<uint32_t>& words) {
    std::string bytes;
    bytes.reserve(words.size() * 4);
    for (const uint32_t word : words) {
        for (uint32_t i = 0; i < 4; ++i) bytes += static_cast<char>(static_cast<uint8_t>(word >> (8 * i)));
    }
    return bytes;
}

std::optional<std::vector<uint32_t>> bytes_to_words(std::string_view bytes) {
    if (bytes.size() % 4 != 0) return std::nullopt;
    std::vector<uint32_t> words(bytes.size() / 4);
    for (size_t i = 0; i < bytes.size(); ++i)
        words[i / 4] |= uint32_t{static_cast<uint8_t>(bytes[i])} << (8 * (i % 4));
    return words;
}

}  // namespace weft::shader
