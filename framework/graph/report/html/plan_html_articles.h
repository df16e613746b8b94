// Purpose: writes the explanations of the HTML page. Each pass, resource, barrier, wait, batch, edge and
// repeat has one article.
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

// Opens an article with its heading. `below` is a line below the heading; empty: no line. The caller must
// close the article.
void open_article(Markup& out, const std::string& key, const std::string& title, const std::string& below);
// Writes each line of an explanation as a paragraph.
void write_sentences(Markup& out, const std::string& text);
// A link to another article of the page.
struct ArticleLink {
    std::string key;
    std::string text;
    std::string more;  // Text that follows the link.
};
void write_links(Markup& out, const char* title, const std::vector<ArticleLink>& links);

}  // namespace weft
