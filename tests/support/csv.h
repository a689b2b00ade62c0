// Tables of the tests: a head of names, and rows of texts without quotes.
#pragma once

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace skydrop::test {

using CsvRow = std::map<std::string, std::string>;

inline std::vector<CsvRow> readCsv(const std::string& path) {
  std::ifstream file(path);
  const auto split = [](const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    }
    return cells;
  };
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> head = split(line);
  std::vector<CsvRow> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = split(line);
    CsvRow& row = rows.emplace_back();
    for (std::size_t i = 0; i < head.size() && i < cells.size(); ++i) row[head[i]] = cells[i];
  }
  return rows;
}

inline double numberIn(const CsvRow& row, const std::string& name) {
  return std::strtod(row.at(name).c_str(), nullptr);
}

}  // namespace skydrop::test
