#include "graph/memory/alias_owners.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace weft {
namespace {

constexpr size_t kMostRanges = 64;  // A part of the list with more ranges than this is divided.

}  // namespace

size_t OwnerMap::part_at(uint64_t begin) const {
    if (parts_.size() == 1) return 0;
    const auto next =
        std::ranges::upper_bound(parts_, begin, {}, [](const Part& part) { return part.front().begin; });
    return next == parts_.begin() ? 0 : static_cast<size_t>(next - parts_.begin()) - 1;
}

void OwnerMap::take(uint64_t begin, uint64_t end, Owner owner, std::vector<Owner>& old_owners) {
    const size_t at = part_at(begin);
    const auto first = std::ranges::upper_bound(parts_[at], begin, {}, &Range::end);
    const auto first_index = static_cast<size_t>(first - parts_[at].begin());
    // The ranges that replace the old ones: the rest of the first old range, the new range, and the rest of
    // the last old range.
    std::array<Range, 3> fresh;
    size_t fresh_count = 0;
    if (first != parts_[at].end() && first->begin < begin)
        fresh[fresh_count++] = {first->begin, begin, first->owner};
    fresh[fresh_count++] = {begin, end, owner};
    size_t replaced = 0, emptied = 0;
    for (size_t p = at; p < parts_.size(); ++p) {
        Part& part = parts_[p];
        const size_t from = p == at ? first_index : 0;
        size_t to = from;
        for (; to < part.size() && part[to].begin < end; ++to) {
            old_owners.push_back(part[to].owner);
            if (part[to].end > end) fresh[fresh_count++] = {end, part[to].end, part[to].owner};
        }
        if (p == at)
            replaced = to - from;
        else if (to == part.size())
            ++emptied;
        else
            part.erase(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(to));
        if (to < part.size()) break;
    }
    const auto next = parts_.begin() + static_cast<std::ptrdiff_t>(at) + 1;
    parts_.erase(next, next + static_cast<std::ptrdiff_t>(emptied));
    Part& part = parts_[at];
    const size_t same = std::min(replaced, fresh_count);
    const auto place =
        std::copy_n(fresh.begin(), same, part.begin() + static_cast<std::ptrdiff_t>(first_index));
    if (replaced > same) part.erase(place, place + static_cast<std::ptrdiff_t>(replaced - same));
    if (fresh_count > same)
        part.insert(place, fresh.begin() + static_cast<std::ptrdiff_t>(same),
                    fresh.begin() + static_cast<std::ptrdiff_t>(fresh_count));
    if (part.size() > kMostRanges) divide(at);
}

void OwnerMap::divide(size_t part) {
    const auto half = parts_[part].begin() + static_cast<std::ptrdiff_t>(kMostRanges / 2);
    Part upper(half, parts_[part].end());
    parts_[part].erase(half, parts_[part].end());
    parts_.insert(parts_.begin() + static_cast<std::ptrdiff_t>(part) + 1, std::move(upper));
}

}  // namespace weft
