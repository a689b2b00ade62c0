#include "skydrop/forecast/kept_answers.h"

#include <array>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/json.h"
#include "skydrop/forecast/forecast_of.h"
#include "skydrop/forecast/read_report.h"

namespace skydrop::forecast {
namespace {

constexpr int kSchema = 1;

std::string hexText(std::uint64_t value) {
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(value));
  return digits.data();
}

std::filesystem::path fileOf(const std::filesystem::path& folder, const FetchRequest& request) {
  std::array<char, 64> place{};
  std::snprintf(place.data(), place.size(), "%.4f %.4f ", request.latitudeDegrees, request.longitudeDegrees);
  const std::string name(kProviderNames[static_cast<std::size_t>(request.provider)]);
  return folder / (name + "-" + hexText(contentDigest(place.data() + request.station + " " + request.url)));
}

std::filesystem::path noteOf(std::filesystem::path file) { return file += ".about.json"; }

void writeNote(const KeptAnswer& kept, std::uint64_t digest) {
  const nlohmann::ordered_json note = {{"schema", kSchema},
                                       {"fetched", sky::instantText(kept.fetched)},
                                       {"digest", hexText(digest)},
                                       {"etag", kept.validators.etag},
                                       {"lastModified", kept.validators.lastModified}};
  core::writeFileAtomically(noteOf(kept.file),
                            note.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace

std::optional<KeptAnswer> keptAnswer(const std::filesystem::path& folder, const FetchRequest& request) {
  KeptAnswer kept;
  kept.file = fileOf(folder, request);
  std::error_code error;
  if (!std::filesystem::exists(kept.file, error) || !std::filesystem::exists(noteOf(kept.file), error))
    return std::nullopt;
  try {
    const std::string name = noteOf(kept.file).string();
    const nlohmann::json note = core::readJson(noteOf(kept.file));
    const auto text = [&](const char* member) {
      return core::jsonText(note.value(member, nlohmann::json()), name, member);
    };
    const std::string digest = hexText(contentDigest(core::readTextFile(kept.file, kMostBytes)));
    if (text("digest") != digest || !sky::readInstant(text("fetched"), kept.fetched).empty())
      return std::nullopt;
    kept.validators = {text("etag"), text("lastModified")};
  } catch (const std::exception&) {
    return std::nullopt;  // damaged: it is fetched again
  }
  return kept;
}

KeptAnswer renew(const std::filesystem::path& folder, const FetchRequest& request, sky::Instant now,
                 const FetchLimits& limits, const std::stop_token& stop) {
  const std::optional<KeptAnswer> before = keptAnswer(folder, request);
  Fetched fetched = fetch(request, before ? before->validators : Validators(), limits, stop);
  KeptAnswer kept{fileOf(folder, request), now, fetched.validators};
  if (fetched.notModified) {
    const std::string body = core::readTextFile(kept.file, kMostBytes);
    writeNote(kept, contentDigest(body));
    return kept;
  }
  const std::string address = addressOf(request);
  readReport(fetched.body, address.substr(0, address.find('?')), now);
  core::makeFolder(folder);
  core::writeFileAtomically(kept.file, fetched.body);
  writeNote(kept, contentDigest(fetched.body));
  return kept;
}

}  // namespace skydrop::forecast
