// Purpose: sizes that several panels of the HTML page agree on. Units: pixels of the page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace weft {

// Marks of barriers stand in columns of so many.
inline constexpr size_t kMarkRows = 4;
inline constexpr int32_t kMarkStepX_px = 13;
inline constexpr int32_t kMarkStepY_px = 13;
inline constexpr int32_t kMark_px = 10;
inline constexpr int32_t kLabel_px = 14;  // height of a label of bytes

inline constexpr int32_t kEndColumn_px = 56;
inline constexpr int32_t kRoomyBox_px = 150;    // of a pass, while there are few
inline constexpr int32_t kRoomyWidth_px = 740;  // of all columns together
inline constexpr size_t kMostNameCharacters = 24;
inline constexpr size_t kLeastNameCharacters = 4;  // fewer say nothing

// Of a name in the page's monospaced face, with a margin.
[[nodiscard]] int32_t name_width_px(const std::string& name);
// How wide and high it is when it rises at 45°.
[[nodiscard]] int32_t rotated_label_px(const std::string& name);
// How many characters of that face have room.
[[nodiscard]] size_t characters_in(int32_t width_px);
// Of small text in the page's proportional face: what has room, "" when that is next to nothing.
[[nodiscard]] std::string small_text_in(const std::string& text, int32_t width_px);
// Names are ASCII; longer ones end in an ellipsis.
[[nodiscard]] std::string short_name(const std::string& name, size_t most_characters = kMostNameCharacters);

}  // namespace weft
