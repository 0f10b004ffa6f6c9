#include "script/plot_view.h"

#include <algorithm>
#include <string>
#include <vector>

#include "output/output.h"
#include "output/plot.h"
#include "output/text.h"
#include "script/lua_error.h"
#include "script/run.h"
#include "script/simulation_view.h"
#include "script/table_reader.h"

namespace talus {
namespace {

std::vector<double> numbers(const TableReader& table, const char* key) {
  lua_State* L = table.state();
  std::vector<double> values;
  if (!table.push(key)) return values;
  for (lua_Integer i = 1; i <= lua_Integer(lua_rawlen(L, -1)); ++i) {
    lua_rawgeti(L, -1, i);
    values.push_back(lua_tonumber(L, -1));
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return values;
}

Plot read_plot(const TableReader& table) {
  Plot plot;
  table.read("title", plot.title);
  table.read("x_label", plot.x_label);
  table.read("x_unit", plot.x_unit);
  table.read("y_label", plot.y_label);
  table.read("y_unit", plot.y_unit);
  table.read("log_x", plot.log_x);
  table.read("log_y", plot.log_y);
  table.read("equal", plot.equal);
  table.each("series", [&](const TableReader& entry) {
    Series series;
    entry.read("name", series.name);
    entry.read("markers", series.markers);
    entry.read("dashed", series.dashed);
    entry.read("line", series.line);
    series.x = numbers(entry, "x");
    series.y = numbers(entry, "y");
    plot.series.push_back(series);
  });
  return plot;
}

// Where the simulation writes nothing this does not either; `talus plan` makes no results.
void write(lua_State* L, const std::string& ending, const std::string& content) {
  Run& run = check_simulation(L, 1);
  if (run.writes()) write_whole(run.simulation.model.scene.output.dir + "/" + luaL_checkstring(L, 2) + ending, content);
}

int native_plot(lua_State* L) {
  write(L, ".svg", draw_plot(read_plot(TableReader(L, 3))));
  return 0;
}

int native_table(lua_State* L) {
  std::string header;
  std::vector<std::vector<double>> columns;
  TableReader(L, 3).each("columns", [&](const TableReader& entry) {
    std::string name;
    entry.read("name", name);
    header += (columns.empty() ? "" : ",") + csv_cell(name);
    columns.push_back(numbers(entry, "values"));
  });
  std::string content = header + "\n";
  for (size_t row = 0; !columns.empty() && row < columns[0].size(); ++row)
    for (size_t c = 0; c < columns.size(); ++c) {
      content += (c == 0 ? "" : ",") + shortest(columns[c][row]);
      if (c + 1 == columns.size()) content += "\n";
    }
  write(L, ".csv", content);
  return 0;
}

}  // namespace

void add_plots(lua_State* L) {
  constexpr luaL_Reg functions[] = {
      {"plot", guarded<native_plot>}, {"table", guarded<native_table>}, {nullptr, nullptr}};
  luaL_setfuncs(L, functions, 0);
}

}  // namespace talus
