#include "output/report_page.h"

#include <algorithm>
#include <cmath>

#include "output/axis.h"
#include "output/text.h"
#include "output/versions.h"
#include "output/view_pack.h"
#include "step/energy_terms.h"

namespace talus {

namespace {

constexpr const char* style = R"(
body { max-width: 1100px; margin: 1.5em auto; padding: 0 1em; font: 14px/1.5 "DejaVu Sans", Verdana, Helvetica, Arial, sans-serif; color: #222; }
h1 { font-size: 1.5em; margin-bottom: .1em; }
h2 { font-size: 1.15em; margin-top: 1.6em; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; } td, th { padding: 2px 14px 2px 0; text-align: left; vertical-align: top; }
td.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.pass { color: #1a7f37; } .fail { color: #b30000; font-weight: bold; }
img { max-width: 100%; } figure { margin: .4em 0; }
.plots { display: grid; grid-template-columns: 1fr 1fr; gap: .4em 1em; }
figcaption, .quiet { color: #555; } code { font-size: .95em; }
.part { background: #0072b2; height: 11px; display: inline-block; }
)";

class Page {
 public:
  void head(const std::string& text) { body_ += "<h2>" + escape_xml(text) + "</h2>\n"; }
  void raw(const std::string& html) { body_ += html; }
  void begin_table() { body_ += "<table>\n"; }
  void end_table() { body_ += "</table>\n"; }
  void row(const std::string& name, const std::string& value) {
    body_ += "<tr><td>" + escape_xml(name) + "</td><td class=\"n\">" + escape_xml(value) + "</td></tr>\n";
  }
  const std::string& body() const { return body_; }

 private:
  std::string body_;
};

// "12.3 s"; "0 J/m", not "0 pJ/m"
std::string shown(double value, const std::string& unit, int digits = 4) {
  return value == 0 ? "0 " + unit : quantity(value, unit, digits);
}

void add_checks(Page& page, const std::vector<CheckLine>& checks) {
  if (checks.empty()) return;
  const auto failed = std::count_if(checks.begin(), checks.end(), [](const CheckLine& check) { return !check.pass; });
  page.head("Checks: " + std::to_string(long(checks.size()) - failed) + " passed, " + std::to_string(failed) +
            " failed");
  page.begin_table();
  for (const CheckLine& check : checks)
    page.raw("<tr><td class=\"" + std::string(check.pass ? "pass\">PASS" : "fail\">FAIL") + "</td><td>" +
             escape_xml(check.name) + "</td><td class=\"n\">" + escape_xml(check.value) + "</td><td>expected " +
             escape_xml(check.expected) + "</td></tr>\n");
  page.end_table();
}

void add_summary(Page& page, const Simulation& simulation, const RunAccount& account) {
  const Model& model = simulation.model;
  const RunTotals& totals = simulation.totals;
  page.begin_table();
  page.row("blocks", std::to_string(model.shapes.size()));
  page.row("unknowns", std::to_string(model.dofs));
  page.row("joints", std::to_string(model.joints.size()));
  page.row("contacts at the end", std::to_string(model.contacts.size()));
  page.row("time reached", shown(model.time, "s"));
  page.row("steps",
           std::to_string(totals.steps) + (totals.cuts > 0 ? ", " + std::to_string(totals.cuts) + " cut" : ""));
  page.row("open–close iterations",
           std::to_string(totals.iterations) + ", at most " + std::to_string(totals.largest_iterations) + " a step");
  if (totals.failures > 0) page.row("bonds failed", std::to_string(totals.failures));
  if (totals.largest_utilisation > 0)
    page.row("highest utilisation of a bond when it was judged", significant(totals.largest_utilisation, 3));
  page.row("largest residual", significant(totals.largest_residual, 3));
  page.row("CPU time", shown(account.cpu_seconds, "s", 3) + " in " + shown(account.wall_seconds, "s", 3));
  page.end_table();
}

void add_notes(Page& page, const std::vector<std::string>& notes) {
  if (notes.empty()) return;
  page.head("Notes");
  page.raw("<ul>\n");
  for (const std::string& note : notes) page.raw("<li>" + escape_xml(note) + "</li>\n");
  page.raw("</ul>\n");
}

void add_pictures(Page& page, const std::vector<ReportPicture>& pictures) {
  if (pictures.empty()) return;
  page.head("Pictures and histories");
  // As images: each drawing has names of its own for its parts.
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const ReportPicture& picture = pictures[k];
    if (k == 1) page.raw("<div class=\"plots\">\n");  // the first is the scene
    page.raw("<figure><img alt=\"" + escape_xml(picture.caption) + "\" src=\"data:image/svg+xml;base64," +
             base64(picture.svg) + "\">");
    if (!picture.caption.empty()) page.raw("<figcaption>" + escape_xml(picture.caption) + "</figcaption>");
    page.raw("</figure>\n");
  }
  if (pictures.size() > 1) page.raw("</div>\n");
}

void add_ledger(Page& page, const Simulation& simulation) {
  const char* kinds[] = {"stored", "put in", "lost", "sum", "unexplained"};
  const Energies energies = simulation.energies();
  page.head("Energy ledger");
  page.raw("<table>\n<tr><th>term</th><th></th><th>J/m</th><th>% of the energy at hand</th></tr>\n");
  for (const EnergyTerm* term : energy_terms(simulation.plan, energies)) {
    const double value = energies.*term->value;
    page.raw("<tr><td title=\"" + escape_xml(term->meaning) + "\">" + escape_xml(term->label) +
             "</td><td class=\"quiet\">" + kinds[term->kind] + "</td><td class=\"n\">" +
             escape_xml(significant(value, 5)) + "</td><td class=\"n\">" +
             (energies.scale > 0 ? fixed(100 * value / energies.scale, 2) : "") + "</td></tr>\n");
  }
  page.end_table();
}

void add_seconds(Page& page, const RunTotals& totals, double whole) {
  page.head("CPU time by part");
  page.begin_table();
  std::vector<RunTotals::Part> parts = totals.parts;
  double rest = whole;
  for (const RunTotals::Part& part : parts) rest -= part.seconds;
  if (rest > 0) parts.push_back({"the rest: the script, other simulations of it", rest});
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
  for (const RunTotals::Part& part : parts) {
    const double share = whole > 0 ? part.seconds / whole : 0;
    page.raw("<tr><td>" + escape_xml(part.name) + "</td><td class=\"n\">" + escape_xml(shown(part.seconds, "s", 3)) +
             "</td><td class=\"n\">" + fixed(100 * share, 1) + " %</td><td><span class=\"part\" style=\"width:" +
             fixed(400 * std::clamp(share, 0., 1.), 0) + "px\"></span></td></tr>\n");
  }
  page.end_table();
}

void add_plan(Page& page, const Plan& plan) {
  page.head("What a step did");
  page.raw("<table>\n");
  for (const auto& [part, what] : plan.lines)
    page.raw("<tr><td>" + escape_xml(part) + "</td><td>" + escape_xml(what) + "</td></tr>\n");
  page.end_table();
}

void add_origin(Page& page, const Simulation& simulation, const RunAccount& account) {
  const Versions known = versions();
  page.head("Where it comes from");
  page.raw("<table>\n<tr><td>scene</td><td><code>" + escape_xml(simulation.model.scene.file) +
           "</code></td></tr>\n<tr><td>command</td><td><code>" + escape_xml(account.command_line) +
           "</code></td></tr>\n<tr><td>program</td><td>talus " + escape_xml(known.talus + " (" + known.commit) +
           ")</td></tr>\n<tr><td>state hash</td><td><code>" + hex(simulation.hash()) + "</code></td></tr>\n");
  for (const RunAccount::Restore& one : account.restores)
    page.raw("<tr><td>restored</td><td>from " + escape_xml(one.from) + " at step " + std::to_string(one.step) +
             "</td></tr>\n");
  page.raw(
      "</table>\n<p class=\"quiet\">All numbers are in run.json beside this page, the table in history.csv.</p>\n");
}

}  // namespace

std::string report_page(const Simulation& simulation, const RunAccount& account,
                        const std::vector<ReportPicture>& pictures) {
  const Scene& scene = simulation.model.scene;
  const std::string title = escape_xml(scene.title.empty() ? scene.file : scene.title);
  const bool good = account.outcome == "finished";
  Page page;
  add_summary(page, simulation, account);
  add_checks(page, account.checks);
  add_notes(page, simulation.notes);
  add_pictures(page, pictures);
  add_ledger(page, simulation);
  add_seconds(page, simulation.totals, account.cpu_seconds);
  add_plan(page, simulation.plan);
  add_origin(page, simulation, account);
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title + "</title><style>" +
         style + "</style></head><body>\n<h1>" + title + "</h1>\n<p class=\"" + (good ? "quiet" : "fail") + "\">" +
         escape_xml(account.outcome) + "</p>\n" + page.body() + "</body></html>\n";
}

}  // namespace talus
