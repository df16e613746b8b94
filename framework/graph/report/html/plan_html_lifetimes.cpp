// Draws the lifetimes section: one row per live resource, with the range of passes in which the resource
// lives and a cell for each live pass that uses it.
#include <algorithm>

#include "graph/diagnostics/quantity_text.h"
#include "graph/plan/plan_names.h"
#include "graph/report/html/html_sections.h"
#include "graph/report/html/plan_page_sizes.h"
#include "graph/report/plan_phrases.h"
#include "weft/report/memory_report.h"

namespace weft {
namespace {

constexpr int32_t kRow_px = 26;
constexpr int32_t kCell_px = 18;

struct Row {
    ResourceId resource = kNoId;
    Position first = 0;
    Position last = 0;
    bool unread = false;
};

// Returns the rows: first transients sorted by first use, then persistent resources, then imports.
std::vector<Row> make_rows(const PlanPage& page) {
    const FramePlan& plan = *page.plan;
    std::vector<Row> rows;
    const Position end(plan.schedule.order.size() - 1);
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id) {
        if (!plan.live.live_resources[id]) continue;
        const LifetimeSpan& span = plan.lifetimes.spans[id];
        const bool frame = plan.graph.resources[id].lifetime != ResourceLifetime::transient;
        if (!frame && span.first > span.last) continue;
        const bool unread = has_no_reader(page, id);
        rows.push_back(frame ? Row{id, Position(0), end, unread} : Row{id, span.first, span.last, unread});
    }
    std::stable_sort(rows.begin(), rows.end(), [&](const Row& a, const Row& b) {
        const ResourceLifetime x = plan.graph.resources[a.resource].lifetime,
                               y = plan.graph.resources[b.resource].lifetime;
        return x != y ? x < y : a.first < b.first;
    });
    return rows;
}

class LifetimeDrawing : ColumnDrawing {
 public:
    LifetimeDrawing(const PlanPage& page, Markup& out) : ColumnDrawing(page, out), rows_(make_rows(page)) {}

    [[nodiscard]] bool shows_unread() const {
        return std::any_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.unread; });
    }

    void draw() {
        const int32_t height_px = top_px_ + static_cast<int32_t>(rows_.size()) * kRow_px + 6;
        out_.open("div", {{"class", "chart"}});
        write_labels();
        open_columns("Lifetimes of resources", height_px);
        for (size_t row = 0; row < rows_.size(); ++row)
            draw_row(rows_[row], top_px_ + static_cast<int32_t>(row) * kRow_px);
        close_drawing(out_);
        out_.close();
    }

 private:
    void write_labels() {
        open_labels("labels rows");
        for (const Row& row : rows_) {
            const ResourceDecl& resource = plan_.graph.resources[row.resource];
            const uint64_t bytes = placed_bytes(plan_, row.resource);
            const std::string size =
                bytes > 0 ? bytes_text(bytes) : std::string(enum_name(resource.lifetime));
            out_.open("li");
            open_item(out_, row.unread ? "row unread" : "row", resource_keys(page_, row.resource),
                      resource.name + ", " + size + (row.unread ? ", no reader" : ""));
            out_.leaf("b", {}, resource.name);
            out_.leaf("small", {}, row.unread ? "no reader" : size);
            out_.close();
            out_.close();
        }
        out_.close();
        out_.line();
    }

    void draw_row(const Row& row, int32_t y_px) {
        const ResourceDecl& resource = plan_.graph.resources[row.resource];
        const bool frame = resource.lifetime != ResourceLifetime::transient;
        const PageColumn &first = page_.columns.passes[row.first], &last = page_.columns.passes[row.last];
        const int32_t left_px = frame ? 2 : first.box_left_px,
                      right_px = frame ? page_.columns.width_px - 2 : last.box_left_px + last.box_width_px;
        const std::string text =
            frame ? std::string(enum_name(resource.lifetime)) + ", alive longer than a frame"
                  : "alive from " + pass_at(plan_, row.first) + " to " + pass_at(plan_, row.last);
        const std::string style =
            std::string("life") + (frame ? " long" : "") + (row.unread ? " unread" : "");
        open_item(out_, style, resource_keys(page_, row.resource),
                  resource.name + ": " + text + (row.unread ? ", no reader: no running pass reads it" : ""));
        draw_box(out_, "hit", {left_px, y_px + 2, right_px - left_px, kRow_px - 4});
        // If no pass reads the resource, its bar is nearly as high as the row and looks like a border. A
        // normal, thinner bar would be hidden behind the cell if only one pass uses the resource.
        const int32_t bar_px = row.unread ? kRow_px - 4 : 8, over_px = row.unread && !frame ? 3 : 0;
        draw_box(out_, "bar",
                 {left_px - over_px, y_px + (kRow_px - bar_px) / 2, right_px - left_px + 2 * over_px, bar_px},
                 4);
        out_.close();
        for (const PassId pass : page_.users[row.resource])
            if (plan_.live.live_passes[pass]) draw_cell(row.resource, pass, y_px);
        out_.line();
    }

    void draw_cell(ResourceId resource, PassId pass, int32_t y_px) {
        const PageColumn& column = page_.columns.passes[plan_.schedule.position[pass]];
        bool reading = false, writing = false;
        std::string label = plan_.graph.passes[pass].name;
        for (const UseDecl& use : plan_.graph.passes[pass].uses) {
            if (use.resource != resource) continue;
            reading = reading || reads(use.access);
            writing = writing || writes(use.access);
            std::string part = describe_part(plan_, resource, use.range);
            part.erase(std::remove(part.begin(), part.end(), '"'), part.end());
            label += std::string(label == plan_.graph.passes[pass].name ? " " : ", ") +
                     access_verb(use.access) + " " + part + " (" + use.port + ": " + access_name(use.access) +
                     ")";
        }
        const char* style = reading && writing ? "cell both" : writing ? "cell write" : "cell read";
        open_item(out_, style, resource_key(resource) + " " + pass_key(pass), label);
        const int32_t top_px = y_px + (kRow_px - kCell_px) / 2;
        draw_box(out_, "mark", {column.box_left_px, top_px, column.box_width_px, kCell_px}, 3);
        out_.leaf("text",
                  {{"class", "mid"}, {"x", column.box_left_px + column.box_width_px / 2}, {"y", top_px + 13}},
                  reading && writing ? "RW"
                  : writing          ? "W"
                                     : "R");
        out_.close();
    }

    std::vector<Row> rows_;
};

}  // namespace

void write_lifetimes(const PlanPage& page, Markup& out) {
    std::vector<std::pair<const char*, const char*>> legend{{"cell write", "W writes"},
                                                            {"cell read", "R reads"},
                                                            {"cell both", "RW reads and writes, in place"},
                                                            {"life", "alive, but not used by this pass"},
                                                            {"life long", "alive longer than a frame"}};
    if (open_column_panel(
            page, out, "lifetimes", "Lifetimes",
            "The lifetime of each resource, from its first to its last pass, and how each pass uses it. "
            "Kept and imported resources live longer than the frame.")) {
        LifetimeDrawing drawing(page, out);
        drawing.draw();
        if (drawing.shows_unread()) legend.emplace_back("life unread", "written, but never read");
    }
    write_legend(out, legend);
    out.close();
}

}  // namespace weft
