#include "skydrop/forecast/fetch.h"

#include <curl/curl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::forecast {
namespace {

constexpr const char* kKeyVariable = "SKYDROP_METEOBLUE_KEY";
constexpr std::size_t kLongestKey = 200;

bool isAlphanumeric(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string fixed(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4f", value);
  return text.data();
}

const char* usualUrl(Provider provider) {
  switch (provider) {
    case Provider::meteoblue:
      return "https://my.meteoblue.com/packages/basic-1h_clouds-1h";
    case Provider::openMeteo:
      return "https://api.open-meteo.com/v1/forecast";
    case Provider::metar:
      return "https://aviationweather.gov/api/data/metar";
  }
  return "";
}

std::string queryOf(const FetchRequest& request) {
  const std::string place =
      "latitude=" + fixed(request.latitudeDegrees) + "&longitude=" + fixed(request.longitudeDegrees);
  switch (request.provider) {
    case Provider::meteoblue:
      return "lat=" + fixed(request.latitudeDegrees) + "&lon=" + fixed(request.longitudeDegrees) +
             "&tz=GMT&format=json&timeformat=iso8601&apikey=" + request.key;
    case Provider::openMeteo:
      return place +
             "&timezone=GMT&wind_speed_unit=ms&hourly=temperature_2m,dew_point_2m,pressure_msl,wind_speed_"
             "10m,"
             "wind_direction_10m,wind_gusts_10m,precipitation,showers,snowfall,cloud_cover,cloud_cover_low,"
             "cloud_cover_mid,cloud_cover_high,visibility,weather_code,wind_speed_850hPa,wind_direction_"
             "850hPa,"
             "geopotential_height_850hPa,wind_speed_500hPa,wind_direction_500hPa,geopotential_height_500hPa,"
             "wind_speed_250hPa,wind_direction_250hPa,geopotential_height_250hPa";
    case Provider::metar:
      return "ids=" + request.station + "&format=raw&hours=24";
  }
  return "";
}

bool isOfThisMachine(std::string_view url) {
  for (const std::string_view host : {"http://127.0.0.1", "http://localhost", "http://[::1]"}) {
    if (!url.starts_with(host)) continue;
    const std::string_view rest = url.substr(host.size());
    if (rest.empty() || rest[0] == ':' || rest[0] == '/') return rest.find('@') == std::string_view::npos;
  }
  return false;
}

// Server and path, as messages name them.
std::string nameOf(const std::string& address) { return address.substr(0, address.find('?')); }

struct Transfer {
  std::string body;
  std::size_t most = 0;
  bool tooLarge = false;
  Validators validators;
  double retryAfterS = 0;
};

std::size_t takeBody(char* data, std::size_t size, std::size_t count, void* target) {
  auto& transfer = *static_cast<Transfer*>(target);
  if (size * count > transfer.most - transfer.body.size()) {
    transfer.tooLarge = true;
    return 0;
  }
  transfer.body.append(data, size * count);
  return size * count;
}

std::size_t takeHeader(char* data, std::size_t size, std::size_t count, void* target) {
  auto& transfer = *static_cast<Transfer*>(target);
  const std::string_view line(data, size * count);
  if (line.starts_with("HTTP/")) transfer.validators = {};  // of an earlier answer, that redirected
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || line.size() > 1000) return size * count;
  std::string name(line.substr(0, colon));
  std::ranges::transform(name, name.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  std::string_view value = line.substr(colon + 1);
  while (!value.empty() && (value.front() == ' ' || value.front() == '\t')) value.remove_prefix(1);
  while (!value.empty() && (value.back() == '\r' || value.back() == '\n' || value.back() == ' '))
    value.remove_suffix(1);
  if (name == "etag") transfer.validators.etag = value;
  if (name == "last-modified") transfer.validators.lastModified = value;
  if (name == "retry-after") {
    int seconds = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), seconds);
    if (error == std::errc() && end == value.data() + value.size()) transfer.retryAfterS = seconds;
  }
  return size * count;
}

struct Handle {
  CURL* curl = curl_easy_init();
  CURLM* multi = curl_multi_init();
  curl_slist* headers = nullptr;

  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    curl_multi_remove_handle(multi, curl);
    curl_slist_free_all(headers);
    curl_easy_cleanup(curl);
    curl_multi_cleanup(multi);
  }
  // A header, unless what a file of the cache gave it cannot be one.
  void add(const std::string& name, const std::string& value) {
    if (value.empty() || value.find_first_of("\r\n") != std::string::npos) return;
    headers = curl_slist_append(headers, (name + ": " + value).c_str());
  }
};

