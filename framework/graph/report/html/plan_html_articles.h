// Purpose: explanations for the HTML page, one article for each thing that has a key.
#pragma once

#include <string>
#include <vector>

#include "graph/report/html/markup.h"
#include "graph/report/html/plan_page.h"

namespace weft {

void write_repeat_article(const PlanPage& page, size_t repeat, Markup& out);
void write_pass_article(const PlanPage& page, PassId pass, Markup& out);
void write_resource_article(const PlanPage& page, ResourceId resource, Markup& out);
void write_barrier_article(const PlanPage& page, size_t barrier, Markup& out);
void write_wait_article(const PlanPage& page, size_t wait, Markup& out);
void write_batch_article(const PlanPage& page, size_t batch, Markup& out);
void write_edge_article(const PlanPage& page, size_t edge, Markup& out);

// An article with its heading; the caller closes it.
void open_article(Markup& out, const std::string& key, const std::string& title, const std::string& below);
// Lines of an explanation, a paragraph each.
void write_sentences(Markup& out, const std::string& text);
// Links with a heading of their own; nothing when there are none.
struct ArticleLink {
    std::string key;
    std::string text;
    std::string more;  // beside the link
};
void write_links(Markup& out, const char* title, const std::vector<ArticleLink>& links);

}  // namespace weft
