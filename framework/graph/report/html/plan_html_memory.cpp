// Draws the memory section: each transient as a block, with its bytes in the heap vertically and its lifetime
// horizontally.
#include <algorithm>

#include "graph/diagnostics/quantity_text.h"
#include "graph/report/html/html_sections.h"
#include "graph/report/html/plan_page_bytes.h"
#include "graph/report/html/plan_page_sizes.h"

namespace weft {
namespace {

constexpr int32_t kStrip_px = 44;  // Height of the bar chart that shows the live bytes per pass.
constexpr int32_t kHeapGap_px = 34;
constexpr size_t kHues = 8;

class MemoryDrawing {
 public:
    MemoryDrawing(const PlanPage& page, Markup& out)
        : page_(page), plan_(*page.plan), out_(out), heading_px_(heading_height_px(page)) {
        for (uint32_t h = 0; h < plan_.memory.heaps.size(); ++h)
            if (!plan_.memory.heaps[h].persistent) heaps_.push_back(h);
        scales_ = make_byte_scales(plan_.memory, heaps_);
        int32_t y_px = heading_px_ + kStrip_px;
        for (size_t h = 0; h < heaps_.size(); ++h) {
            blocks_.push_back(place_blocks(plan_, heaps_[h], scales_[h]));
            tops_px_.push_back(y_px + kHeapGap_px);
            y_px = tops_px_.back() + scales_[h].height_px;
        }
        height_px_ = y_px + 8;
    }

    [[nodiscard]] bool empty() const { return heaps_.empty(); }
    [[nodiscard]] bool enlarges() const {
        return std::any_of(blocks_.begin(), blocks_.end(), [](const std::vector<BlockPlace>& of_heap) {
            return !of_heap.empty() && of_heap.back().enlarged;
        });
    }

    void draw() {
        out_.open("div", {{"class", "chart"}});
        write_labels();
        open_drawing(out_, "Memory of transient resources", page_.columns.width_px, height_px_);
        write_heading(page_, out_);
        write_guides(page_, heading_px_, height_px_, out_);
        draw_strip();
        for (size_t h = 0; h < heaps_.size(); ++h) draw_heap(h);
        close_drawing(out_);
        out_.close();
    }

 private:
    void write_label(int32_t y_px, const char* style, const std::string& text) {
        out_.leaf("li", {{"class", style}, {"style", "top:" + std::to_string(y_px) + "px"}}, text);
    }

    void write_labels() {
        out_.open("ol", {{"class", "labels bytes"}});
        write_label(heading_px_ + 8, "strong", "alive");
        write_label(heading_px_ + 24, "", "peak " + bytes_text(plan_.memory.peak_live_bytes));
        for (size_t h = 0; h < heaps_.size(); ++h) {
            const HeapPlan& heap = plan_.memory.heaps[heaps_[h]];
            write_label(tops_px_[h] - 24, "strong",
                        "heap " + std::to_string(heaps_[h]) + (heap.buffers ? ", buffers" : ""));
            for (const ByteTick& tick : byte_ticks(scales_[h]))
                write_label(tops_px_[h] + tick.y_px - kLabel_px / 2, "", tick.text);
        }
        out_.close();
        out_.line();
    }

    // Draws a bar for each pass: the number of bytes that are alive while the pass runs.
    void draw_strip() {
        for (Position p(0); p < plan_.schedule.order.size(); ++p) {
            uint64_t alive_bytes = 0;
            for (const Placement& placement : plan_.memory.placements) {
                const LifetimeSpan& span = plan_.lifetimes.spans[placement.resource];
                if (span.first <= p && p <= span.last) alive_bytes += placement.size_bytes;
            }
            const uint64_t most = std::max<uint64_t>(1, plan_.memory.peak_live_bytes);
            const auto height_px = static_cast<int32_t>(static_cast<double>(std::min(alive_bytes, most)) /
                                                        static_cast<double>(most) * (kStrip_px - 6));
            const PageColumn& column = page_.columns.passes[p];
            const PassId pass = plan_.schedule.order[p];
            open_item(out_, p == plan_.memory.peak_position ? "alive peak" : "alive", pass_keys(page_, pass),
                      bytes_text(alive_bytes) + " alive at " + std::to_string(p) + " " +
                          plan_.graph.passes[pass].name);
            draw_box(out_, "mark",
                     {column.left_px, heading_px_ + kStrip_px - height_px, column.width_px,
                      std::max(1, height_px)});
            out_.close();
        }
        out_.line();
    }

    void draw_heap(size_t index) {
        const int32_t top_px = tops_px_[index], right_px = page_.columns.width_px - 1;
        draw_box(out_, "heap", {1, top_px, right_px - 1, scales_[index].height_px});
        std::string lines;
        for (const ByteTick& tick : byte_ticks(scales_[index]))
            lines += "M1 " + std::to_string(top_px + tick.y_px) + "H" + std::to_string(right_px);
        out_.empty("path", {{"class", "tick"}, {"d", lines}});
        size_t hue = 0;
        for (const BlockPlace& block : blocks_[index]) draw_block(block, top_px, hue++ % kHues);
        out_.line();
    }

    void draw_block(const BlockPlace& block, int32_t heap_px, size_t hue) {
        const Placement& p = *block.placement;
        const LifetimeSpan& span = plan_.lifetimes.spans[p.resource];
        const PageColumn &first = page_.columns.passes[span.first], &last = page_.columns.passes[span.last];
        const int32_t left_px = first.left_px, width_px = last.left_px + last.width_px - left_px;
        const int32_t top_px = heap_px + block.top_px;
        const std::string& name = plan_.graph.resources[p.resource].name;
        const std::string size = bytes_text(p.size_bytes);
        open_item(out_, "block h" + std::to_string(hue) + (block.enlarged ? " enlarged" : ""),
                  resource_keys(page_, p.resource),
                  name + ": " + size + " at " + bytes_text(p.offset_bytes) + ", from " +
                      pass_at(plan_, span.first) + " to " + pass_at(plan_, span.last) +
                      (block.enlarged ? ", drawn larger than its real size" : ""));
        draw_box(out_, "mark", {left_px, top_px, width_px, block.height_px - 1}, block.enlarged ? 0 : 3);
        const std::string both = name + "  " + size;
        const size_t fits = characters_in(width_px - 14);
        if (block.height_px >= 15 && fits >= kLeastNameCharacters)
            out_.leaf("text",
                      {{"class", "name"},
                       {"x", left_px + 7},
                       {"y", top_px + std::min(block.height_px / 2 + 4, 19)}},
                      both.size() <= fits ? both : short_name(name, fits));
        out_.close();
    }

    const PlanPage& page_;
    const FramePlan& plan_;
    Markup& out_;
    int32_t heading_px_;
    int32_t height_px_ = 0;
    std::vector<uint32_t> heaps_;
    std::vector<ByteScale> scales_;
    std::vector<std::vector<BlockPlace>> blocks_;
    std::vector<int32_t> tops_px_;
};

}  // namespace

void write_memory(const PlanPage& page, Markup& out) {
    MemoryDrawing drawing(page, out);
    open_panel(
        out, "memory", "Memory",
        "Where each transient resource lies in memory, and during which passes. Blocks at the same height "
        "share bytes. Heights are to scale, from the axis of each heap.");
    const bool none = drawing.empty() || page.plan->schedule.order.empty();
    if (none)
        out.leaf("p", {{"class", "none"}}, "The frame has no transient resources.");
    else
        drawing.draw();
    if (!none && drawing.enlarges())
        write_legend(out, {{"enlarged", "too small to see: drawn larger than its real size"}});
    out.close();
}

}  // namespace weft
