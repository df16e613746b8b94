// Purpose: types for indices of different tables, so that the index of a pass cannot be used as the index of
// a resource. An Id converts to a number implicitly, so that it can be the index of an element in a vector. A
// number must be converted to an Id explicitly, except a constant of type int.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>

namespace weft {

// The type of kNoId, which means "none" for each Id, and also for plain indices.
struct NoId {
    constexpr operator uint32_t() const { return UINT32_MAX; }
};
inline constexpr NoId kNoId;

// `Table` only makes the type different from other Ids.
template <class Table>
class Id {
 public:
    constexpr Id() = default;
    constexpr Id(NoId) {}
    // A constant of type int converts implicitly, so that tables of ids are easy to read. A variable does
    // not.
    template <std::same_as<int> Index>
    consteval Id(Index index) : index_(static_cast<uint32_t>(index)) {}
    template <std::integral Index>
    requires(!std::same_as<Index, int>) explicit constexpr Id(Index index)
        : index_(static_cast<uint32_t>(index)) {}
    // No conversion from the Id of another table.
    template <class Other>
    Id(Id<Other>) = delete;

    constexpr operator uint32_t() const { return index_; }
    constexpr Id& operator++() {
        ++index_;
        return *this;
    }

    friend constexpr bool operator==(Id a, Id b) { return a.index_ == b.index_; }
    friend constexpr auto operator<=>(Id a, Id b) { return a.index_ <=> b.index_; }
    friend constexpr bool operator==(Id a, NoId) { return a.index_ == kNoId; }
    friend constexpr bool operator==(Id a, std::integral auto b) {
        return a.index_ == static_cast<uint32_t>(b);
    }
    friend constexpr auto operator<=>(Id a, std::integral auto b) {
        return a.index_ <=> static_cast<uint32_t>(b);
    }
    template <class Other>
    friend bool operator==(Id, Id<Other>) = delete;

 private:
    uint32_t index_ = kNoId;
};

template <class T>
inline constexpr bool kIsId = false;
template <class Table>
inline constexpr bool kIsId<Id<Table>> = true;

}  // namespace weft
