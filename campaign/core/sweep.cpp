#include "campaign/core/sweep.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "campaign/core/parameters.hpp"
#include "solver/case/json_schema.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

/// Multiplication that stops at the largest number instead of wrapping round.
std::size_t saturating_product(std::size_t a, std::size_t b) {
  const std::size_t most = std::numeric_limits<std::size_t>::max();
  return b != 0 && a > most / b ? most : a * b;
}

std::size_t grid_size(const json& grid) {
  std::size_t size = grid.empty() ? 0 : 1;
  for (const auto& values : grid) size = saturating_product(size, values.size());
  return size;
}

std::size_t zip_size(const json& zip) { return zip.empty() ? 0 : zip.front().size(); }

void check_names(const json& named, const std::string& where, std::vector<Mistake>& mistakes) {
  std::set<std::string> seen;
  for (const auto& [name, unused] : named.items()) {
    const Parameter* parameter = find_parameter(name);
    if (!parameter) {
      Mistake mistake = unknown_key(where, name, parameter_names());
      mistake.given = "no such parameter";
      mistakes.push_back(std::move(mistake));
    } else if (!seen.insert(parameter->pointer.to_string()).second) {
      mistakes.push_back({where + "/" + name, "the same parameter under two names", "name it once"});
    }
  }
}

void check_zip(const json& zip, std::vector<Mistake>& mistakes) {
  std::string lengths;
  bool equal = true;
  for (const auto& [name, values] : zip.items()) {
    lengths += (lengths.empty() ? "" : ", ") + name + " has " + std::to_string(values.size());
    equal = equal && values.size() == zip_size(zip);
  }
  if (!equal) mistakes.push_back({"/sweep/zip", "lists of unequal length", lengths});
}

std::string pointer_of(const std::string& name) { return find_parameter(name)->pointer.to_string(); }

Point point_of(const json& values) {
  Point point;
  for (const auto& [name, value] : values.items()) point[pointer_of(name)] = value;
  return point;
}

/// Names of parameters with lists of values, by pointer: looked up once, however many points there are.
std::vector<std::pair<std::string, json>> lists_of(const json& named) {
  std::vector<std::pair<std::string, json>> lists;
  for (const auto& [name, values] : named.items()) lists.emplace_back(pointer_of(name), values);
  return lists;
}

void append_grid(const json& grid, std::vector<Point>& points) {
  const auto axes = lists_of(grid);
  for (std::size_t number = 0; number < grid_size(grid); ++number) {
    std::size_t rest = number;
    Point point;
    for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {  // the last axis runs fastest
      const auto& [pointer, values] = *axis;
      point[pointer] = values[rest % values.size()];
      rest /= values.size();
    }
    points.push_back(std::move(point));
  }
}

void append_zip(const json& zip, std::vector<Point>& points) {
  const auto lists = lists_of(zip);
  for (std::size_t i = 0; i < zip_size(zip); ++i) {
    Point point;
    for (const auto& [pointer, values] : lists) point[pointer] = values[i];
    points.push_back(std::move(point));
  }
}

}  // namespace

std::vector<Mistake> sweep_mistakes(const json& sweep) {
  std::vector<Mistake> mistakes;
  check_names(sweep.at("grid"), "/sweep/grid", mistakes);
  check_names(sweep.at("zip"), "/sweep/zip", mistakes);
  for (const char* part : {"list", "exclude"})
    for (std::size_t i = 0; i < sweep.at(part).size(); ++i)
      check_names(sweep.at(part)[i], std::string("/sweep/") + part + "/" + std::to_string(i), mistakes);
  check_zip(sweep.at("zip"), mistakes);

  const std::size_t size = grid_size(sweep.at("grid"));
  if (size > kMostCases || size + zip_size(sweep.at("zip")) + sweep.at("list").size() > kMostCases)
    mistakes.push_back(
        {"/sweep", "too many cases", "at most " + std::to_string(kMostCases) + " in one campaign"});
  return mistakes;
}

std::vector<Point> sweep_points(const json& sweep) {
  std::vector<Point> points;
  append_grid(sweep.at("grid"), points);
  append_zip(sweep.at("zip"), points);
  for (const auto& values : sweep.at("list")) points.push_back(point_of(values));
  if (points.empty()) points.emplace_back();
  return points;
}

void put(const Point& point, json& physics) {
  for (const auto& [pointer, value] : point) physics[json::json_pointer(pointer)] = value;
}

std::vector<std::string> swept_pointers(const std::vector<Point>& points) {
  std::set<std::string> pointers;
  for (const auto& point : points)
    for (const auto& [pointer, unused] : point) pointers.insert(pointer);
  return {pointers.begin(), pointers.end()};
}

}  // namespace softwall::campaign
