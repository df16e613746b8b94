// Purpose: visitors that write the fields of plan_fields.h and shader_fields.h as bytes, and read them back.
// Numbers are little-endian with the size of their type; texts and vectors begin with their length.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <typeindex>
#include <vector>

#include "graph/cook/shader_fields.h"
#include "graph/plan/plan_fields.h"

namespace weft {

static_assert(std::endian::native == std::endian::little, "byte_fields.h copies numbers as they are");

template <class T>
inline constexpr bool kIsNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class ByteWriter {
 public:
    template <class T>
    void operator()(const char*, const T& value) {
        add(value);
    }
    [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
    template <class T>
    void add(const std::vector<T>& items) {
        add(uint64_t{items.size()});
        for (const T& item : items) add(item);
    }
    void add(const std::string& text) {
        add(uint64_t{text.size()});
        append(text.data(), text.size());
    }
    template <class T, size_t N>
    void add(const std::array<T, N>& items) {
        for (const T& item : items) add(item);
    }
    template <class T>
    void add(const std::optional<T>& item) {
        add(item.has_value());
        if (item) add(*item);
    }
    template <class T>
    void add(const T& value) {
        if constexpr (kIsNumber<T>)
            append(&value, sizeof value);
        else if constexpr (kIsId<T>)
            add(static_cast<uint32_t>(value));
        else
            visit_fields(*this, value);
    }
    void append(const void* data, size_t size) {
        const auto* first = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), first, first + size);
    }

    std::vector<std::byte> bytes_;
};

// Reads the bytes into the fields of an object. visit_fields() passes the fields as const references, and
// this class removes the const. So the object itself must not be const. If the bytes end too early, the
// remaining fields keep their values and complete() returns false.
class ByteFieldReader {
 public:
    explicit ByteFieldReader(std::span<const std::byte> bytes) : left_(bytes) {}

    template <class T>
    void operator()(const char*, const T& value) {
        read(const_cast<T&>(value));
    }
    // Returns true if all fields were read and no byte is left.
    [[nodiscard]] bool complete() const { return !failed_ && left_.empty(); }

 private:
    template <class T>
    void read(std::vector<T>& items) {
        // Each element takes at least one byte. So read_length() refuses a length above the number of bytes
        // that are left, and a wrong length cannot allocate a huge vector.
        items.resize(read_length());
        for (T& item : items) read(item);
    }
    void read(std::string& text) {
        text.resize(read_length());
        take(text.data(), text.size());
    }
    template <class T, size_t N>
    void read(std::array<T, N>& items) {
        for (T& item : items) read(item);
    }
    template <class T>
    void read(std::optional<T>& item) {
        bool has_value = false;
        read(has_value);
        if (has_value) read(item.emplace());
    }
    template <class T>
    void read(T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            uint8_t byte = 0;
            take(&byte, sizeof byte);
            value = byte != 0;
        } else if constexpr (kIsNumber<T>) {
            take(&value, sizeof value);
        } else if constexpr (kIsId<T>) {
            uint32_t index = 0;
            read(index);
            value = T(index);
        } else {
            visit_fields(*this, value);
        }
    }
    size_t read_length() {
        uint64_t length = 0;
        read(length);
        if (length > left_.size()) failed_ = true;
        return failed_ ? 0 : static_cast<size_t>(length);
    }
    void take(void* data, size_t size) {
        if (size > left_.size()) failed_ = true;
        if (failed_ || size == 0) return;
        std::memcpy(data, left_.data(), size);
        left_ = left_.subspan(size);
    }

    std::span<const std::byte> left_;
    bool failed_ = false;
};

// Collects the names and sizes of all fields, so that bytes of another version of Weft are recognised.
class LayoutText {
 public:
    template <class T>
    void operator()(const char* name, const T& value) {
        text += std::string(name) + ":";
        add(value);
        text += ";";
    }
    std::string text;

 private:
    template <class T>
    void add(const std::vector<T>&) {
        text += "*";
        add(T{});
    }
    void add(const std::string&) { text += "text"; }
    template <class T, size_t N>
    void add(const std::array<T, N>&) {
        text += std::to_string(N) + "*";
        add(T{});
    }
    template <class T>
    void add(const std::optional<T>&) {
        text += "?";
        add(T{});
    }
    template <class T>
    void add(const T& value) {
        if constexpr (kIsNumber<T> || kIsId<T>) text += std::to_string(sizeof value);
        // Lists each struct type only once. Otherwise a struct that contains structs of its own type would be
        // listed without end.
        else if (seen_.insert(std::type_index(typeid(T))).second)
            visit_fields(*this, value);
    }

    std::set<std::type_index> seen_;
};

}  // namespace weft
