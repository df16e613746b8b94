// Purpose: a set of node indices as a bit set that grows when needed. It stores the predecessors of a node.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace weft::null {

class NodeSet {
 public:
    void insert(uint32_t node) {
        const size_t word = node / 64;
        if (word >= words_.size()) words_.resize(word + 1, 0);
        words_[word] |= uint64_t{1} << (node % 64);
    }

    void merge(const NodeSet& other) {
        if (other.words_.size() > words_.size()) words_.resize(other.words_.size(), 0);
        for (size_t i = 0; i < other.words_.size(); ++i) words_[i] |= other.words_[i];
    }

    [[nodiscard]] bool contains(uint32_t node) const {
        const size_t word = node / 64;
        return word < words_.size() && (words_[word] >> (node % 64) & 1) != 0;
    }

    // Calls `visit` for each element of this set that is not in `other`, in ascending order.
    template <class F>
    void for_each_missing(const NodeSet& other, F visit) const {
        for (size_t i = 0; i < words_.size(); ++i) {
            uint64_t left = words_[i] & ~(i < other.words_.size() ? other.words_[i] : 0);
            for (; left != 0; left &= left - 1)
                visit(static_cast<uint32_t>(i * 64 + static_cast<size_t>(std::countr_zero(left))));
        }
    }

 private:
    std::vector<uint64_t> words_;
};

}  // namespace weft::null
