#include "sweep/page.h"

#include <algorithm>
#include <map>

#include "output/text.h"
#include "scene/version.h"
#include "sweep/plots.h"

namespace talus {

namespace {

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<style>
body { font-family: "DejaVu Sans", Verdana, Helvetica, Arial, sans-serif; margin: 24px; color: #222; }
h2 { margin-top: 32px; font-size: 18px; }
.plots { display: flex; flex-wrap: wrap; gap: 12px; }
.plots svg { border: 1px solid #ddd; max-width: 100%; height: auto; }
table { border-collapse: collapse; font-size: 13px; }
th, td { padding: 3px 10px; border-bottom: 1px solid #ddd; text-align: right; white-space: nowrap; }
th { position: sticky; top: 0; background: #fff; cursor: pointer; }
td.text, th.text { text-align: left; }
td.message { white-space: normal; text-align: left; }
tr.bad { background: #fdeeea; }
</style>
)";

// A click on a column's head sorts by it, another one the other way round.
constexpr const char* script = R"(<script>
document.querySelectorAll("th").forEach((head, column) => head.addEventListener("click", () => {
  const body = document.querySelector("tbody"), up = head.dataset.up !== "1";
  head.dataset.up = up ? "1" : "0";
  const text = row => row.cells[column].textContent, number = row => text(row) === "" ? NaN : Number(text(row));
  const rows = [...body.rows].sort((a, b) => {
    const difference = number(a) - number(b);
    return (up ? 1 : -1) * (isNaN(difference) ? text(a).localeCompare(text(b)) : difference);
  });
  body.append(...rows);
}));
</script>
)";

std::string cell(const std::string& text, const char* kind = "") {
  return std::string("<td") + (*kind ? std::string(" class=\"") + kind + "\"" : "") + ">" + escape_xml(text) + "</td>";
}

std::string heading(const std::string& text, const char* kind = "") {
  return std::string("<th") + (*kind ? std::string(" class=\"") + kind + "\"" : "") + ">" + escape_xml(text) + "</th>";
}

std::string table(const Study& study, const std::vector<StudyRow>& rows) {
  std::string html = "<table>\n<thead><tr>" + heading("run", "text");
  for (const std::string& name : study.parameters) html += heading(name);
  html += heading("status", "text");
  for (std::size_t c = 0; c < study.columns.size(); ++c) {
    const std::string unit = unit_of(study, rows, c);
    html += heading(study.columns[c].name + (unit.empty() ? "" : " [" + unit + "]"));
  }
  html += heading("wall [s]") + heading("message", "text") + "</tr></thead>\n<tbody>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const StudyRow& row = rows[r];
    const std::string name = escape_xml(study.runs[r].name);
    html += std::string("<tr") + (row.good() ? "" : " class=\"bad\"") + "><td class=\"text\"><a href=\"runs/" + name +
            "/\">" + name + "</a></td>";
    for (const std::string& parameter : study.parameters) {
      const Setting* setting = setting_of(study.runs[r], parameter);
      html += cell(setting ? setting->text : "");
    }
    html += cell(row.status(), "text");
    for (std::size_t c = 0; c < study.columns.size(); ++c) {
      const bool there = c < row.collected.cells.size();
      const Cell value = there ? row.collected.cells[c] : Cell{};
      html += cell(std::isfinite(value.number) ? significant(value.number, 6) : value.text);
    }
    html += cell(row.outcome ? fixed(row.outcome->wall, 2) : "") + cell(row.message(), "message") + "</tr>\n";
  }
  return html + "</tbody>\n</table>\n";
}

// In one document the definitions of two pictures must not have one name.
std::string with_own_names(std::string svg, int number) {
  for (const std::string mark : {"id=\"bar\"", "url(#bar)"})
    for (std::size_t at = 0; (at = svg.find(mark, at)) != std::string::npos; at += mark.size())
      svg.insert(at + mark.size() - 1, std::to_string(number));
  return svg;
}

std::string summary(const Study& study, const std::vector<StudyRow>& rows) {
  std::map<std::string, std::size_t> counts;
  double cpu = 0;
  for (const StudyRow& row : rows) {
    ++counts[row.status()];
    if (row.outcome) cpu += row.outcome->cpu;
  }
  std::string text = std::to_string(rows.size()) + " runs of " + study.scene + ":";
  for (const auto& [status, count] : counts) text += " " + std::to_string(count) + " " + status + ",";
  return text + " " + fixed(cpu, 1) + " s CPU; Talus " + version + " (" + commit + ")";
}

}  // namespace

std::string results_page(const Study& study, const std::vector<StudyRow>& rows) {
  std::string html = std::string(head) + "<title>" + escape_xml(study.title) + "</title>\n</head>\n<body>\n<h1>" +
                     escape_xml(study.title) + "</h1>\n<p>" + escape_xml(summary(study, rows)) +
                     ". Values: <a href=\"results.csv\">results.csv</a></p>\n";
  int number = 0;
  for (const ColumnPlots& plots : plots_of(study, rows)) {
    html += "<h2>" + escape_xml(plots.column) + "</h2>\n<div class=\"plots\">\n";
    for (const std::string& svg : plots.svgs) html += with_own_names(svg, ++number);
    html += "</div>\n";
    if (plots.left_out > 0)
      html += "<p>" + std::to_string(plots.left_out) + " more combinations are in the table only.</p>\n";
  }
  return html + "<h2>Runs</h2>\n" + table(study, rows) + script + "</body>\n</html>\n";
}

}  // namespace talus
