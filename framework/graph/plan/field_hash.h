// Purpose: hashes the fields of a plan in the order of plan_fields.h with XXH3 (128 bits). The length of each
// vector and text is hashed before its content, so that the vectors [1, 2] and [3] do not give the same bytes
// as [1] and [2, 3]. The result is a text of 32 hexadecimal digits.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <xxhash.h>

#include "graph/plan/plan_fields.h"

namespace weft {

class HashVisitor {
 public:
    explicit HashVisitor(XXH3_state_t* state) : state_(state) {}

    template <class T>
    void operator()(const char*, const T& value) {
        // A ParamCost only tells how much work a change of a parameter causes. It changes nothing else in
        // the plan, so it is not hashed.
        if constexpr (!std::is_same_v<T, ParamCost>) add(value);
    }

    // Hashes the bytes that are still in the buffer. The caller must call this once, after all fields.
    void finish() { flush(); }

 private:
    // Adds a word in little-endian order on every platform, so that hashes are equal everywhere. Words and
    // short texts are collected in a buffer, because each call of XXH3_128bits_update has a fixed cost.
    void word(uint64_t value) {
        if (words_.size() - used_ < sizeof(value)) flush();
        if constexpr (std::endian::native == std::endian::little)
            std::memcpy(words_.data() + used_, &value, sizeof(value));
        else
            for (size_t i = 0; i < sizeof(value); ++i)
                words_[used_ + i] = static_cast<unsigned char>(value >> (8 * i));
        used_ += sizeof(value);
    }

    void flush() {
        XXH3_128bits_update(state_, words_.data(), used_);
        used_ = 0;
    }

    void add(const std::string& text) {
        word(text.size());
        if (words_.size() - used_ < text.size()) flush();
        if (words_.size() < text.size()) {
            XXH3_128bits_update(state_, text.data(), text.size());
            return;
        }
        std::copy(text.begin(), text.end(), words_.begin() + static_cast<std::ptrdiff_t>(used_));
        used_ += text.size();
    }
    template <class T>
    void add(const std::vector<T>& items) {
        word(items.size());
        for (const T& item : items) add(item);
    }
    void add(const ClockTable& clocks) {
        word(clocks.size());
        for (Position position(0); position < clocks.size(); ++position) {
            word(clocks.queue_count);
            for (const uint32_t clock : clocks[position]) word(clock);
        }
    }
    template <class T, size_t N>
    void add(const std::array<T, N>& items) {
        for (const T& item : items) add(item);
    }
    template <class T>
    void add(const std::optional<T>& item) {
        word(item.has_value() ? 1 : 0);
        if (item) add(*item);
    }
    template <class T>
    void add(const T& value) {
        if constexpr (std::is_same_v<T, double>)
            word(std::bit_cast<uint64_t>(value));
        else if constexpr (std::is_same_v<T, float>)
            word(std::bit_cast<uint32_t>(value));
        else if constexpr (std::is_integral_v<T> || std::is_enum_v<T> || kIsId<T>)
            word(static_cast<uint64_t>(value));
        else
            visit_fields(*this, value);
    }

    XXH3_state_t* state_;
    std::array<unsigned char, 4096> words_{};
    size_t used_ = 0;
};

struct FreeHashState {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

template <class Visit>
std::string hash_fields(Visit visit) {
    const std::unique_ptr<XXH3_state_t, FreeHashState> state(XXH3_createState());
    XXH3_128bits_reset(state.get());
    HashVisitor visitor(state.get());
    visit(visitor);
    visitor.finish();
    const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
    std::array<char, 33> text{};
    std::snprintf(text.data(), text.size(), "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return text.data();
}

}  // namespace weft
