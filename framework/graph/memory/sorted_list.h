// Purpose: a sorted list of keys. The list is divided into short parts, so that an insertion moves few keys,
// and neighbouring keys lie side by side in memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace weft {

template <class Key>
class SortedList {
 public:
    void insert(const Key& key) {
        const size_t at = part_of(key);
        Part& part = parts_[at];
        part.insert(std::ranges::lower_bound(part, key), key);
        if (part.size() <= kMostKeys) return;
        const auto half = part.begin() + static_cast<std::ptrdiff_t>(kMostKeys / 2);
        Part upper(half, part.end());
        part.erase(half, part.end());
        parts_.insert(parts_.begin() + static_cast<std::ptrdiff_t>(at) + 1, std::move(upper));
    }
    // Removes a key that is in the list.
    void erase(const Key& key) {
        const size_t at = part_of(key);
        Part& part = parts_[at];
        part.erase(std::ranges::lower_bound(part, key));
        if (part.empty() && parts_.size() > 1) parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(at));
    }
    // Returns the first key that is not less than `least` and for which accept() returns true, or null.
    template <class Accept>
    [[nodiscard]] const Key* find(const Key& least, const Accept& accept) const {
        size_t at = part_of(least);
        auto key = std::ranges::lower_bound(parts_[at], least);
        while (true) {
            for (; key != parts_[at].end(); ++key)
                if (accept(*key)) return &*key;
            if (++at == parts_.size()) return nullptr;
            key = parts_[at].begin();
        }
    }

 private:
    using Part = std::vector<Key>;
    static constexpr size_t kMostKeys = 128;  // A part of the list with more keys than this is divided.

    // Returns the index of the part that contains the key, or into which it belongs.
    [[nodiscard]] size_t part_of(const Key& key) const {
        if (parts_.size() == 1) return 0;
        const auto next =
            std::ranges::upper_bound(parts_, key, {}, [](const Part& part) { return part.front(); });
        return next == parts_.begin() ? 0 : static_cast<size_t>(next - parts_.begin()) - 1;
    }

    std::vector<Part> parts_{Part{}};  // No part is empty, unless it is the only part.
};

}  // namespace weft