struct Outcome {
  long status = 0;  // of HTTP; 0: there was no answer
  std::string failure;
};

long milliseconds(double seconds) { return static_cast<long>(seconds * 1000); }

// curl_easy_perform() that a request to stop ends at once.
CURLcode perform(const Handle& handle, const std::stop_token& stop) {
  if (curl_multi_add_handle(handle.multi, handle.curl) != CURLM_OK) return CURLE_FAILED_INIT;
  const std::stop_callback wake(stop, [&handle] { curl_multi_wakeup(handle.multi); });
  constexpr int kLongestWaitMs = 1000;
  for (int running = 1; running > 0;) {
    if (stop.stop_requested()) {
#if LIBCURL_VERSION_NUM >= 0x075700
      curl_easy_setopt(handle.curl, CURLOPT_QUICK_EXIT, 1L);  // waits for no look-up of a name
#endif
      return CURLE_ABORTED_BY_CALLBACK;
    }
    if (curl_multi_perform(handle.multi, &running) != CURLM_OK) return CURLE_FAILED_INIT;
    if (running > 0) curl_multi_poll(handle.multi, nullptr, 0, kLongestWaitMs, nullptr);
  }
  int left = 0;
  const CURLMsg* done = curl_multi_info_read(handle.multi, &left);
  return done ? done->data.result : CURLE_FAILED_INIT;
}

Outcome attempt(const std::string& address, const Validators& known, const FetchLimits& limits,
                const std::stop_token& stop, Transfer& transfer) {
  Handle handle;
  if (!handle.curl || !handle.multi) return {0, "libcurl cannot be started"};
  CURL* curl = handle.curl;
  std::array<char, CURL_ERROR_SIZE> reason{};
  handle.add("If-None-Match", known.etag);
  if (known.etag.empty()) handle.add("If-Modified-Since", known.lastModified);
  const char* protocols = isOfThisMachine(address) ? "http,https" : "https";
  curl_easy_setopt(curl, CURLOPT_URL, address.c_str());
  curl_easy_setopt(curl, CURLOPT_PROTOCOLS_STR, protocols);
  curl_easy_setopt(curl, CURLOPT_REDIR_PROTOCOLS_STR, protocols);
  curl_easy_setopt(curl, CURLOPT_FOLLOWLOCATION, 1L);
  curl_easy_setopt(curl, CURLOPT_MAXREDIRS, static_cast<long>(limits.redirects));
  curl_easy_setopt(curl, CURLOPT_SSL_VERIFYPEER, 1L);
  curl_easy_setopt(curl, CURLOPT_SSL_VERIFYHOST, 2L);
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT_MS, milliseconds(limits.connectS));
  curl_easy_setopt(curl, CURLOPT_TIMEOUT_MS, milliseconds(limits.totalS));
  curl_easy_setopt(curl, CURLOPT_LOW_SPEED_LIMIT, 1L);
  curl_easy_setopt(curl, CURLOPT_LOW_SPEED_TIME, std::max(1L, static_cast<long>(limits.stallS)));
  curl_easy_setopt(curl, CURLOPT_ACCEPT_ENCODING, "gzip, deflate");
  curl_easy_setopt(curl, CURLOPT_USERAGENT, "skydrop");
  curl_easy_setopt(curl, CURLOPT_ERRORBUFFER, reason.data());
  curl_easy_setopt(curl, CURLOPT_HTTPHEADER, handle.headers);
  curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, takeBody);
  curl_easy_setopt(curl, CURLOPT_WRITEDATA, &transfer);
  curl_easy_setopt(curl, CURLOPT_HEADERFUNCTION, takeHeader);
  curl_easy_setopt(curl, CURLOPT_HEADERDATA, &transfer);
  transfer.most = limits.bytes;
  const CURLcode code = perform(handle, stop);
  Outcome outcome;
  if (code == CURLE_OK) {
    curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &outcome.status);
    return outcome;
  }
  if (transfer.tooLarge)
    outcome.failure = "sends more than " + std::to_string(limits.bytes) + " bytes";
  else
    outcome.failure = reason[0] != 0 ? reason.data() : curl_easy_strerror(code);
  // What will not pass by waiting is told from the rest by its status.
  const bool isFinal = transfer.tooLarge || code == CURLE_TOO_MANY_REDIRECTS ||
                       code == CURLE_UNSUPPORTED_PROTOCOL || code == CURLE_PEER_FAILED_VERIFICATION ||
                       code == CURLE_BAD_CONTENT_ENCODING || code == CURLE_URL_MALFORMAT;
  outcome.status = isFinal ? 400 : 0;
  return outcome;
}

