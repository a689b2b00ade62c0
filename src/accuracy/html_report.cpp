#include <array>
#include <span>

#include "accuracy/report_json.h"
#include "skydrop/accuracy/report.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::accuracy {
namespace {

// RFC 4648.
std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

// JSON within <script>: "<" in a text must not end it.
std::string scriptSafe(const std::string& json) {
  std::string text;
  for (const char c : json) text += c == '<' ? "\\u003c" : std::string(1, c);
  return text;
}

void replace(std::string& page, std::string_view mark, const std::string& with) {
  const std::size_t at = page.find(mark);
  if (at == std::string::npos) throw core::DataError("report/page.html", "", "has no " + std::string(mark));
  page.replace(at, mark.size(), with);
}

std::string asset(const char* name) { return core::readTextFile(core::assetPath(name)); }

}  // namespace

std::string htmlReport(const Results& results, const std::filesystem::path& folder) {
  const auto embedded = [&](const std::string& file, bool isShown) {
    if (!isShown) return file;
    return "data:image/png;base64," + base64(core::readFile(folder / file));
  };
  std::string page = asset("report/page.html");
  replace(page, "/* STYLE */", asset("report/page.css"));
  replace(page, "/* SCRIPT */", asset("report/page.js"));
  replace(page, "/* DATA */", scriptSafe(reportJson(results, embedded).dump()));
  return page;
}

}  // namespace skydrop::accuracy
