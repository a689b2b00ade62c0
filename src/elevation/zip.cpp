// The one elevation file in a zip archive.
#include <zip.h>

#include <algorithm>
#include <cctype>

#include "elevation/readers.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

struct ArchiveCloser {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct EntryCloser {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};

bool isWanted(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const bool isHidden = name.starts_with("__macosx");
  return !isHidden && (name.ends_with(".hgt") || name.ends_with(".asc") || name.ends_with(".xyz"));
}

}  // namespace

Unpacked unpackZip(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::vector<std::byte> packed = core::readFile(file, kMostUnpackedBytes);
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(packed.data(), packed.size(), 0, &error);
  const std::unique_ptr<zip_t, ArchiveCloser> archive(
      source ? zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error) : nullptr);
  if (!archive) {
    const std::string reason = zip_error_strerror(&error);
    if (source) zip_source_free(source);
    zip_error_fini(&error);
    throw DataError(name, "zip", reason);
  }
  zip_error_fini(&error);
  std::optional<zip_uint64_t> wanted;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* entry = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), ZIP_FL_ENC_RAW);
    if (entry == nullptr || !isWanted(entry)) continue;
    if (wanted) throw DataError(name, "zip", "has several elevation files; one is read");
    wanted = static_cast<zip_uint64_t>(i);
  }
  if (!wanted) throw DataError(name, "zip", "has no .hgt, .asc or .xyz in it");
  zip_stat_t status;
  if (zip_stat_index(archive.get(), *wanted, 0, &status) != 0 || !(status.valid & ZIP_STAT_SIZE) ||
      status.size > kMostUnpackedBytes)
    throw DataError(name, "zip", "the file in it is larger than 64 MiB or tells no size");
  const std::unique_ptr<zip_file_t, EntryCloser> entry(zip_fopen_index(archive.get(), *wanted, 0));
  if (!entry) throw DataError(name, "zip", zip_strerror(archive.get()));
  Unpacked out;
  out.name = std::filesystem::path(zip_get_name(archive.get(), *wanted, ZIP_FL_ENC_RAW)).filename().string();
  out.bytes.resize(static_cast<std::size_t>(status.size));
  const zip_int64_t got = zip_fread(entry.get(), out.bytes.data(), out.bytes.size());
  std::byte more{};
  if (got != static_cast<zip_int64_t>(out.bytes.size()) || zip_fread(entry.get(), &more, 1) != 0)
    throw DataError(name, "zip", "the file in it is damaged: " + std::string(zip_file_strerror(entry.get())));
  return out;
}

}  // namespace skydrop::elevation
