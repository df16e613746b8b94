// Purpose: computes a 64-bit hash (XXH3) of bytes, for cache keys and checksums. The hash detects accidental
// changes, but not deliberate ones, so it must not be used for security.
#pragma once

#include <xxhash.h>

#include <cstdint>
#include <memory>
#include <string_view>

namespace weft::shader {

class ContentHash {
 public:
    ContentHash() { XXH3_64bits_reset(state_.get()); }
    // Adds a text to the hash. The length is hashed, too, so that "ab","c" and "a","bc" give different
    // hashes.
    void add(std::string_view bytes) {
        add(static_cast<uint64_t>(bytes.size()));
        XXH3_64bits_update(state_.get(), bytes.data(), bytes.size());
    }
    void add(uint64_t number) { XXH3_64bits_update(state_.get(), &number, sizeof number); }
    [[nodiscard]] uint64_t value() const { return XXH3_64bits_digest(state_.get()); }

 private:
    struct FreeState {
        void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
    };
    std::unique_ptr<XXH3_state_t, FreeState> state_{XXH3_createState()};
};

[[nodiscard]] inline uint64_t hash_of(std::string_view bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace weft::shader
