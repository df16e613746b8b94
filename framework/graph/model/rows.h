// Purpose: stores many short lists of items in two flat arrays, so that a table of lists needs two
// allocations, however many lists it has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace weft {

// A list of rows, each a list of items. All rows are stored one after another in `items`.
template <class Item>
struct Rows {
    std::vector<uint32_t> offsets{0};  // Row r consists of items[offsets[r]] to items[offsets[r + 1] - 1].
    std::vector<Item> items;

    [[nodiscard]] std::span<const Item> operator[](uint32_t row) const {
        return std::span(items).subspan(offsets[row], offsets[row + 1] - offsets[row]);
    }
    [[nodiscard]] size_t size() const { return offsets.size() - 1; }
};

// Builds rows with a counting sort. `visit` is called twice, each time with a function add(row, item). In
// both calls, `visit` must call add() for the same items in the same order. The items of one row keep that
// order.
template <class Item, class Visit>
[[nodiscard]] Rows<Item> make_rows(size_t row_count, const Visit& visit) {
    Rows<Item> rows;
    rows.offsets.assign(row_count + 1, 0);
    visit([&](uint32_t row, const Item&) { ++rows.offsets[row + 1]; });
    std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
    rows.items.resize(rows.offsets.back());
    std::vector<uint32_t> next(rows.offsets.begin(), rows.offsets.end() - 1);
    visit([&](uint32_t row, const Item& item) { rows.items[next[row]++] = item; });
    return rows;
}

}  // namespace weft
