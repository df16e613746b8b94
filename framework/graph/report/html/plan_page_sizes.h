// Purpose: sizes that several sections of the HTML page share. Units: pixels of the page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace weft {

// Maximum number of barrier marks in one vertical stack. More marks need several stacks side by side.
inline constexpr size_t kMarkRows = 4;
inline constexpr int32_t kMarkStepX_px = 13;
inline constexpr int32_t kMarkStepY_px = 13;
inline constexpr int32_t kMark_px = 10;
inline constexpr int32_t kLabel_px = 14;  // Height of a label on the axis of bytes.

inline constexpr int32_t kEndColumn_px = 56;
// Maximum width to which a pass's box is widened in a frame with few passes.
inline constexpr int32_t kRoomyBox_px = 150;
// Width that all columns fill together if there are few passes, unless kRoomyBox_px limits their boxes.
inline constexpr int32_t kRoomyWidth_px = 740;
inline constexpr size_t kMostNameCharacters = 24;
inline constexpr size_t kLeastNameCharacters = 4;  // If fewer characters fit, a name is omitted.

// Returns the width of a name in the page's monospaced font, with a margin.
[[nodiscard]] int32_t name_width_px(const std::string& name);
// Returns the width of a name after a rotation by 45°. This is also the height of the rotated name.
[[nodiscard]] int32_t rotated_label_px(const std::string& name);
// Returns the number of characters in the page's monospaced font that fit into the width.
[[nodiscard]] size_t characters_in(int32_t width_px);
// Returns `text` if it fits into the width in the page's small proportional font. Otherwise returns the
// beginning that fits, with an ellipsis. If this has fewer than kLeastNameCharacters, returns an empty text.
[[nodiscard]] std::string small_text_in(const std::string& text, int32_t width_px);
// Returns the name. If it is longer than `most_characters`, it is cut and ends in an ellipsis. Names must be
// ASCII.
[[nodiscard]] std::string short_name(const std::string& name, size_t most_characters = kMostNameCharacters);

}  // namespace weft