void pauseFor(double seconds, const std::stop_token& stop) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any().wait_for(lock, stop, std::chrono::duration<double>(seconds),
                                         [] { return false; });
}

// Nothing of a key is left of what is said.
std::string withoutKey(std::string text, const std::string& key) {
  for (std::size_t at = 0; !key.empty() && (at = text.find(key, at)) != std::string::npos;)
    text.replace(at, key.size(), "(key)");
  return text;
}

}  // namespace

std::string addressOf(const FetchRequest& request) {
  const std::string url = request.url.empty() ? usualUrl(request.provider) : request.url;
  if (!url.starts_with("https://") && !isOfThisMachine(url))
    throw core::RangeError("'" + nameOf(url) + "' is neither https nor http of this machine");
  if (url.find('?') != std::string::npos || url.find('@') != std::string::npos ||
      std::ranges::any_of(url, [](char c) { return c <= ' ' || c == 0x7f; }))
    throw core::RangeError("'" + nameOf(url) + "' has more than server and path");
  if (request.provider == Provider::metar &&
      (request.station.size() != 4 || !std::ranges::all_of(request.station, isAlphanumeric)))
    throw core::RangeError("'" + request.station + "' is no station of four letters, which a METAR needs");
  if (request.provider == Provider::meteoblue && (request.key.empty() || request.key.size() > kLongestKey ||
                                                  !std::ranges::all_of(request.key, isAlphanumeric)))
    throw core::RangeError("meteoblue needs a key of letters and digits");
  return url + "?" + queryOf(request);
}

Fetched fetch(const FetchRequest& request, const Validators& known, const FetchLimits& limits,
              const std::stop_token& stop) {
  static std::once_flag started;
  std::call_once(started, [] { curl_global_init(CURL_GLOBAL_DEFAULT); });
  const std::string address = addressOf(request);
  const auto fail = [&](const std::string& reason) {
    throw core::DataError(nameOf(address), "", withoutKey(reason, request.key));
  };
  double wait = limits.backOffS;
  for (int tries = 1;; ++tries) {
    Transfer transfer;
    const Outcome outcome = attempt(address, known, limits, stop, transfer);
    if (stop.stop_requested()) fail("was not waited for");
    if (outcome.failure.empty() && outcome.status == 200)
      return {std::move(transfer.body), std::move(transfer.validators), false};
    if (outcome.failure.empty() && outcome.status == 304) return {{}, known, true};
    const bool mayPass = outcome.status == 0 || outcome.status == 429 || outcome.status >= 500;
    if (!mayPass || tries >= limits.attempts) {
      const std::string said =
          outcome.failure.empty() ? "answers with status " + std::to_string(outcome.status) : outcome.failure;
      fail(tries > 1 ? said + " (" + std::to_string(tries) + " attempts)" : said);
    }
    const double pause = std::min(std::max(wait, transfer.retryAfterS), limits.longestBackOffS);
    pauseFor(pause, stop);
    if (stop.stop_requested()) fail("was not waited for");
    wait *= 2;
  }
}

std::string readKey(const std::optional<std::filesystem::path>& file) {
  std::string key;
  if (file) {
    struct stat status {};
    if (::stat(file->c_str(), &status) == 0 && (status.st_mode & (S_IRWXG | S_IRWXO)) != 0)
      throw core::DataError(file->string(), "", "may be read by others than its owner: chmod 600");
    key = core::readTextFile(*file, 4096);
    key = key.substr(0, key.find_first_of("\r\n"));
  } else if (const char* variable = std::getenv(kKeyVariable)) {
    key = variable;
  }
  if (key.empty())
    throw core::DataError(file ? file->string() : kKeyVariable, "",
                          file ? "holds no key" : "is not set, and no file with a key is named");
  if (key.size() > kLongestKey || !std::ranges::all_of(key, isAlphanumeric))
    throw core::DataError(file ? file->string() : kKeyVariable, "",
                          "holds something else than letters and digits");
  return key;
}

}  // namespace skydrop::forecast
