// Purpose: small binary files that are either whole or ignored. Layout, little-endian:
//   8 bytes magic "WEFTSHD1" | u64 payload length | u64 hash of the payload | payload
// Written beside their place and renamed into it, so a reader never meets half a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace weft::shader {

// The payload; nothing when the file is absent, cut short, damaged or larger than 64 MiB.
[[nodiscard]] std::optional<std::string> read_sealed(const std::filesystem::path& file);

// A cache that cannot be written is no error: the next run compiles again.
void write_sealed(const std::filesystem::path& file, std::string_view payload);

class PayloadWriter {
 public:
    void number(uint64_t value);
    void text(std::string_view value);
    [[nodiscard]] const std::string& payload() const { return payload_; }

 private:
    std::string payload_;
};

// Every read past the end fails, and so do all after it.
class PayloadReader {
 public:
    explicit PayloadReader(std::string_view payload) : rest_(payload) {}

    [[nodiscard]] std::optional<uint64_t> number();
    [[nodiscard]] std::optional<std::string_view> text();
    [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
    std::string_view rest_;
};

}  // namespace weft::shader
