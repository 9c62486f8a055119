// Decoding side by side.
#include "image/images_ahead.h"

#include <exception>
#include <mutex>

#include "core/parallel.h"

namespace umbral {

void ImagesAhead::expect(const Key& key, Decode decode) {
  const auto [entry, is_new] = entries_.try_emplace(key);
  if (!is_new) return;
  entry->second.decode = std::move(decode);
  waiting_.push_back(&entry->second);
}

void ImagesAhead::decode_expected() {
  const std::vector<Entry*> entries = std::exchange(waiting_, {});
  count_ += entries.size();
  std::mutex telling;
  parallel_for(entries.size(), [&](std::size_t i) {
    Entry& entry = *entries[i];
    try {
      entry.decoded = entry.decode();
    } catch (const std::exception&) {  // told when it is asked for, in the order of the file
      entry.decoded.reset();
    }
    entry.decode = nullptr;
    const std::lock_guard lock(telling);
    ++done_;
    if (progress_) progress_(done_, count_);
  });
}

std::optional<DecodedImage> ImagesAhead::take(const Key& key) {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return std::nullopt;
  if (found->second.decode) decode_expected();
  return std::exchange(found->second.decoded, std::nullopt);
}

}  // namespace umbral
