// Purpose: computes the 64-bit FNV-1a hash of bytes, for cache keys and checksums. The hash detects
// accidental changes, but not deliberate ones, so it must not be used for security. Source: Fowler, Noll, Vo,
// "The FNV Non-Cryptographic Hash Algorithm".
#pragma once

#include <cstdint>
#include <string_view>

namespace weft::shader {

class ContentHash {
 public:
    // Adds a text to the hash. The length is hashed, too, so that "ab","c" and "a","bc" give different
    // hashes.
    void add(std::string_view bytes) {
        add(static_cast<uint64_t>(bytes.size()));
        for (const char byte : bytes) mix(static_cast<uint8_t>(byte));
    }
    void add(uint64_t number) {
        for (uint32_t i = 0; i < 8; ++i) mix(static_cast<uint8_t>(number >> (8 * i)));
    }
    [[nodiscard]] uint64_t value() const { return state_; }

 private:
    void mix(uint8_t byte) { state_ = (state_ ^ byte) * 0x100000001b3ull; }

    uint64_t state_ = 0xcbf29ce484222325ull;
};

[[nodiscard]] inline uint64_t hash_of(std::string_view bytes) {
    ContentHash hash;
    hash.add(bytes);
    return hash.value();
}

}  // namespace weft::shader
